// The exercises of chapter 09. The lesson's FilteredTexture is here a struct that calls the
// student's function where it reads the floor.
#include "09_texture_filtering/sheet.hpp"
#include "engine/run/filter_options.hpp"
#include "exercises.hpp"

namespace texmap::chapter_09 {

static std::function<int(int, int)> repeated_column;
static std::function<std::array<double, 2>(double, int)> weights_of;
static std::function<double(double)> level_of_width;

struct FilteredTexture : texmap::FilteredTexture {
  using texmap::FilteredTexture::operator=;

  Rgb operator()(const Uv<double>& uv) const {
    const bool floor = wrap == Wrap::repeat;  // the globes' is spherical
    if (floor && repeated_column) return nearest_texel({uv.u, 1 - uv.v});
    if (floor && weights_of) return four_texels_mixed({uv.u, 1 - uv.v});
    return texmap::FilteredTexture::operator()(uv);
  }
  Color<Dual<double>> operator()(const Uv<Dual<double>>& uv) const {
    if (wrap != Wrap::repeat || !level_of_width) return texmap::FilteredTexture::operator()(uv);
    // As wide as the footprint is long, by the filter trilinear.
    const double longer = footprint_of(uv, whole().width, whole().height).longer;
    const double last = pyramid.last_level();
    const double level = clamp(level_of_width(longer), 0.0, last);
    const double fine = floor(level);
    const Rgb color =
        trilinear({uv.u.value, 1 - uv.v.value},
                  TwoLevels<double>{level_of(pyramid, fine), level_of(pyramid, min(fine + 1, last)),
                                    level - fine, level > fine});
    return {color.r, color.g, color.b};
  }

 private:
  [[nodiscard]] PyramidLevel<double> whole() const { return level_of(pyramid, 0.0); }

  Rgb nearest_texel(const Uv<double>& at) const {
    const int width = pyramid.levels.front().width;
    const int column = repeated_column(static_cast<int>(floor(at.u * width)), width);
    if (column < 0 || column >= width) return {1, 0, 1};  // magenta: outside the picture
    const double height = whole().height;
    return texel_light(pyramid, whole(), double(column),
                       remainder_of(floor(at.v * height), height));
  }
  Rgb four_texels_mixed(const Uv<double>& at) const {
    const PyramidLevel<double> level = whole();
    const Uv<double> inside{wrapped_coordinate(wrap, at.u), wrapped_coordinate(wrap, at.v)};
    const auto [left, right] = weights_of(inside.u, static_cast<int>(level.width));
    const auto [top, bottom] = weights_of(inside.v, static_cast<int>(level.height));
    const double column = floor(inside.u * level.width - 0.5);
    const double row = floor(inside.v * level.height - 0.5);
    const auto texel_at = [&](double x, double y) {
      return texel_light(pyramid, level, remainder_of(x, level.width),
                         remainder_of(y, level.height));
    };
    const auto row_of = [&, left = left, right = right](double y) {
      return texel_at(column, y) * left + texel_at(column + 1, y) * right;
    };
    return row_of(row) * top + row_of(row + 1) * bottom;
  }
};

struct Lesson;
/// The program's sheet of all filters is not drawn here.
inline void show_filters(Lesson&, Session&) {}

}  // namespace texmap::chapter_09

#include "09_texture_filtering/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_09;

using Weights = std::array<double, 2>;

/// The floor drawn by this filter, its picture so wide.
Image drawn_floor(const char* filter, double size, const LightImage* texels = nullptr) {
  auto lesson = prepared<Lesson>({"--filter", filter, "--scene", "plane", "--floor", "crate.png"});
  if (texels != nullptr) lesson.ground.texture.pyramid = pyramid_of(*texels);
  lesson.ground.mapping.mapping.size = size;
  return picture_of(lesson);
}

