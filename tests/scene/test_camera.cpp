// Tests of common/scene/camera.hpp: which ray a pixel looks along. That a view's vectors are right
// wherever the camera looks, tests/extremes searches.
#include <doctest.h>

#include <numbers>

#include "scene/camera.hpp"

namespace texmap::test {
namespace {

const Camera ahead{.eye = {0, 0, 5}, .target = {0, 0, 0}, .fov_y_degrees = 90};

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
  CHECK(Camera{}.anchor == PixelAnchor::center);
  CHECK(largest(ray_through(view_of(ahead, 5, 3), 2.0, 1.0).origin - ahead.eye) == 0);
  for (const Row& row : table) {
    Camera camera = ahead;
    camera.anchor = row.anchor;
    CAPTURE(row.column);
    CAPTURE(row.row);
    const Point seen = ray_through(view_of(camera, 4, 2), row.column, row.row).direction;
    CHECK(largest(seen - normalize(row.towards)) <= 4 * std::numeric_limits<double>::epsilon());
  }
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

}  // namespace
}  // namespace texmap::test
