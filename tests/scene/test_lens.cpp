// Tests of common/scene/camera.hpp, which ray a pixel looks along, and of scene/lens.hpp: where the
// rays of a pixel's samples start and what they meet. That a view's vectors are right wherever the
// camera looks, tests/extremes searches.
#include <doctest.h>

#include <numbers>

#include "sampling/sampled_numbers.hpp"
#include "scene/camera.hpp"
#include "scene/lens.hpp"

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

const View<> view = view_of({.eye = {0, 0, 12}, .target = {0, 0, 0}, .fov_y_degrees = 20}, 64, 36);
constexpr double column = 20, row = 30;

/// Calls `check(ray, second)` for 1024 samples of a pixel; `second` is the second pair of numbers
/// of the sample, which a lens or an exposure takes.
template <class Check>
void for_each_ray(const Lens& lens, std::uint32_t pairs, const Check& check) {
  for (std::uint32_t i = 0; i < 1024; ++i) {
    SampledNumbers<double> random{{SamplerKind::sobol, 1024}, i};
    SampledNumbers<double> again{{SamplerKind::sobol, 1024}, i, 1};
    const Ray<double> ray = lens.ray(view, PixelPlace<double>{column, row}, random);
    REQUIRE(random.dimension == pairs);
    check(ray, again.next_2d());
  }
}

/// Where a ray is in the picture, in pixels from the middle of its own.
struct InPixel {
  double column, row;
};
InPixel in_pixel(const Ray<double>& ray) {
  const Point seen = ray.direction * (1 / dot(ray.direction, view.forward));
  return {dot(seen, view.right) / view.pixel + view.center_column - column,
          view.center_row - dot(seen, view.up) / view.pixel - row};
}

TEST_CASE("through a pinhole every sample looks from the eye, evenly through all of its pixel") {
  int quarters[4] = {};
  for_each_ray({}, 1, [&](const Ray<double>& ray, const Point2<double>&) {
    REQUIRE(largest(ray.origin - view.eye) == 0);
    const InPixel at = in_pixel(ray);
    REQUIRE(std::abs(at.column) <= 0.5 + 1e-9);
    REQUIRE(std::abs(at.row) <= 0.5 + 1e-9);
    ++quarters[(at.column < 0 ? 0 : 1) + (at.row < 0 ? 0 : 2)];
  });
  for (const int count : quarters) CHECK(count == 256);
  CHECK_FALSE(Lens{}.blurs());
}

TEST_CASE(
    "rays start anywhere on the lens, which is as wide as its angle says, and meet in the point in "
    "focus") {
  for (const double degrees : {1e-9, 0.5, 3.0, 90.0}) {
    const Lens lens{.defocus_degrees = degrees, .focus_distance = 8};
    CHECK(lens.blurs());
    const double radius = 8 * std::tan(degrees / 2 * (std::numbers::pi / 180));
    const auto at_focus = [&](const Ray<double>& ray) {
      return ray.origin + ray.direction * (8 / dot(ray.direction, view.forward));
    };
    const Point in_focus = at_focus(ray_through(view, column, row));
    for_each_ray(lens, 2, [&](const Ray<double>& ray, const Point2<double>& second) {
      const auto on_lens = uniform_disk(second);
      const Point offset = ray.origin - view.eye;
      REQUIRE(std::abs(dot(offset, view.right) - radius * on_lens.x) <= 1e-14 * (radius + 1));
      REQUIRE(std::abs(dot(offset, view.up) - radius * on_lens.y) <= 1e-14 * (radius + 1));
      REQUIRE(std::abs(dot(offset, view.forward)) < 1e-12);
      REQUIRE(largest(at_focus(ray) - in_focus) < 0.51 * view.pixel * 8);
    });
  }
}

TEST_CASE("a scene that moves up is seen by an eye that moves down as far") {
  for (const double shift : {5e-324, 1e-300, -1e-300, 1e-6, 1.0, -1.0, -0.5, 100.0, -100.0}) {
    CAPTURE(shift);
    const Lens lens{.shift = shift};
    CHECK(lens.blurs());
    for_each_ray(lens, 2, [&](const Ray<double>& ray, const Point2<double>& second) {
      REQUIRE(ray.origin.y == view.eye.y - shift * second.u);
      REQUIRE((ray.origin.x == view.eye.x && ray.origin.z == view.eye.z));
    });
  }
  CHECK_FALSE(Lens{.shift = -0.0}.blurs());
}

}  // namespace
}  // namespace texmap::test