Slips<int> wrong_columns(int column, int width) {
  const int rest = column % width;
  /// The rest of a division by another number, with `added` where it is below 0.
  const auto rest_of = [=](int divisor, int added) {
    const int other = column % divisor;
    return other < 0 ? other + added : other;
  };
  const int from_left = column < 0 ? column + width : column;  // by one width
  const int up = column < 0 ? (rest + width) % width : column;
  const int fold = (column % (2 * width) + 2 * width) % (2 * width);  // in two pictures
  int down = up;
  while (down > width) down -= width;
  return {
      {"add the width where the rest is below 0",
       {{"the rest is below 0 where the column is", rest},
        {"0 must stay 0", rest <= 0 ? rest + width : rest},
        {"-4 of 4 must be 0, so do not ask the column", column < 0 ? rest + width : rest},
        {"you add it to every rest", rest + width},
        {"the rest -1 is the last column, width - 1",
         {rest_of(width, width - 1), rest_of(width, width + 1),
          column < 0 ? width - 1 + rest : rest}}}},
      {"left of the picture your floor is mirrored: without its sign, -1 is seen as 1, or as 0",
       {abs(rest), column < 0 ? (-1 - column) % width : rest}},
      {"every second picture runs backward: that is mirror, and here the picture is repeated",
       min(fold, 2 * width - 1 - fold)},
      {"write column % width",
       {{"you divide by width - 1 or width + 1",
         {column % (width - 1), rest_of(width - 1, width - 1), rest_of(width - 1, width),
          column % (width + 1), rest_of(width + 1, width), rest_of(width + 1, width + 1)}},
        {"width % column and column / width are other numbers", {width % column, column / width}},
        {"& is right for a width of 2, 4, 8 and so on alone", column & (width - 1)}}},
      {"one width is not enough: columns far away are still outside the picture",
       {column >= width ? column - width : from_left, (column + width) % width,
        column < 0 ? from_left : rest, column > width ? column - width : from_left}},
      {"column = width is column 0 again: subtract where column >= width", down},
      {"columns on one side stay there: take the rest, too", {column < 0 ? column : rest, up}},
      {"the picture is seen once, then its edge: that is clamp", clamp(column, 0, width - 1)},
      {"your floor shows the picture once, and then always column 0: the picture is repeated",
       column < 0 || column >= width ? 0 : column},
  };
}

int right_column(int column, int width) { return int(remainder_of(1. * column, 1. * width)); }
int width_of(int /*column*/, int width) { return width; }
constexpr Place<int, int> repeated_column_places[] = {
    {"inside the picture, column 2 of 4 is seen as it is", {2, 4}},
    {"the first column right of the picture, 4 of 4, is column 0 again", {4, 4}},
    {"column 5 of 4 is column 1", {5, 4}},
    {"the first column left of the picture, -1 of 4, is the last one, 3", {-1, 4}},
    {"column -3 of 4 is column 1", {-3, 4}},
    {"column -4 of 4 is column 0", {-4, 4}},
    {"column -5 of 4 is column 3", {-5, 4}},
    {"column 70 of 8 is column 6", {70, 8}},
    {"column -70 of 8 is column 2", {-70, 8}},
    {"column -10 of 6 is column 2", {-10, 6}},
};

/// Texels half a unit wide.
Image floor_of_three_colors() {
  LightImage image(8, 8);
  for (int i = 0; i < 64; ++i) {
    image.at(i % 8, i / 8) = number_cast<float>(
        std::array{blue, red, white}[static_cast<std::size_t>(i % 8 + i / 8 * 2) % 3]);
  }
  return drawn_floor("bilinear", 4, &image);
}

Slips<Weights> wrong_weights(double u, int w) {
  const double x = u * w - 0.5, right = fraction(x);
  const Slips<double> weights = {
      {"half a texel is missing: center k is at k + 1/2 (1 / 2 as int is 0)", fraction(u * w)},
      {"write u * width - 0.5",
       {{"you subtract half a texel from u", fraction((u - 0.5) * w)},
        {"u = 1 is the right edge of the last texel, and you multiply by width - 1",
         {fraction(u * (w - 1)), fraction(u * (w - 1) - 0.5)}},
        {"u runs from 0 to 1, multiply it by width", {fraction(u - 0.5), u}}}},
      {"the nearer texel has all the weight: this is the filter nearest", round(right)},
      {"the right texel has x - std::floor(x)",
       {{"all weight is on one side, or x is no double", 0},
        {"cut off toward 0 it is below 0 at the left edge, or loses its sign",
         {x - trunc(x), abs(fmod(x, 1))}},
        {"this is the distance to the nearest center", {abs(remainder(x, 1)), x - round(x)}},
        {"std::ceil(x) is the center on the right", ceil(x) - x},
        {"this is a place and no part", {x, floor(x), u * w}},
        {"the weights change evenly, by no power of it",
         {right * right, right * right * (3 - 2 * right), sqrt(right)}}}},
      {"both texels count 1/2 everywhere: this blurs, but does not mix by distance", 0.5},
  };
  return {
      {"the weights are exchanged: the closer texel must count more", {right, 1 - right}},
      changed(weights,
              [](double r) {
                return Weights{1 - r, r};
              }),
      changed(weights,
              [](double r) {
                return Weights{r, 1 - r};
              }),
      {"equal weights: the left one is 1 - right", {{right, right}, {1 - right, 1 - right}}},
  };
}

constexpr Place<double, int> weights_of_places[] = {
    {"at the center of texel 1 of 4, u = 3/8, only that texel counts: 1 and 0", {0.375, 4}},
    {"halfway between the centers of texels 1 and 2 of 4, u = 1/2: 1/2 and 1/2", {0.5, 4}},
    {"u = 7/16 is a quarter of the way from center 1 to center 2 of 4: 3/4 and 1/4", {0.4375, 4}},
    {"u = 9/16 is three quarters of the way from center 1 to 2 of 4: 1/4 and 3/4", {0.5625, 4}},
    {"u = 0.3 of 8 texels is 0.9 of the way from center 1 to center 2: 0.1 and 0.9", {0.3, 8}},
    {"u = 1/4 of 5 texels is 3/4 of the way from center 0 to center 1: 1/4 and 3/4", {0.25, 5}},
    {"on the left edge, u = 0, the last texel is on the left again: 1/2 and 1/2", {0, 4}},
    {"u = 1/16 of 4 texels is left of the first center: 1/4 and 3/4", {0.0625, 4}},
};

