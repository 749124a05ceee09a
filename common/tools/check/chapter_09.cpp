// The exercises of chapter 09. The lesson's FilteredTexture is here a struct that calls the
// student's function where it reads the floor.
#include <utility>

#include "09_texture_filtering/sheet.hpp"
#include "engine/run/filter_options.hpp"
#include "exercises.hpp"
#include "scene/stage.hpp"

namespace texmap::chapter_09 {

static std::function<int(int, int)> repeated_column;
static std::function<Rgb(const std::vector<Rgb>&, double, double)> color_at_time;
static std::function<double(Uv<double>, Uv<double>, Uv<double>, int, int)> level_for;

struct FilteredTexture : texmap::FilteredTexture {
  FilteredTexture(texmap::FilteredTexture loaded = {})
      : texmap::FilteredTexture(std::move(loaded)) {}

  Rgb operator()(const Uv<double>& uv) const {
    const bool floor = wrap == Wrap::repeat;  // the globes' is spherical
    if (floor && repeated_column) return nearest_texel({uv.u, 1 - uv.v});
    if (floor && color_at_time) return color_at_time({blue, red, white}, 1, check::fraction(uv.u));
    return texmap::FilteredTexture::operator()(uv);
  }
  Color<Dual<double>> operator()(const Uv<Dual<double>>& uv) const {
    if (!level_for) return texmap::FilteredTexture::operator()(uv);
    const Dual<double> u = uv.u, v = uv.v;
    const PyramidLevel<int>& whole = pyramid.levels.front();
    const auto neighbor = [&](double du, double dv) {
      return Uv<double>{check::fraction(u.value + clamp(du, -0.4, 0.4)), v.value + dv};
    };
    const double level = clamp(level_for(neighbor(0, 0), neighbor(u.dx, v.dx), neighbor(u.dy, v.dy),
                                         whole.width, whole.height),
                               0.0, double(pyramid.last_level()));
    const double fine = floor(level), coarse = std::ceil(level);
    const Rgb color =
        trilinear({u.value, 1 - v.value},
                  TwoLevels<double>{level_of(pyramid, fine), level_of(pyramid, coarse),
                                    level - fine, level > fine});
    return {color.r, color.g, color.b};
  }

 private:
  Rgb nearest_texel(const Uv<double>& at) const {
    const int width = pyramid.levels.front().width;
    const int column = repeated_column(static_cast<int>(floor(at.u * width)), width);
    if (column < 0 || column >= width) return {1, 0, 1};  // magenta: outside the picture
    const PyramidLevel<double> whole = level_of(pyramid, 0.0);
    return texel_light(pyramid, whole, double(column),
                       remainder_of(floor(at.v * whole.height), whole.height));
  }
};

struct Lesson;
/// The exercises draw one picture. They have no sheet of filters and no budget.
inline void show_filters(Lesson&, Session&) {}
inline void choose_scene(Lesson& lesson, Chosen& chosen);

}  // namespace texmap::chapter_09

#include "09_texture_filtering/lesson.hpp"

inline void texmap::chapter_09::choose_scene(Lesson& lesson, Chosen&) { keep_scene(lesson); }

namespace texmap::check {
namespace {

using namespace chapter_09;

/// The floor, its picture so wide.
std::function<Image()> floor_of(double size) {
  return [=] {
    auto lesson =
        prepared<Lesson>({"--filter", "nearest", "--scene", "plane", "--floor", "crate.png"});
    lesson.ground.mapping.mapping.size = size;
    return picture_of(lesson);
  };
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
        (column + 100 * width) % width, column < 0 ? from_left : rest,
        column > width ? column - width : from_left}},
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
    {"far away, column -2147483645 of 4 is column 3", {-2147483645, 4}},
};

using Frames = std::vector<Rgb>;

