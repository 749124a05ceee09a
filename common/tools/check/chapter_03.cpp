// The exercises of chapter 03. The lesson is the chapter's own. Its ImageTexture is this one here,
// which calls the student's functions.
#include <set>

#include "exercise.hpp"
#include "exercises.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_03 {

using check::Bytes;
static std::function<int(double, int, double, double)> column_of;
static std::function<int(double, int, int)> row_of;
static std::function<Rgb(const Bytes&, int, int, int)> color_of;

constexpr double west = 0.125, east = 0.375;  // of the picture that is cut out of the map

struct ImageTexture {
  Image image;

  Rgb operator()(const Uv<double>& uv) const {
    auto [column, row] =
        texel_place(uv, image.width, image.height, VAxis::up, TexelRounding::floor);
    if (column_of) column = column_of(uv.u, image.width, west, east);
    if (row_of) row = row_of(uv.v, image.height / 2, 1);
    if (column < 0 || column >= image.width || row < 0 || row >= image.height) return {};
    if (color_of) return color_of(Bytes{image}, Bytes::row_bytes(image), column, row);
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

/// Draws the globe from near by, with a map so wide of which these columns are left, below so many
/// white pictures. With few texels one can count them.
std::function<Image()> globe(int columns, int first = 0, int behind = 0, int above = 0) {
  return [=] {
    auto lesson = prepared<Lesson>();
    Image& map = map_of(lesson);
    const int width = behind > 0 ? behind - first : columns, height = columns / 2;
    const int step = map.width / columns;
    map = image_of(width, height * (above + 1), [&](int column, int row) {
      if (row < height * above) return Rgb8{255, 255, 255};
      return map.at((column + first) * step + step / 2, (row - height * above) * step + step / 2);
    });
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

Slips<int> wrong_columns(double u, int n, double left, double right) {
  const double wide = right - left;
  const double x = (u - left) / wide;  // 0 to 1 in the picture
  const int c = cut_off(x * n);
  const Slips<double> places = {
      {"it is (u - west) / (east - west) * width",
       {{"this is that of a whole map", u * n},
        {"you do not subtract west", {u / wide * n, u / right * n}},
        {"you do not divide by east - west",
         {(u - left) * n, (u - left) * wide * n, (u - left) / right * n,
          (u - left) / (1 - left) * n}},
        {"/ comes before -",
         {(u - left / wide) * n, ((u - left) / right - left) * n, (u - left / right - left) * n}},
        {"with width - 1 the last one is at u = east alone", {x * (n - 1), round(x * (n - 1))}}}},
      {half_a_texel, {round(x * n), x * n + 0.5}},
      {"one too far right: columns are numbered from 0", {x * n + 1, ceil(x * n)}},
      {"yours is one too far left: cut off the decimals, no more", {c - 1., ceil(x * n) - 1}},
      {"the picture is mirrored: column 0 is at west", {n - 1. - c, (1 - x) * n, 1. * n - c}},
      {"decimals are cut off too early: multiply by width", {trunc(x) * n, trunc(x) * (n - 1)}},
      {"this is column 0 everywhere: take (u - west) / (east - west) * width, limited", x / n},
  };
  return {
      limited(changed(places, cut_off), n),
      {"nothing limits the number: at u = east it is width, one too many", c},
      {"the number can be less than 0: limit it there, too", {min(c, n - 1), min(abs(c), n - 1)}},
      {"at u = east the number is width, one too many: limit it to width - 1",
       {max(c, 0), cut_off(clamp(x, 0.0, 1.0) * n), clamp(c, 0, n), min(c, n)}},
      {"std::clamp(column, 0, width - 1) limits all",
       {{"a u beyond east goes on", {u == right ? n - 1 : c, u == right ? n - 1 : max(c, 0)}},
        {"outside of the picture it is the column at the nearer end",
         {u < left || u > right ? -1 : min(c, n - 1), u < left || u > right ? 0 : min(c, n - 1)}},
        {"beyond the ends you begin again at the other end",
         {c % n, (c % n + n) % n, max(c % n, 0), abs(c) % n, cut_off(fraction(x) * n)}},
        {"std::max makes it the last column for every u", n - 1}}},
  };
}

int right_column(double u, int n, double left, double right) {
  return texel_number((u - left) / (right - left), n, TexelRounding::floor);
}
constexpr Place<double, int, double, double> column_of_places[] = {
    {"8 columns from u = 1/4 to 3/4: u = 0.45 is in number 3", {0.45, 8, 0.25, 0.75}},
    {"u = west is in the first column, number 0", {0.25, 8, 0.25, 0.75}},
    {"8 columns from u = 0.5 to 1: u = 0.95 is in number 7", {0.95, 8, 0.5, 1}},
    {"100 columns from u = 0.2 to 0.6: u = 0.45 is in number 62", {0.45, 100, 0.2, 0.6}},
    {"a whole map, 0 to 1, of 10 columns: u = 0.38 is in number 3", {0.38, 10, 0, 1}},
    {"10 columns from u = 0.5 to 0.7: u = 0.512 is in number 0", {0.512, 10, 0.5, 0.7}},
    {"the same picture: u = 0.693 is in number 9", {0.693, 10, 0.5, 0.7}},
    {"8 columns from u = 1/4 to 3/4: u = 3/4 is in the last one, number 7", {0.75, 8, 0.25, 0.75}},
    {"8 columns from u = 1/4 to 3/4: u = 1/2 is the left edge of number 4", {0.5, 8, 0.25, 0.75}},
    {"right of the picture it is the last one, number 7", {0.9, 8, 0.25, 0.75}},
    {"left of the picture it is the first one, number 0", {0.1, 8, 0.25, 0.75}},
    {"also where the other end is nearer around the back: 99 of 100", {0.95, 100, 0.2, 0.6}},
};

Slips<int> wrong_in_picture(double v, int n) {
  const double part = 1 - v;
  const int up = cut_off(v * n), down = cut_off(part * n), row = n - 1 - up;
  const auto last = [&](int x) { return clamp(x, 0, n - 1); };
  const Slips<int> table = {
      {"the file counts rows from the top: your map is upside down", {up, cut_off(v * (n - 1))}},
      {"multiply by height, not by height - 1: now one row is at an end of v alone",
       {n - 1 - cut_off(v * (n - 1)), cut_off(part * (n - 1)), n - 1 - rounded(v * (n - 1)),
        rounded(part * (n - 1))}},
      {"the last row is height - 1: you forgot the - 1, and yours is one too far down",
       {n - up, n - last(up), n - clamp(up, 0, n)}},
      {half_a_texel, {n - 1 - rounded(v * n), n - 1 - last(rounded(v * n)), rounded(part * n)}},
      {"yours is one too far up: the row is height - 1 minus v * height without its decimals",
       {down - 1, row - 1, cut_off(n - 1 - v * n)}},
      {"the decimals are cut off too early: it is static_cast<int>(v * height), the product",
       {n - 1 - cut_off(v) * n, cut_off(part) * n, n - 1 - last(cut_off(v) * n)}},
      {"C++ reads 1 - v * height as 1 - (v * height): write (1 - v) * height", cut_off(1 - v * n)},
  };
  return limited(table, n);
}

int right_row(double v, int n, int picture) {
  const Uv<double> uv{0, v};
  return picture * n + texel_place(uv, 1, n, VAxis::up, TexelRounding::floor).row;
}

Slips<int> wrong_rows(double v, int n, int picture) {
  const int row = right_row(v, n, 0), above = picture * n;
  return {
      changed(wrong_in_picture(v, n), [=](int r) { return above + r; }),
      {"there are picture * height rows above",
       {{"the pictures above are missing", row},
        {"above picture 1 there is one picture", {above + n + row, above - n + row}},
        {"each picture has height rows, not one", row + picture}}},
      {"limit the row before you add those above", clamp(above + n - 1 - cut_off(v * n), 0, n - 1)},
      {"the pictures follow each other downward: only the rows in a picture are turned around",
       {row - above, n - 1 - clamp(cut_off(v * n) + above, 0, n - 1)}},
  };
}

std::string at_the_ends(double v, int /*n*/, int /*picture*/) {
  return v > 0 && v < 1 ? ""
                        : "from v = 1 on it is the picture's top row, up to v = 0 the bottom "
                          "one: limit the number before you add those above";
}
constexpr Place<double, int, int> row_of_places[] = {
    {"of 4 rows, v = 0.8 is in the top row: in picture 0 that is number 0", {0.8, 4, 0}},
    {"in picture 1 it is number 4", {0.8, 4, 1}},
    {"of 4 rows, v = 0.6 is below the top row: in picture 2 that is number 9", {0.6, 4, 2}},
    {"of 4 rows, v = 0 is in the bottom row: in picture 1 that is number 7", {0.0, 4, 1}},
    {"of 1024 rows, the Sahara at v = 0.63 is in number 378", {0.63, 1024, 0}},
    {"of 10 rows, v = 0.06 is in number 9", {0.06, 10, 0}},
    {"of 10 rows, v = 0.12 is in number 8, in picture 3 in number 38", {0.12, 10, 3}},
    {"of 10 rows, v = 0.38 is in number 6", {0.38, 10, 0}},
    {"v = 1 is in the top row: in picture 1 that is number 4", {1.0, 4, 1}},
    {"a v above 1 gives the picture's top row", {1.3, 4, 2}},
    {"a v below 0 gives the picture's bottom row", {-0.3, 4, 1}},
};

/// The color whose red, green and blue have these numbers.
Rgb color_from(const Bytes& b, int red, int green, int blue, double divisor) {
  return {b[red] / divisor, b[green] / divisor, b[blue] / divisor};
}

Slips<Rgb> wrong_texels(const Bytes& b, int row_bytes, int column, int row) {
  const int i = row * row_bytes + 3 * column;
  const auto whole = [&](int k) { return floor(b[k] / 255.); };
  Slips<Rgb> wrong = {
      {"a channel goes from 0 to 1: divide the byte by 255.0", color_from(b, i + 2, i + 1, i, 1)},
      {"whole numbers have no decimals: divide by 255.0", {whole(i + 2), whole(i + 1), whole(i)}},
      {"divide by 255, not by 256, or white is gray", color_from(b, i + 2, i + 1, i, 256)},
  };
  // Those who make another mistake often divide by another number, or take red first, too.
  for (const double divisor : {255.0, 256.0, 1.0}) {
    const auto rgb = [&](int red, int green, int blue) {
      return color_from(b, i + red, i + green, i + blue, divisor);
    };
    wrong += {
        {"the first byte of a texel is blue here: red is the third one", rgb(0, 1, 2)},
        {"red is at + 2, green at + 1, blue at + 0",
         {{"blue comes first, red last", {rgb(2, 0, 1), rgb(1, 2, 0), rgb(1, 0, 2), rgb(0, 2, 1)}},
          {"all three channels have the same byte", {rgb(0, 0, 0), rgb(2, 2, 2)}},
          {"the three bytes of a texel follow each other",
           {rgb(6, 3, 0), rgb(2 * row_bytes, row_bytes, 0),
            rgb(2 * row_bytes - 2 * column, row_bytes - 2 * column, -2 * column)}}}},
    };
    for (const int red : {2, 0}) {
      const auto from = [&](int k) { return color_from(b, k + red, k + 1, k + 2 - red, divisor); };
      const int size = row_bytes / 3;  // of a row, in texels
      wrong += {
          {"a texel begins at row * row_bytes + 3 * column",
           {{"a texel has three bytes, not one or four", {from(i - 2 * column), from(i + column)}},
            {"row_bytes counts bytes, and not texels",
             {from(3 * (row * row_bytes + column)), from(3 * row * row_bytes + column)}},
            {"row is not multiplied by row_bytes",
             {from(3 * (row * size + column)), from(3 * row + 3 * column), from(3 * (row * column)),
              from(row + 3 * column), from(row_bytes + 3 * column), from(3 * column)}},
            {"column and row are exchanged",
             {from(column * row_bytes + 3 * row), from(column * row_bytes + row)}}}},
          {"bytes, columns and rows are counted from 0",
           {{"yours begins one byte too late or too early", {from(i + 1), from(i - 1)}},
            {"this is the texel to the right or to the left", {from(i + 3), from(i - 3)}},
            {"this is the row above", from(i - row_bytes)}}},
          {"row 0 is the top row here: the rows are not turned around", from(i + row_bytes)},
      };
    }
  }
  return wrong;
}

/// The share of the map's texels that the chapter's picture reads, in percent.
double texels_read() {
  auto lesson = prepared<Lesson>();
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  std::set<int> read;
  color_of = [&](const Bytes&, int row_bytes, int column, int row) {
    read.insert(row * row_bytes + column);
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

ExercisesOfChapter all_exercises_of_chapter() {
  // 5 x 2 texels, all bytes different; some of them are 0 and 255. A row has one byte more.
  static const Image image = [] {
    Image made(5, 2);
    made.pixels = {{255, 0, 51},    {10, 20, 30},    {40, 60, 80},    {90, 102, 110},
                   {120, 140, 160}, {170, 180, 190}, {200, 210, 220}, {240, 245, 235},
                   {204, 230, 250}, {5, 15, 25}};
    return made;
  }();
  static const Bytes bytes(image);
  static const Place<Bytes, int, int, int> color_of_places[] = {
      {"the first texel has the bytes 51 0 255, so it is (1, 0, 0.2)", {bytes, 16, 0, 0}},
      {"the right neighbor of the first texel begins three bytes later", {bytes, 16, 1, 0}},
      {"the second row begins 16 bytes after the first one", {bytes, 16, 0, 1}},
      {"the fourth texel of the second row has the bytes 250 230 204", {bytes, 16, 3, 1}},
  };
  return {
      "03",
      {exercise(column_of, globe(64, 8, 24),
                {right_column,
                 wrong_columns,
                 column_of_places,
                 {},
                 [](double, int n, double, double) { return n; }}),
       exercise(row_of, globe(32, 0, 0, 1),
                {right_row, wrong_rows, row_of_places, {}, {}, at_the_ends}),
       exercise(color_of, globe(510),
                {[](const Bytes& b, int row_bytes, int column, int row) {
                   const int first = row * row_bytes + 3 * column;
                   return color_from(b, first + 2, first + 1, first, 255);
                 },
                 wrong_texels, color_of_places})},
      {{"Berlin is at longitude 13.4 degrees east. In which of the map's 2048 columns is it?",
        [] { return double(texel_number((180 + 13.4) / 360, 2048, TexelRounding::floor)); },
        {"", 0},
        "Where on the map is longitude 0, and how many columns are 360 degrees?",
        {{76, "longitude 0 is in the middle of the map, not at its left edge"},
         {76.23, "longitude 0 is in the middle of the map, not at its left edge"},
         {1101, "columns are numbered from 0: cut off the decimals"},
         {1100.23, "the number of a column is whole: cut off the decimals"}}},
       {"The map has 2048 x 1024 texels. What percentage of them does the chapter's picture read, "
        "with one ray a pixel?",
        texels_read,
        {"percent", 0.05},
        "How many pixels of the picture show the globe, and how many texels does each of them "
        "read?",
        {{1.41, "this counts only the texels that the eye sees: the map has more"}}}},
  };
}

}  // namespace texmap::check