double level_of(double width) {
  const LevelPlace<double> place = level_place(width, 30);
  return place.number + place.fraction;
}

Slips<double> wrong_levels(double width) {
  const double w1 = max(width, 1.), l = floor(log2(w1));
  const auto third = [](double scaled) { return (scaled * scaled - 1) / 3; };
  Slips<double> wrong = {
      {"this is the logarithm log2: right at whole levels, up to 0.17 off between them", log2(w1)},
      {"widths below 1 must count as 1: there is no level below 0",
       {log2(width), width < 1 ? third(width) : level_of(width),
        floor(log2(width)) + third(width / exp2(floor(log2(width))))}},
      {"this is the natural logarithm: a level is a power of 2", {log(w1), log(width)}},
      {"std::min makes every width 1 or less: take std::max(width, 1.0)", third(min(width, 1.))},
  };
  for (const double w : {w1, width}) {
    const double scaled = w / exp2(l), square = scaled * scaled, f = third(scaled);
    const auto at = [=](double level) { return level + third(w / exp2(level)); };
    wrong += {
        {"this is the whole level alone: add f, and compute with double, not int", l},
        {"the level is one too high or too low: count from 0, once for each halving",
         {l + 1 + f, l + 1 + third(scaled / 2), l - 1 + f}},
        {"it is l + (square - 1) / 3",
         {{"this is f alone", f},
          {"it grows with the square of the width", {l + scaled - 1, l + (scaled - 1) / 3}},
          {"divide by 3", {l + square - 1, l + (square - 1) / 2, l + (square - 1) / 4}},
          {"the square is not reduced by 1", l + square / 3},
          {"/ comes before -", {l + square - 1 / 3., l + square}},
          {"f is added to l, not subtracted or multiplied", {l - f, l * (square - 1) / 3}}}},
        {"f takes the width after halving, width / 2^l", {l + third(w), l + (w * scaled - 1) / 3}},
        {"2 to the power l is std::exp2(l), not 2 * l and, in C++, not 2 ^ l",
         {l + third(w / (2 * l)), l + third(w / (2 ^ static_cast<int>(l)))}},
        {"l is the level below the width, by std::floor", {at(ceil(log2(w))), at(round(log2(w)))}},
    };
  }
  return wrong;
}

constexpr Place<double> level_of_width_places[] = {
    {"a read 1 texel wide is at level 0", {1}},
    {"a read 2 texels wide is at level 1", {2}},
    {"8 = 2^3 texels are at level 3", {8}},
    {"3 texels: l = 1, and f = ((3/2)^2 - 1) / 3 = 0.4167", {3}},
    {"1.5 texels: l = 0, and f = (1.5^2 - 1) / 3 = 0.4167", {1.5}},
    {"100 texels: l = 6, and f = ((100/64)^2 - 1) / 3 = 0.4805", {100}},
    {"no level is finer than 0: 1/2 of a texel is at level 0", {0.5}},
    {"a footprint of width 0 is at level 0", {0}},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "09",
      {exercise(repeated_column, [] { return drawn_floor("nearest", 3); },
                {right_column, wrong_columns, repeated_column_places, {}, width_of}),
       exercise(weights_of, floor_of_three_colors,
                {[](double u, int width) {
                   const double second = u * width - 0.5 - std::floor(u * width - 0.5);
                   return Weights{1 - second, second};
                 },
                 wrong_weights, weights_of_places}),
       exercise(level_of_width, picture<Lesson>({"--filter", "trilinear", "--scene", "plane"}),
                {level_of, wrong_levels, level_of_width_places})},
      {{"Far away the floor is half black and half white. Which byte, 0 to 255, shows the mean of "
        "their light?",
        [] { return double(byte_of(shown_light(gray(0.5)).g)); },
        {"", 0},
        "Half of the light is not half of the byte: which curve is between them?",
        {{128, "this is the mean of the bytes: the mean of the light has to be encoded"}}},
       {"How many texels does the pyramid of the floor's 1024 x 1024 texels have, all levels "
        "together?",
        [] {
          const auto lesson = prepared<Lesson>({"--scene", "plane"});
          return double(lesson.ground.texture.pyramid.texels.size());
        },
        {"texels", 1e-3},
        "Each level has half as many columns and half as many rows. How many texels is that?",
        {{1048576, "this is level 0 alone"},
         {2097152,
          "each level has a quarter of the texels, not half: half of the columns and of the "
          "rows"}}}},
  };
  return chapter;
}

}  // namespace texmap::check
