// The exercises of chapter 03. The lesson is the chapter's own. Its ImageTexture is this one here,
// which calls the student's functions.
#include <set>

#include "exercise.hpp"
#include "exercises.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_03 {

using check::Bytes;
static std::function<int(double, int)> column_of, row_of;
static std::function<Rgb(const Bytes&, int, int, int)> color_of;

struct ImageTexture {
  Image image;

  Rgb operator()(const Uv<double>& uv) const {
    auto [column, row] =
        texel_place(uv, image.width, image.height, VAxis::up, TexelRounding::floor);
    if (column_of) column = column_of(uv.u, image.width);
    if (row_of) row = row_of(uv.v, image.height);
    if (column < 0 || column >= image.width || row < 0 || row >= image.height) return {};
    if (color_of) return color_of(Bytes{image}, image.width, column, row);
    const Rgb8& texel = image.at(column, row);
    return {texel.r / 255.0, texel.g / 255.0, texel.b / 255.0};
  }
};

}  // namespace texmap::chapter_03

#include "03_image_texture/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_03;

Image& map_of(Lesson& lesson) {
  return std::get<Textured>(lesson.objects[middle].paint).texture.image;
}

/// Draws the globe from near by. With few texels one can count them.
std::function<Image()> globe(int columns) {
  return [=] {
    auto lesson = prepared<Lesson>();
    Image& map = map_of(lesson);
    Image small(columns, columns / 2);
    const int step = map.width / columns;
    for (int i = 0; i < columns * small.height; ++i) {
      const int column = i % columns, row = i / columns;
      small.at(column, row) = map.at(column * step + step / 2, row * step + step / 2);
    }
    map = small;
    return picture_of(lesson, 18);
  };
}

constexpr auto half_a_texel =
    "the nearest whole number shifts the map by half a texel: cut off the decimals";

/// The table with each number as students limit it to the n texels that there are, or do not:
/// those who make another mistake often forget the ends, too.
Slips<int> limited(const Slips<int>& table, int n) {
  Slips<int> wrong = changed(table, [&](int x) { return clamp(x, 0, n - 1); });
  wrong += table;
  wrong += changed(table, [&](int x) { return clamp(x, 0, n); });
  wrong += changed(table, [&](int x) { return min(x, n - 1); });
  return wrong += changed(table, [&](int x) { return max(x, 0); });
}

Slips<int> wrong_columns(double u, int n) {
  const int c = cut_off(u * n);
  const Slips<int> table = {
      {"multiply by width, not by width - 1: now the last column is at u = 1 alone",
       {cut_off(u * (n - 1)), rounded(u * (n - 1))}},
      {half_a_texel, {rounded(u * n), cut_off(u * n + 0.5)}},
      {"the columns are numbered from 0: yours is one too far right", c + 1},
      {"u * width without its decimals is the number: yours is one too far left", c - 1},
      {"std::ceil rounds up: static_cast<int>(u * width) cuts off the decimals",
       cut_off(ceil(u * n))},
      {"u runs the other way: your map is mirrored", {n - 1 - c, cut_off((1 - u) * n), n - c}},
      {"the decimals are cut off too early: it is static_cast<int>(u * width), the product",
       {cut_off(u) * n, cut_off(u) * (n - 1)}},
      {"this is column 0 everywhere: multiply u by width, and limit it to 0 and width - 1",
       cut_off(u / n)},
  };
  return {
      limited(table, n),
      {"nothing limits the number: at u = 1 it is width, one too many", c},
      {"the number can be less than 0: limit it there, too", min(c, n - 1)},
      {"the number can be less than 0: limit it there; std::abs makes another column of it",
       min(abs(c), n - 1)},
      {"at u = 1 the number is width, one too many: limit it to width - 1",
       {max(c, 0), cut_off(clamp(u, 0.0, 1.0) * n), clamp(c, 0, n), min(c, n),
        u > 1 ? n - 1 : max(c, 0), u > 1 ? n - 1 : c}},
      {"you have u = 1, but a u above 1 goes on: std::clamp(column, 0, width - 1) limits all",
       {u == 1 ? n - 1 : c, u == 1 ? n - 1 : max(c, 0)}},
      {"beyond the ends you begin again at the other end: std::clamp(column, 0, width - 1) stays",
       {c % n, (c % n + n) % n, max(c % n, 0), abs(c) % n, cut_off(fraction(u) * n)}},
      {"this is the last column for every u: std::min(column, width - 1) limits it, not std::max",
       n - 1},
  };
}

