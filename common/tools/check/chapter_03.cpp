// The exercises of chapter 03. The lesson is the chapter's own. Its ImageTexture is this one here,
// which calls the student's functions.
#include <algorithm>
#include <cmath>
#include <set>

#include "bytes.hpp"
#include "exercises.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"

namespace texmap::check {

static Hook<int(double, int)> column_of;
static Hook<int(double, int)> row_of;
static Hook<Color<double>(const Bytes&, int, int, int)> color_of;

}  // namespace texmap::check

namespace texmap::chapter_03 {

struct ImageTexture {
  Image image;

  Color<double> operator()(const Uv<double>& uv) const {
    auto [column, row] =
        texel_place(uv, image.width, image.height, VAxis::up, TexelRounding::floor);
    if (check::column_of) column = check::column_of.yours(uv.u, image.width);
    if (check::row_of) row = check::row_of.yours(uv.v, image.height);
    if (column < 0 || column >= image.width || row < 0 || row >= image.height) return {};
    if (check::color_of)
      return check::color_of.yours(check::Bytes{image}, image.width, column, row);
    const Rgb8& texel = image.at(column, row);
    return {texel.r / 255.0, texel.g / 255.0, texel.b / 255.0};
  }
};

}  // namespace texmap::chapter_03

#include "03_image_texture/lesson.hpp"