Slips<Rgb> wrong_colors(const Frames& frames, double seconds, double time) {
  const int n = int(frames.size());
  const auto frame = [&](int i) { return frames[std::size_t((i % n + n) % n)]; };
  const auto limited = [&](int i) { return frames[std::size_t(clamp(i, 0, n - 1))]; };
  /// At this place, counted in middles of frames.
  const auto at = [&](double x) {
    return mix(frame(int(floor(x))), frame(int(floor(x)) + 1), fraction(x));
  };
  const double x = time / seconds * n - 0.5, part = fraction(x);
  const int i = int(floor(x));
  const double once = fmod(time, seconds) / seconds * n - 0.5;  // in the film
  const int first = int(floor(once));
  return {
      {"half a frame is missing: frame k is right at k + 1/2 (1 / 2 as int is 0)", at(x + 0.5)},
      {"the weights are exchanged: the closer frame must count more",
       mix(frame(i), frame(i + 1), 1 - part)},
      {"this is the nearest frame alone: the light jumps",
       {frame(int(floor(x + 0.5))), frame(int(round(x))), frame(i), frame(i + 1)}},
      {"the film begins again: after the last frame comes the first one, before the first the last",
       {mix(limited(first), limited(first + 1), part), mix(limited(i), limited(i + 1), part),
        mix(frame(max(first, 0)), frame(first + 1), part),
        mix(frame(first), limited(first + 1), part), mix(frame(max(i, 0)), frame(i + 1), part)}},
      {"std::floor goes down, a conversion to int toward 0: before 1/2 x is below 0",
       {mix(frame(cut_off(x)), frame(cut_off(x) + 1), x - trunc(x)),
        mix(frame(cut_off(x)), frame(cut_off(x) + 1), abs(x - trunc(x)))}},
      {"multiply by the number of frames: all of them together last `seconds`",
       {at(time / seconds - 0.5), at(time - 0.5), at(time * n - 0.5), at(time * seconds - 0.5),
        at(time * seconds * n - 0.5)}},
      {"there are as many frame times as frames, not one less",
       {at(time / seconds * (n - 1)), at(time / seconds * (n - 1) - 0.5)}},
      {"both frames count 1/2 everywhere: mix by time", mix(frame(i), frame(i + 1), 0.5)},
      {"the two frames are the one before and the one after",
       {mix(frame(i), frame(i - 1), part), mix(frame(i - 1), frame(i), part),
        mix(frame(i + 1), frame(i + 2), part)}},
  };
}

/// Each frame weighs 1 minus its distance in time, counted in frames, if that is less than 1.
Rgb right_color(const Frames& frames, double seconds, double time) {
  const auto n = double(frames.size());
  Rgb sum{};
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double away = n * abs(remainder((double(k) + 0.5) / n - time / seconds, 1));
    sum = sum + frames[k] * max(0., 1 - away);
  }
  return sum;
}

Slips<double> wrong_levels(Place2 here, Place2 right, Place2 below, int width, int height) {
  const auto level = [](double length) { return log2(max(length, 1.)); };
  const auto round_the_globe = [](double across) { return min(abs(across), 1 - abs(across)); };
  const double right_u = round_the_globe(right.u - here.u), right_v = abs(right.v - here.v);
  const double below_u = round_the_globe(below.u - here.u), below_v = abs(below.v - here.v);
  /// The longer of both ways, by another measure of a way.
  const auto longer = [&](auto measure) {
    return max(measure(right_u, right_v), measure(below_u, below_v));
  };
  const auto in_texels = [&](double u, double v) { return std::hypot(u * width, v * height); };
  const auto across = [&](auto of) {
    return max(in_texels(of(right.u - here.u), right_v), in_texels(of(below.u - here.u), below_v));
  };
  const double to_right = in_texels(right_u, right_v), to_below = in_texels(below_u, below_v);
  const double length = max(to_right, to_below), whole = floor(level(length));
  return {
      {"across the seam the way is short: from u = 0.99 to 0.01 it is 0.02 of a turn",
       {level(across([](double u) { return u; })), level(across(fraction)),
        level(across([](double u) { return u < 0 ? u + 1 : u; })),
        level(across([](double u) { return 1 - abs(u); }))}},
      {"no level is finer than 0: a way shorter than a texel counts as 1",
       {log2(length), abs(log2(length)), length > 0 ? log2(length) : 0}},
      {"the longer way decides, not the shorter one or their mean",
       {level(min(to_right, to_below)), level((to_right + to_below) / 2), level(to_right),
        level(to_below), level(to_right + to_below), level(std::hypot(to_right, to_below)),
        level(sqrt(to_right * to_below))}},
      {"count in texels: the difference of u times width, that of v times height",
       {level(longer([](double u, double v) { return std::hypot(u, v); })),
        level(longer([&](double u, double v) { return width * std::hypot(u, v); })),
        level(longer([&](double u, double v) { return height * std::hypot(u, v); })),
        level(longer([&](double u, double v) { return std::hypot(u * height, v * width); }))}},
      {"the length of a vector is the root of the sum of both squares",
       {level(longer([&](double u, double v) { return u * width + v * height; })),
        level(longer([&](double u, double v) { return max(u * width, v * height); })),
        level(length * length), level(longer([&](double u, double) { return u * width; })),
        level(longer([&](double, double v) { return v * height; }))}},
      {"this is the width of the texels, not the level: take std::log2 of it",
       {length, max(length, 1.), sqrt(length)}},
      {"l + f is for a tap that mixes two levels; texels of level l are 2^l wide, so take log2",
       whole + (pow(max(length, 1.) / exp2(whole), 2) - 1) / 3},
      {"this is another logarithm: a level is a power of 2",
       {log(max(length, 1.)), std::log10(max(length, 1.))}},
      {"the level need not be whole", {whole, round(level(length)), ceil(level(length))}},
      {"a texel of level l is 2^l wide: level 0 for the length 1",
       {1 + level(length), exp2(length)}},
  };
}