int right_column(double u, int n) { return texel_number(u, n, TexelRounding::floor); }
constexpr Place<double, int> column_of_places[] = {
    {"of 8 columns, u = 0.4 is in number 3", {0.4, 8}},
    {"u = 0 is in the first column, number 0", {0.0, 8}},
    {"of 2048 columns, u = 1/4 is in number 512", {0.25, 2048}},
    {"of 10 columns, u = 0.06 is in number 0", {0.06, 10}},
    {"of 10 columns, u = 0.38 is in number 3", {0.38, 10}},
    {"of 10 columns, u = 0.96 is in number 9", {0.96, 10}},
    {"of 8 columns, u = 1 is in the last one, number 7", {1.0, 8}},
    {"of 8 columns, a u above 1 gives the last one, number 7", {1.3, 8}},
    {"a u below 0 gives the first column, number 0", {-0.2, 8}},
};

Slips<int> wrong_rows(double v, int n) {
  const int up = cut_off(v * n);
  const int down = cut_off((1 - v) * n);
  const int row = n - 1 - up;
  const double inside = clamp(v, 0.0, 1.0);
  const auto last = [&](int x) { return clamp(x, 0, n - 1); };
  const Slips<int> table = {
      {"you count from below, and the file from the top: your map is upside down",
       {up, cut_off(v * (n - 1))}},
      {"multiply by height, not by height - 1: now one row is at an end of v alone",
       {n - 1 - cut_off(v * (n - 1)), cut_off((1 - v) * (n - 1)), n - 1 - rounded(v * (n - 1)),
        rounded((1 - v) * (n - 1))}},
      {"the last row is height - 1: you forgot the - 1, and yours is one too far down",
       {n - up, n - last(up), n - clamp(up, 0, n)}},
      {half_a_texel, {n - 1 - rounded(v * n), n - 1 - last(rounded(v * n)), rounded((1 - v) * n)}},
      {"yours is one too far up: the row is height - 1 minus v * height without its decimals",
       {down - 1, row - 1, cut_off(n - 1 - v * n)}},
      {"the decimals are cut off too early: it is static_cast<int>(v * height), the product",
       {n - 1 - cut_off(v) * n, cut_off(1 - v) * n, n - 1 - last(cut_off(v) * n)}},
      {"C++ reads 1 - v * height as 1 - (v * height): write (1 - v) * height", cut_off(1 - v * n)},
  };
  return {
      limited(table, n),
      {"nothing limits the number: at v = 1 it is -1, and there is no such row", row},
      {"nothing limits the number: at v = 0 it is height, and there is no such row", down},
      {"the number can be more than height - 1: limit it to height - 1",
       {max(row, 0), max(down, 0), cut_off((1 - inside) * n), clamp(row, 0, n), clamp(down, 0, n)}},
      {"the number can be less than 0, at v = 1: limit it to 0 there",
       {min(row, n - 1), min(down, n - 1), n - 1 - cut_off(inside * n), n - 1 - clamp(up, 0, n)}},
      {"you have v = 1, but a v above 1 or below 0 goes on: std::clamp limits them all",
       v == 1 ? 0 : row},
      {"beyond the ends you begin again at the other end: std::clamp stays in the last row there",
       {n - 1 - up % n, row % n, (n + row) % n, down % n, n - 1 - cut_off(fraction(v) * n)}},
  };
}

constexpr Place<double, int> row_of_places[] = {
    {"of 4 rows, v = 0.8 is in the top row, number 0", {0.8, 4}},
    {"of 4 rows, v = 0.6 is in number 1, below the top row", {0.6, 4}},
    {"of 4 rows, v = 0 is in the bottom row, number 3", {0.0, 4}},
    {"of 1024 rows, the Sahara at v = 0.63 is in number 378", {0.63, 1024}},
    {"of 10 rows, v = 0.06 is in number 9", {0.06, 10}},
    {"of 10 rows, v = 0.12 is in number 8", {0.12, 10}},
    {"of 10 rows, v = 0.38 is in number 6", {0.38, 10}},
    {"v = 1 is in the top row, number 0", {1.0, 4}},
    {"a v above 1 gives the top row, number 0", {1.3, 4}},
    {"of 4 rows, a v below 0 gives the bottom row, number 3", {-0.3, 4}},
};

/// The color whose red, green and blue have these numbers.
Rgb color_from(const Bytes& b, int red, int green, int blue, double divisor) {
  return {b[red] / divisor, b[green] / divisor, b[blue] / divisor};
}

