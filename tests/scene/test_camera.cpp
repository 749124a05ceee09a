// Tests of common/scene/camera.hpp: which ray a pixel looks along.
#include <doctest.h>

#include "scene/camera.hpp"

#include <numbers>
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

constexpr double tolerance = 4 * std::numeric_limits<double>::epsilon();

bool close(const Point& a, const Point& b) { return largest(a - b) <= tolerance; }

const Camera ahead{.eye = {0, 0, 5}, .target = {0, 0, 0}, .fov_y_degrees = 90};

TEST_CASE_TEMPLATE("the middle pixel looks straight ahead", Real, float, double, long double) {
  const View<> view = view_of(ahead, 5, 3);
  const Ray<Real> ray = ray_through(view, Real(2), Real(1));
  CHECK(ray.origin.x == Real(0));
  CHECK(ray.origin.y == Real(0));
  CHECK(ray.origin.z == Real(5));
  CHECK(abs(ray.direction.x) <= std::numeric_limits<Real>::epsilon());
  CHECK(abs(ray.direction.y) <= std::numeric_limits<Real>::epsilon());
  CHECK(ray.direction.z == Real(-1));
}

TEST_CASE("pixels look where geometry says, for both anchors") {
  struct Row {
    PixelAnchor anchor;
    double column, row;
    Point towards;
  };
  // 90 degrees, 4 x 2 pixels: at distance 1 the edges are x = -2 and 2, y = -1 and 1.
  const Row table[] = {
      {PixelAnchor::center, 0, 0, {-1.5, 0.5, -1}},
      {PixelAnchor::center, 3, 0, {1.5, 0.5, -1}},
      {PixelAnchor::center, 0, 1, {-1.5, -0.5, -1}},
      {PixelAnchor::center, 3, 1, {1.5, -0.5, -1}},
      {PixelAnchor::center, -0.5, -0.5, {-2, 1, -1}},
      {PixelAnchor::center, 3.5, 1.5, {2, -1, -1}},
      {PixelAnchor::center, 1.25, 0.5, {-0.25, 0, -1}},
      {PixelAnchor::corner, 0, 0, {-2, 1, -1}},
      {PixelAnchor::corner, 4, 2, {2, -1, -1}},
      {PixelAnchor::corner, 2, 1, {0, 0, -1}},
      {PixelAnchor::corner, 1, 0.5, {-1, 0.5, -1}},
  };
  for (const Row& row : table) {
    Camera camera = ahead;
    camera.anchor = row.anchor;
    CAPTURE(row.column);
    CAPTURE(row.row);
    CHECK(close(ray_through(view_of(camera, 4, 2), row.column, row.row).direction,
                normalize(row.towards)));
  }
}

TEST_CASE("a camera names the centers of its pixels unless told otherwise") {
  CHECK(Camera{}.anchor == PixelAnchor::center);
  CHECK(view_of(ahead, 4, 2).center_column == 1.5);
  CHECK(view_of(ahead, 4, 2).center_row == 0.5);
}

TEST_CASE(
    "right, up and backward are a right-handed frame of unit vectors, wherever the camera looks") {
  const Camera cameras[] = {
      ahead,
      {.eye = {0, 2, 8}, .target = {0, 0, 0}},
      {.eye = {5, 0, 0}, .target = {-1, 3, 2}},
      {.eye = {-3, 1e3, 4}, .target = {0, 0, 0}},
      {.eye = {1e6, 1, 1e6}, .target = {1e6 + 1, 0, 1e6 - 1}},
  };
  for (const Camera& camera : cameras) {
    const View<> view = view_of(camera, 40, 30);
    CHECK(close(cross(view.right, view.up), -view.forward));
    CHECK(abs(dot(view.right, view.up)) <= tolerance);
    CHECK(abs(dot(view.right, view.forward)) <= tolerance);
    CHECK(abs(dot(view.up, view.forward)) <= tolerance);
    CHECK(abs(length(view.right) - 1) <= tolerance);
    CHECK(abs(length(view.up) - 1) <= tolerance);
    CHECK(abs(length(view.forward) - 1) <= tolerance);
    CHECK(view.right.y == 0);
    CHECK(view.up.y > 0);
    CHECK(dot(view.forward, camera.target - camera.eye) > 0);
    CHECK(close(ray_through(view, 19.5, 14.5).direction, view.forward));
  }
}

TEST_CASE("looking along the axes, right and up are axes too") {
  CHECK(close(view_of(ahead, 1, 1).right, {1, 0, 0}));
  CHECK(close(view_of(ahead, 1, 1).up, {0, 1, 0}));
  const Camera east{.eye = {0, 0, 0}, .target = {7, 0, 0}};
  CHECK(close(view_of(east, 1, 1).right, {0, 0, 1}));
  CHECK(close(view_of(east, 1, 1).up, {0, 1, 0}));
}

TEST_CASE(
    "the field of view is the angle between the lower and the upper edge, and pixels are square") {
  for (const double fov : {1.0, 30.0, 60.0, 90.0, 120.0, 179.0}) {
    Camera camera = ahead;
    camera.fov_y_degrees = fov;
    for (const int width : {1, 3, 6, 100}) {
      const View<> view = view_of(camera, width, 6);
      const double middle = (width - 1) * 0.5;
      const Point top = ray_through(view, middle, -0.5).direction;
      const Point bottom = ray_through(view, middle, 5.5).direction;
      CAPTURE(fov);
      CAPTURE(width);
      CHECK(std::atan2(length(cross(top, bottom)), dot(top, bottom)) * 180 / std::numbers::pi ==
            doctest::Approx(fov).epsilon(1e-13));
      const Point edge = direction_through(
          view, width - 0.5, 2.5);  // as much wider as the picture is, in the plane ahead
      CHECK(dot(edge, view.right) ==
            doctest::Approx(std::tan(fov * std::numbers::pi / 360) * width / 6).epsilon(1e-14));
      CHECK(dot(edge, view.forward) == doctest::Approx(1).epsilon(1e-14));
    }
  }
}

TEST_CASE_TEMPLATE("every direction has unit length", Real, float, double, long double) {
  const View<> view =
      view_of({.eye = {0, 2, 8}, .target = {0, 0, 0}, .fov_y_degrees = 120}, 31, 17);
  for (int row = 0; row < 17; ++row) {
    for (int column = 0; column < 31; ++column) {
      const Vec3<Real> direction =
          ray_through(view, static_cast<Real>(column), static_cast<Real>(row)).direction;
      REQUIRE(abs(length(direction) - Real(1)) <= Real(3) * std::numeric_limits<Real>::epsilon());
    }
  }
}

TEST_CASE_TEMPLATE("a pack looks in each lane along the ray of a single pixel", T, float, double) {
  const View<> view = view_of({.eye = {0, 2, 8}, .target = {0, 0, 0}}, 31, 17);
  Dice dice;
  check_each_lane<Pack<T>>(
      [&view](const auto& column, const auto& row) { return ray_through(view, column, row); },
      any_pack<Pack<T>>(dice, 0, 31), any_pack<Pack<T>>(dice, 0, 17));
}

}  // namespace
}  // namespace texmap::test
