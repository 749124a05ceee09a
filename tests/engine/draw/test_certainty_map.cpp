// Bounds of pictures by the lessons' own code with intervals: at every pixel they contain the
// result of every number with enough digits.
#include "engine/draw/certainty_map.hpp"

#include <doctest.h>

#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "support/pictures.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

struct Count {
  int pixels = 0;
  int certain = 0;  ///< pixels that no rounding can change
  int outside = 0;  ///< pixels of another number outside the bounds
};

/// Bounds by `judge`, and the color of `lesson` in the number Real against them.
template <class Real, class Lesson>
Count against_bounds(const Lesson& judge, const Lesson& lesson) {
  const View<> view = view_of(lesson.stage.camera, 120, 90);
  Count count;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const auto bounds = pixel_color<Interval>(judge, view, Interval(column), Interval(row), 1);
      const auto color =
          pixel_color<Real>(lesson, view, static_cast<Real>(column), static_cast<Real>(row), 1);
      const auto inside = [](const Interval& bound, Real channel) {
        return static_cast<Real>(bound.low()) <= channel &&
               channel <= static_cast<Real>(bound.high());
      };
      ++count.pixels;
      count.certain += uncertain_levels(bounds) == 0 ? 1 : 0;
      count.outside +=
          inside(bounds.r, color.r) && inside(bounds.g, color.g) && inside(bounds.b, color.b) ? 0
                                                                                              : 1;
    }
  }
  return count;
}

template <class Lesson>
void check_bounds(const Lesson& lesson) {
  CAPTURE(Lesson::about.idea);
  const Count in_double = against_bounds<double>(lesson, lesson);
  CHECK(in_double.outside == 0);
  CHECK(against_bounds<long double>(lesson, lesson).outside == 0);
  CHECK(in_double.certain > in_double.pixels * 97 / 100);
  MESSAGE(std::string(Lesson::about.idea)
          << ": " << in_double.certain << " of " << in_double.pixels << " pixels are certain");

  // The twin: bounds that hold anything would be no bounds.
  Lesson moved = lesson;
  moved.stage.light.position.x += 1e-9;
  CHECK(against_bounds<double>(lesson, moved).outside > in_double.pixels / 10);
}

/// A picture in gray 100 with some pixels that are uncertain by some levels.
struct Spots {
  struct Spot {
    int column, row, levels;
  };
  std::vector<Spot> spots;
  View<> view{.eye = {0, 0, 0},
              .forward = {0, 0, -1},
              .right = {1, 0, 0},
              .up = {0, 1, 0},
              .pixel = 0.125,
              .center_column = 0,
              .center_row = 0,
              .width = 12,
              .height = 8};

  Color<Interval> operator()(const Ray<Interval>& ray) const {
    const auto place = [&](const Interval& x) {
      return static_cast<int>(std::lround(8 * x.low() / -ray.direction.z.low()));
    };
    const auto level = [](int byte) { return Interval((byte + 0.5) / 255); };
    Interval light = level(100);
    for (const Spot& spot : spots) {
      if (place(ray.direction.x) == spot.column && place(-ray.direction.y) == spot.row)
        light = hull(light, level(100 + spot.levels));
    }
    return {light, light, light};
  }
};

}  // namespace

TEST_CASE("an uncertain pixel is drawn three wide, clipped at the edge, and counted once") {
  const Spots spots{{{0, 0, 4}, {6, 3, 1}, {8, 3, 16}, {11, 7, 2}}};
  long uncertain = -1, pixels = -1;
  const Image map = draw_certainty_map(spots, spots.view, {.certainty = [&](long count, long all) {
                                         uncertain = count;
                                         pixels = all;
                                       }});
  CHECK(uncertain == 4);
  CHECK(pixels == 12 * 8);
  const Rgb8 certain =
      shade_of_uncertainty(Spots{}(ray_through(spots.view, Interval(3), Interval(3))), 0);
  CHECK(certain.r == certain.b);
  int wrong = 0;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 12; ++column) {
      int widest = 0;  // of two spots that reach a pixel the less certain one is seen
      for (const Spots::Spot& spot : spots.spots) {
        if (std::abs(spot.column - column) <= 1 && std::abs(spot.row - row) <= 1)
          widest = std::max(widest, spot.levels);
      }
      const Rgb8 expected = widest == 0 ? certain : shade_of_uncertainty({}, widest);
      wrong += map.at(column, row) == expected ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  const Image all_certain = draw_certainty_map(Spots{}, spots.view, {});
  CHECK(count_different(map, all_certain) == 4 + 9 + 9 - 3 + 4);
}

TEST_CASE(
    "double and extended precision stay inside the bounds of every chapter at every pixel, and "
    "another picture does not") {
  check_bounds(chapter_02::Lesson{});
  check_bounds(prepared<chapter_03::Lesson>());
  check_bounds(prepared<chapter_05::Lesson>({"--degrees", "37"}));
  check_bounds(prepared<chapter_06::Lesson>());
  check_bounds(prepared<chapter_08::Lesson>({"--uv-scale=2x1", "--uv-turn=30", "--wrap=article"}));
}

TEST_CASE("the map is gray where a pixel is certain, and colored where it is not") {
  // Green weighs twice as much as red, and blue a third of red; from 40 to 240.
  const auto gray_of = [](double r, double g, double b) {
    const Color<Interval> sure{Interval(r), Interval(g), Interval(b)};
    CHECK(uncertain_levels(sure) == 0);
    return shade_of_uncertainty(sure, 0);
  };
  CHECK(gray_of(1, 0, 0) == Rgb8{100, 100, 100});
  CHECK(gray_of(0, 1, 0) == Rgb8{160, 160, 160});
  CHECK(gray_of(0, 0, 1) == Rgb8{60, 60, 60});
  CHECK(gray_of(2, 2, 2) == Rgb8{240, 240, 240});
  CHECK(gray_of(-1, -1, -1) == Rgb8{40, 40, 40});
  CHECK(shade_of_uncertainty({}, 1) == Rgb8{255, 216, 25});
  CHECK(shade_of_uncertainty({}, 4) == Rgb8{235, 121, 25});  // half of the way to 16
  CHECK(shade_of_uncertainty({}, 16) == Rgb8{216, 25, 25});
  CHECK(shade_of_uncertainty({}, 32) == Rgb8{191, 25, 63});  // a quarter of the way to 256
  CHECK(uncertain_levels({Interval(0.0), Interval(1.0), hull(Interval(0.0), Interval(1.0))}) ==
        255);
}