namespace texmap::check {
namespace {

using chapter_03::Lesson;

Image& map_of(Lesson& lesson) {
  return std::get<chapter_03::Textured>(lesson.objects[chapter_03::middle].paint).texture.image;
}

/// The globe from nearby. With few texels one can count them.
Image globe(int columns) {
  auto lesson = prepared<Lesson>();
  lesson.stage.camera.fov_y_degrees = 18;
  Image& map = map_of(lesson);
  Image small(columns, columns / 2);
  for (int row = 0; row < small.height; ++row) {
    for (int column = 0; column < small.width; ++column) {
      small.at(column, row) = map.at((2 * column + 1) * map.width / (2 * small.width),
                                     (2 * row + 1) * map.height / (2 * small.height));
    }
  }
  map = small;
  return picture_of(lesson);
}

using FromCoordinate = int(double, int);

int cut_off(double x) { return static_cast<int>(x); }

/// The function with its number limited to the texels that there are.
std::function<FromCoordinate> limited_to_texels(int (*function)(double, int)) {
  return [=](double x, int n) { return std::clamp(function(x, n), 0, n - 1); };
}

Exercise which_column() {
  Law<FromCoordinate> law{
      .right = [](double u, int n) { return texel_number(u, n, TexelRounding::floor); },
      .places = {{"of 8 columns, u = 0.4 is in number 3", {0.4, 8}},
                 {"u = 0 is in the first column, number 0", {0.0, 8}},
                 {"of 2048 columns, u = 1/4 is in number 512", {0.25, 2048}},
                 {"of 10 columns, u = 0.06 is in number 0", {0.06, 10}},
                 {"of 10 columns, u = 0.96 is in number 9", {0.96, 10}},
                 {"of 8 columns, u = 1 is in the last one, number 7", {1.0, 8}},
                 {"of 8 columns, a u above 1 gives the last one, number 7", {1.3, 8}},
                 {"a u below 0 gives the first column, number 0", {-0.2, 8}}},
      .mistakes = {}};
  // Those who make another mistake often forget the ends, too.
  for (const bool limited : {true, false}) {
    const auto wrong = [&](const char* word, int (*function)(double, int)) {
      law.mistakes.push_back({word, limited ? limited_to_texels(function) : function});
    };
    wrong(
        "multiply by width, not by width - 1: now the last column is at u = 1 alone, and the "
        "others are too wide",
        [](double u, int n) { return cut_off(u * (n - 1)); });
    wrong(
        "you take the nearest whole number: this shifts the map by half a texel; cut off the "
        "decimals",
        [](double u, int n) { return cut_off(std::round(u * n)); });
    wrong("the columns are numbered from 0: yours is one too far right",
          [](double u, int n) { return cut_off(u * n) + 1; });
    wrong("u runs the other way: your map is mirrored",
          [](double u, int n) { return n - 1 - cut_off(u * n); });
    if (!limited) {
      wrong("nothing limits the number: at u = 1 it is width, one too many",
            [](double u, int n) { return cut_off(u * n); });
      wrong("the number can be less than 0: limit it there, too",
            [](double u, int n) { return std::min(cut_off(u * n), n - 1); });
      wrong("at u = 1 the number is width, one too many: limit it there, too",
            [](double u, int n) { return std::max(cut_off(u * n), 0); });
    }
  }
  return exercise("03.1", "int column_of(double u, int width)", std::move(law), column_of,
                  [] { return globe(32); });
}

Exercise which_row() {
  Law<FromCoordinate> law{
      .right =
          [](double v, int n) {
            return texel_place(Uv<double>{0, v}, 1, n, VAxis::up, TexelRounding::floor).row;
          },
      .places = {{"of 4 rows, v = 0.8 is in the top row, number 0", {0.8, 4}},
                 {"of 4 rows, v = 0.6 is in number 1, below the top row", {0.6, 4}},
                 {"of 4 rows, v = 0 is in the bottom row, number 3", {0.0, 4}},
                 {"of 1024 rows, the Sahara at v = 0.63 is in number 378", {0.63, 1024}},
                 {"of 10 rows, v = 0.06 is in number 9", {0.06, 10}},
                 {"v = 1 is in the top row, number 0", {1.0, 4}},
                 {"a v above 1 gives the top row, number 0", {1.3, 4}},
                 {"of 4 rows, a v below 0 gives the bottom row, number 3", {-0.3, 4}}},
      .mistakes = {}};
  for (const bool limited : {true, false}) {
    const auto wrong = [&](const char* word, int (*function)(double, int)) {
      law.mistakes.push_back({word, limited ? limited_to_texels(function) : function});
    };
    wrong("you count from below, and the file from the top: your map is upside down",
          [](double v, int n) { return cut_off(v * n); });
    wrong("multiply by height, not by height - 1: now the top row is at v = 1 alone",
          [](double v, int n) { return n - 1 - cut_off(v * (n - 1)); });
    wrong("the bottom row is number height - 1: yours is one too far down",
          [](double v, int n) { return n - cut_off(v * n); });
    wrong(
        "you take the nearest whole number: this shifts the map by half a texel; cut off the "
        "decimals",
        [](double v, int n) { return n - 1 - cut_off(std::round(v * n)); });
    if (!limited) {
      wrong("nothing limits the number: at v = 1 it is -1, and there is no such row",
            [](double v, int n) { return n - 1 - cut_off(v * n); });
      wrong("the number can be more than height - 1: limit it there, too",
            [](double v, int n) { return std::max(n - 1 - cut_off(v * n), 0); });
    }
  }
  return exercise("03.2", "int row_of(double v, int height)", std::move(law), row_of,
                  [] { return globe(32); });
}

Exercise color_of_a_texel() {
  // 3 x 2 texels, all bytes different; some of them are 0 and 255.
  static const Image image = [] {
    Image made(3, 2);
    made.pixels = {{255, 0, 51},   {10, 20, 30},    {40, 60, 80},
                   {90, 102, 110}, {120, 140, 160}, {204, 230, 250}};
    return made;
  }();
  const Bytes bytes(image);
  using Function = Color<double>(const Bytes&, int, int, int);
  const auto at = [](const Bytes& b, int first, double divisor) {
    return Color<double>{b[first] / divisor, b[first + 1] / divisor, b[first + 2] / divisor};
  };
  Law<Function> law{
      .right = [=](const Bytes& b, int width, int column,
                   int row) { return at(b, 3 * (row * width + column), 255); },
      .places = {{"the first texel, 255 0 51, is (1, 0, 0.2)", {bytes, 3, 0, 0}},
                 {"the right neighbor of the first texel begins three bytes later",
                  {bytes, 3, 1, 0}},
                 {"the second row begins after the 3 texels of the first row", {bytes, 3, 0, 1}},
                 {"the last texel of the second row is 204 230 250", {bytes, 3, 2, 1}}},
      .mistakes = {},
      .tolerance = 1e-9};
  const auto wrong = [&](const char* word, std::function<Function> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  wrong("red and blue are exchanged: the first byte of a texel is red",
        [=](const Bytes& b, int width, int column, int row) {
          const Color<double> c = at(b, 3 * (row * width + column), 255);
          return Color<double>{c.b, c.g, c.r};
        });
  wrong("the largest byte is 255: divide by 255, not by 256, or white is gray",
        [=](const Bytes& b, int width, int column, int row) {
          return at(b, 3 * (row * width + column), 256);
        });
  wrong("a channel goes from 0 to 1: divide the byte by 255.0",
        [=](const Bytes& b, int width, int column, int row) {
          return at(b, 3 * (row * width + column), 1);
        });
  wrong("whole numbers are divided without decimals: divide by 255.0",
        [=](const Bytes& b, int width, int column, int row) {
          const Color<double> c = at(b, 3 * (row * width + column), 255);
          return Color<double>{std::floor(c.r), std::floor(c.g), std::floor(c.b)};
        });
  wrong("you count texels, and each texel has three bytes: multiply by 3",
        [=](const Bytes& b, int width, int column, int row) {
          return at(b, row * width + column, 255);
        });
  wrong("only the column is multiplied by 3: each texel of the rows above has three bytes, too",
        [=](const Bytes& b, int width, int column, int row) {
          return at(b, row * width + 3 * column, 255);
        });
  wrong("column and row are exchanged: before the texel there are row whole rows",
        [=](const Bytes& b, int width, int column, int row) {
          return at(b, 3 * (column * width + row), 255);
        });
  return exercise("03.3", "Color color_of(const Bytes& bytes, int width, int column, int row)",
                  std::move(law), color_of, [] { return globe(512); });
}

/// The column of the map in which this longitude is, in degrees.
double column_at(double longitude) {
  auto lesson = prepared<Lesson>();
  const double angle = longitude * pi<double>() / 180;
  const Uv<double> uv = uv_rtiow(Vec3<double>{std::cos(angle), 0, -std::sin(angle)});
  return texel_number(uv.u, map_of(lesson).width, TexelRounding::floor);
}

/// The share of the map's texels that the chapter's picture reads, in percent.
double texels_read() {
  auto lesson = prepared<Lesson>();
  const Image& map = map_of(lesson);
  const Sphere<>& sphere = lesson.objects[chapter_03::middle].shape;
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  std::set<int> read;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const auto ray = ray_through<double>(view, column, row);
      const Nearest<double> nearest = find_nearest(lesson.objects, ray);
      if (nearest.index != static_cast<double>(chapter_03::middle)) continue;
      const auto place = texel_place(uv_rtiow(normal_at(sphere, ray, nearest.distance)), map.width,
                                     map.height, VAxis::up, TexelRounding::floor);
      read.insert(place.row * map.width + place.column);
    }
  }
  return 100 * static_cast<double>(read.size()) / static_cast<double>(map.pixels.size());
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {which_column(), which_row(), color_of_a_texel()},
      .questions = {{"03.a",
                     "Berlin is at longitude 13.4 degrees east. In which of the map's 2048 columns "
                     "is it?",
                     [] { return column_at(13.4); }, "", 0},
                    {"03.b",
                     "The map has 2048 x 1024 texels. What percentage of them does the chapter's "
                     "picture read, with one ray a pixel?",
                     texels_read, "percent", 0.05}},
  };
  return chapter;
}

}  // namespace texmap::check
