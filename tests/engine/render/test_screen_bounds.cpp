// Tests of common/engine/render/smoothing/screen_bounds.hpp: the rectangle contains all of a sphere
// and is no larger than needed.
#include <doctest.h>

#include <algorithm>

#include "engine/render/smoothing/screen_bounds.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

/// A camera and a sphere: most often in front of it, at least partly in the picture, otherwise
/// anywhere near or around the eye.
struct Scene {
  Camera camera;
  Sphere<> sphere;
};

Scene any_scene(Dice& dice) {
  const Point eye = dice.direction<double>() * dice.between(0, 5);
  const Point forward = dice.direction<double>();
  if (dice.once_in(4)) {
    const Point center = eye + dice.direction<double>() * dice.between(0, 3);
    return {{.eye = eye, .target = eye + forward, .fov_y_degrees = dice.between(20, 90)},
            {center, dice.between(0.5, 2)}};
  }
  const double away = dice.between(2, 20);
  const Point aside = dice.direction<double>() * (away * dice.between(0, 0.6));
  return {{.eye = eye, .target = eye + forward, .fov_y_degrees = dice.between(20, 90)},
          {eye + forward * away + aside, dice.between(0.05, 0.6) * away}};
}

bool is_met(const View<>& view, const Sphere<>& sphere, double column, double row) {
  return distance_to(sphere, ray_through(view, column, row)) < infinity<double>();
}

/// True if no pixel from `first` to `last` of a row can show what is inside the bounds.
bool miss(const ScreenBounds& bounds, int first, int last, int row) {
  const Span columns = bounds.columns(row, 40);
  return last < columns.first || first >= columns.end;
}

TEST_CASE(
    "no ray through a pixel outside the bounds meets the sphere, wherever camera and sphere are") {
  Dice dice;
  int outside = 0;
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scene scene = any_scene(dice);
    const View<> view = view_of(scene.camera, 40, 30);
    const ScreenBounds bounds = screen_bounds(view, scene.sphere);
    for (int k = 0; k < 100; ++k) {
      const int column = dice.below(40);
      const int row = dice.below(30);
      const bool seen = is_met(view, scene.sphere, column + dice.between(-0.5, 0.5),
                               row + dice.between(-0.5, 0.5));
      if (seen) ++met;
      if (!miss(bounds, column, column, row)) continue;
      ++outside;
      REQUIRE_FALSE(seen);
    }
  }
  CHECK(outside > 50000);
  CHECK(met > 20000);
}

TEST_CASE(
    "the bounds are a pixel from the outline on all four sides, and those of a row are whole "
    "columns of the picture") {
  const View<> view =
      view_of({.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_y_degrees = 60}, 40, 30);
  for (const Point& center : {Point{0, 0, -5}, {1, 0.7, -5}, {-2, -1, -6}}) {
    const ScreenBounds bounds = screen_bounds(view, {center, 0.8});
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (double row = bounds.top; row <= bounds.bottom; row += 0.02) {
      for (double column = bounds.left; column <= bounds.right; column += 0.02) {
        if (!is_met(view, {center, 0.8}, column, row)) continue;
        left = std::min(left, column);
        right = std::max(right, column);
        top = std::min(top, row);
        bottom = std::max(bottom, row);
      }
    }
    CHECK(left - bounds.left == doctest::Approx(1).epsilon(0.1));
    CHECK(bounds.right - right == doctest::Approx(1).epsilon(0.1));
    CHECK(top - bounds.top == doctest::Approx(1).epsilon(0.1));
    CHECK(bounds.bottom - bottom == doctest::Approx(1).epsilon(0.1));
  }
  // One that reaches behind the eye has no edge on that side.
  const ScreenBounds below = screen_bounds(view, {{0, -1000, -1}, 999.5});
  CHECK(below.bottom == infinity<double>());
  CHECK(miss(below, 0, 39, 0));
  CHECK_FALSE(miss(below, 0, 39, 29));
  const auto columns = [](const ScreenBounds& bounds) {
    const Span span = bounds.columns(3, 40);
    return std::pair(span.first, span.end);
  };
  CHECK(columns({9.5, 20.5, 0, 9}) == std::pair(10, 21));
  CHECK(columns({-7, 70, 0, 9}) == std::pair(0, 40));
  CHECK(columns({-9, -3, 0, 9}) == std::pair(40, 40));
  CHECK(columns({41, 50, 0, 9}) == std::pair(40, 40));
  CHECK(columns({10, 20, 4, 9}) == std::pair(40, 40));
}

}  // namespace
}  // namespace texmap::test
