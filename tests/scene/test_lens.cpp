// Tests of scene/lens.hpp: where the rays of a pixel's samples start and what they meet.
#include <doctest.h>

#include "sampling/sampled_numbers.hpp"

#include <numbers>
#include "sampling/samplers.hpp"
#include "scene/lens.hpp"
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

/// The numbers of one sample after another, the same whoever draws them.
template <class Real>
struct SampledNumbers {
  Sampler sampler{SamplerKind::sobol, 1024};
  std::uint32_t sample = 0;
  std::uint32_t dimension = 0;

  [[nodiscard]] Point2<Real> next_2d() {
    return sampler.pair<Real>(UInt<Real>(hash_bits(7U)), sample, dimension++);
  }
};

const View<> view = view_of({.eye = {0, 0, 12}, .target = {0, 0, 0}, .fov_y_degrees = 20}, 64, 36);
constexpr double column = 20, row = 30;

/// The rays of 1024 samples of a pixel.
template <class Check>
void for_each_ray(const Lens& lens, const Check& check) {
  for (std::uint32_t i = 0; i < 1024; ++i) {
    SampledNumbers<double> random{.sample = i};
    const Ray<double> ray = lens.ray(view, PixelPlace<double>{column, row}, random);
    check(ray, random.dimension);
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
  for_each_ray({}, [&](const Ray<double>& ray, std::uint32_t used) {
    CHECK(used == 1);
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
  const Lens lens{.defocus_degrees = 3, .focus_distance = 8};
  CHECK(lens.blurs());
  const double radius = 8 * std::tan(1.5 * std::numbers::pi / 180);
  const auto at_focus = [&](const Ray<double>& ray) {
    return ray.origin + ray.direction * (8 / dot(ray.direction, view.forward));
  };
  const Point in_focus = at_focus(ray_through(view, column, row));
  double widest = 0;
  Point sum{};
  for_each_ray(lens, [&](const Ray<double>& ray, std::uint32_t used) {
    CHECK(used == 2);
    const Point offset = ray.origin - view.eye;
    widest = std::max(widest, length(offset));
    sum = sum + offset;
    REQUIRE(std::abs(dot(offset, view.forward)) < 1e-12);
    REQUIRE(largest(at_focus(ray) - in_focus) < 0.51 * view.pixel * 8);
  });
  CHECK(widest < radius * (1 + 1e-12));
  CHECK(widest > 0.99 * radius);
  CHECK(length(sum) / 1024 < 0.01 * radius);
}

TEST_CASE("a ray starts at the place on the lens that its second pair of numbers names") {
  for (const double degrees : {1e-9, 0.5, 3.0, 90.0}) {
    const Lens lens{.defocus_degrees = degrees, .focus_distance = 8};
    CHECK(lens.blurs());
    const double radius = 8 * std::tan(degrees / 2 * (std::numbers::pi / 180));
    for (std::uint32_t i = 0; i < 64; ++i) {
      SampledNumbers<double> again{.sample = i, .dimension = 1};
      const auto on_lens = uniform_disk(again.next_2d());
      SampledNumbers<double> random{.sample = i};
      const Ray<double> ray = lens.ray(view, PixelPlace<double>{column, row}, random);
      const Point offset = ray.origin - view.eye;
      REQUIRE(std::abs(dot(offset, view.right) - radius * on_lens.x) <= 1e-14 * (radius + 1));
      REQUIRE(std::abs(dot(offset, view.up) - radius * on_lens.y) <= 1e-14 * (radius + 1));
      REQUIRE(random.dimension == 2);
    }
  }
}

TEST_CASE("a shift of any size and sign is an exposure, and lowers the eye by a part of itself") {
  for (const double shift : {5e-324, 1e-300, -1e-300, 1e-6, 1.0, -1.0, -0.5, 100.0, -100.0}) {
    CAPTURE(shift);
    const Lens lens{.shift = shift};
    CHECK(lens.blurs());
    for (std::uint32_t i = 0; i < 64; ++i) {
      SampledNumbers<double> again{.sample = i, .dimension = 1};
      const double expected = view.eye.y - shift * again.next_2d().u;
      SampledNumbers<double> random{.sample = i};
      const Ray<double> ray = lens.ray(view, PixelPlace<double>{column, row}, random);
      REQUIRE(random.dimension == 2);
      REQUIRE(ray.origin.y == expected);
      REQUIRE((ray.origin.x == view.eye.x && ray.origin.z == view.eye.z));
    }
  }
  CHECK_FALSE(Lens{.shift = -0.0}.blurs());
}

TEST_CASE("a scene that moves up is seen by an eye that moves down as far") {
  const Lens lens{.shift = 0.5};
  CHECK(lens.blurs());
  double sum = 0;
  for_each_ray(lens, [&](const Ray<double>& ray, std::uint32_t used) {
    CHECK(used == 2);
    const double fallen = view.eye.y - ray.origin.y;
    REQUIRE(fallen >= 0);
    REQUIRE(fallen <= 0.5);
    sum += fallen;
  });
  CHECK(sum / 1024 == doctest::Approx(0.25).epsilon(0.01));
}

TEST_CASE_TEMPLATE("each lane of a pack looks through its own pixel from its own place on the lens",
                   T, float, double) {
  Dice dice;
  const Lens lens{.defocus_degrees = 3, .focus_distance = 8, .shift = 0.5};
  check_each_lane<Pack<T>>(
      [&lens]<class Real>(const Real& at_column, const Real& at_row) {
        SampledNumbers<Real> random{.sample = 5};
        return lens.ray(number_cast<Real>(view), PixelPlace<Real>{at_column, at_row}, random);
      },
      any_pack<Pack<T>>(dice, 0, 64), any_pack<Pack<T>>(dice, 0, 36));
}

}  // namespace
}  // namespace texmap::test