/// By the angle around the axis.
double right_level(Place2 here, Place2 right, Place2 below, int width, int height) {
  const auto squared = [=](Place2 to) {
    const double x = width * remainder(to.u - here.u, 1), y = height * (to.v - here.v);
    return x * x + y * y;
  };
  return log2(max({squared(right), squared(below), 1.})) / 2;
}
constexpr Place<Place2, Place2, Place2, int, int> level_for_places[] = {
    {"8 texels of 64 to the right, 2 down: level 3",
     {{0.5, 0.5}, {0.625, 0.5}, {0.5, 0.4375}, 64, 32}},
    {"8 texels down are longer than 4 to the right: level 3",
     {{0.5, 0.75}, {0.5625, 0.75}, {0.5, 0.5}, 64, 32}},
    {"1 texel each: level 0", {{0.5, 0.5}, {0.515625, 0.5}, {0.5, 0.46875}, 64, 32}},
    {"6 texels across and 8 down make 10: level 3.3219",
     {{0.25, 0.75}, {0.34375, 0.5}, {0.25, 0.75}, 64, 32}},
    {"to the left, 16 texels: level 4", {{0.5, 0.5}, {0.25, 0.5}, {0.5, 0.5}, 64, 32}},
    {"across the seam, from u = 0.96875 to 0.03125 of 64: 4 texels, level 2",
     {{0.96875, 0.5}, {0.03125, 0.5}, {0.96875, 0.46875}, 64, 32}},
    {"across the seam to the west, from 0.03125 to 0.90625: 8 texels, level 3",
     {{0.03125, 0.5}, {0.03125, 0.46875}, {0.90625, 0.5}, 64, 32}},
    {"of 1000 x 300 texels, slanted", {{0.2, 0.4}, {0.21, 0.43}, {0.19, 0.37}, 1000, 300}},
    {"no level is finer than 0: half a texel is level 0",
     {{0.5, 0.5}, {0.5078125, 0.5}, {0.5, 0.5}, 64, 32}},
    {"three rays to one place: level 0", {{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}, 64, 32}},
};

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  const Frames four = {{1, 0, 0.2}, {0, 1, 0.4}, {0.5, 0.5, 0.8}, {0.25, 0.75, 0}},
               three = {red, white, blue};
  static const Place<Frames, double, double> color_at_time_places[] = {
      {"4 frames in 8 seconds: in the middle of frame 0, after 1 second, it is frame 0",
       {four, 8, 1}},
      {"after 5 seconds, in the middle of frame 2, it is frame 2", {four, 8, 5}},
      {"after 2 seconds frames 0 and 1 count 1/2", {four, 8, 2}},
      {"after 3.5 seconds frame 1 counts 3/4 and frame 2 counts 1/4", {four, 8, 3.5}},
      {"after 6.8 seconds frame 3 counts 9/10 and frame 2 counts 1/10", {four, 8, 6.8}},
      {"at the beginning the last frame and frame 0 count 1/2", {four, 8, 0}},
      {"after 0.5 seconds frame 0 counts 3/4 and the last frame 1/4", {four, 8, 0.5}},
      {"after 7.5 seconds the last frame counts 3/4 and frame 0 counts 1/4", {four, 8, 7.5}},
      {"after 11.5 seconds the film runs again: as after 3.5", {four, 8, 11.5}},
      {"3 frames in 1 second, after 0.3: frame 0 counts 0.6 and frame 1 counts 0.4",
       {three, 1, 0.3}},
      {"3 frames in 1 second, after 2.9", {three, 1, 2.9}},
  };
  return {
      "09",
      {exercise(repeated_column, floor_of(3),
                {right_column, wrong_columns, repeated_column_places, {}, width_of}),
       exercise(color_at_time, floor_of(4), {right_color, wrong_colors, color_at_time_places}),
       exercise(level_for, picture<Lesson>({"--filter", "trilinear"}),
                {right_level, wrong_levels, level_for_places})},
      {{"Far away the floor is half black and half white. Which byte, 0 to 255, shows the mean of "
        "their light?",
        [] { return double(byte_of(shown_light(gray(0.5)).g)); },
        {"", 0},
        "Half of the light is not half of the byte: which curve is between them?",
        {{128, "this is the mean of the bytes: the mean of the light has to be encoded"},
         {187, "bytes are rounded to the nearest here, not cut off"}}},
       {"How many texels does the pyramid of the floor's 1024 x 1024 texels have, all levels "
        "together?",
        [] {
          const auto lesson = prepared<Lesson>({"--scene", "plane"});
          const Pyramid& pyramid = lesson.ground.texture.pyramid;
          return double(pyramid.original.size() + pyramid.smaller.pixels.size());
        },
        {"texels", 1e-3},
        "Each level has half as many columns and half as many rows. How many texels is that?",
        {{1048576, "this is level 0 alone"},
         {2097152,
          "each level has a quarter of the texels, not half: half of the columns and of the "
          "rows"}}}},
  };
}

}  // namespace texmap::check