Slips<Rgb> wrong_texels(const Bytes& b, int w, int column, int row) {
  const int i = 3 * (row * w + column);
  const auto whole = [&](int k) { return floor(b[k] / 255.); };
  Slips<Rgb> wrong = {
      {"a channel goes from 0 to 1: divide the byte by 255.0", color_from(b, i, i + 1, i + 2, 1)},
      {"whole numbers are divided without decimals: divide by 255.0",
       {whole(i), whole(i + 1), whole(i + 2)}},
      {"the largest byte is 255: divide by 255, not by 256, or white is gray",
       color_from(b, i, i + 1, i + 2, 256)},
  };
  // Those who make another mistake often divide by another number, too.
  for (const double divisor : {255.0, 256.0, 1.0}) {
    const auto rgb = [&](int red, int green, int blue) {
      return color_from(b, i + red, i + green, i + blue, divisor);
    };
    const auto from = [&](int k) { return color_from(b, k, k + 1, k + 2, divisor); };
    wrong += {
        {"red and blue are exchanged: the first byte of a texel is red", rgb(2, 1, 0)},
        {"green comes after red, and blue last: + 0, + 1 and + 2", {rgb(0, 2, 1), rgb(1, 0, 2)}},
        {"all three channels have the same byte: green is at + 1, blue at + 2", rgb(0, 0, 0)},
        {"the three bytes of a texel follow each other: + 0, + 1 and + 2", rgb(0, 3, 6)},
        {"you count texels, and each texel has three bytes: multiply by 3", from(i / 3)},
        {"only the column is multiplied by 3: each texel of the rows above has three bytes, too",
         from(row * w + 3 * column)},
        {"only the row is multiplied by 3: each texel to the left has three bytes, too",
         {from(3 * row * w + column), from(row * (3 * w + column))}},
        {"column and row are exchanged: before the texel there are row whole rows",
         {from(3 * (column * w + row)), from(column * w + row)}},
        {"before the texel there are row whole rows, each of width texels: row * width + column",
         {from(3 * (row + column)), from(3 * row + column), from(3 * row * column),
          from(i - 3 * row), from(i + 3 * row)}},
        {"bytes are counted from 0: yours begins one byte too late", from(i + 1)},
        {"bytes are counted from 0: yours begins one byte too early", from(i - 1)},
        {"columns are counted from 0: this is the texel to the right", from(i + 3)},
        {"columns are counted from 0: this is the texel to the left", from(i - 3)},
        {"rows are counted from 0: this is the row above", from(i - 3 * w)},
        {"a texel has three bytes here, not four", from(4 * (row * w + column))},
    };
  }
  return wrong;
}

/// The share of the map's texels that the chapter's picture reads, in percent.
double texels_read() {
  auto lesson = prepared<Lesson>();
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  std::set<int> read;
  color_of = [&](const Bytes&, int width, int column, int row) {
    read.insert(row * width + column);
    return white;
  };
  for (int i = 0; i < 800 * 600; ++i) {
    const int row = i / 800;
    static_cast<void>(lesson(ray_through<double>(view, i % 800, row)));
  }
  color_of = nullptr;
  return 100. * double(read.size()) / double(map_of(lesson).pixels.size());
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  // 5 x 2 texels, all bytes different; some of them are 0 and 255.
  static const Image image = [] {
    Image made(5, 2);
    made.pixels = {{255, 0, 51},    {10, 20, 30},    {40, 60, 80},    {90, 102, 110},
                   {120, 140, 160}, {170, 180, 190}, {200, 210, 220}, {240, 245, 235},
                   {204, 230, 250}, {5, 15, 25}};
    return made;
  }();
  static const Bytes bytes(image);
  static const Place<Bytes, int, int, int> color_of_places[] = {
      {"the first texel, 255 0 51, is (1, 0, 0.2)", {bytes, 5, 0, 0}},
      {"the right neighbor of the first texel begins three bytes later", {bytes, 5, 1, 0}},
      {"the second row begins after the 5 texels of the first row", {bytes, 5, 0, 1}},
      {"the fourth texel of the second row is 204 230 250", {bytes, 5, 3, 1}},
  };
  static const ExercisesOfChapter chapter{
      "03",
      {exercise(column_of, globe(32), {right_column, wrong_columns, column_of_places}),
       exercise(row_of, globe(32),
                {[](double v, int n) {
                   return texel_place(Uv<double>{0, v}, 1, n, VAxis::up, TexelRounding::floor).row;
                 },
                 wrong_rows, row_of_places}),
       exercise(color_of, globe(512),
                {[](const Bytes& b, int width, int column, int row) {
                   const int first = 3 * (row * width + column);
                   return color_from(b, first, first + 1, first + 2, 255);
                 },
                 wrong_texels, color_of_places})},
      {{"Berlin is at longitude 13.4 degrees east. In which of the map's 2048 columns is it?",
        [] { return double(texel_number((180 + 13.4) / 360, 2048, TexelRounding::floor)); }, "", 0},
       {"The map has 2048 x 1024 texels. What percentage of them does the chapter's picture read, "
        "with one ray a pixel?",
        texels_read, "percent", 0.05}},
  };
  return chapter;
}

}  // namespace texmap::check
