// Tests of common/sampling/directions.hpp: lengths, densities and poles.
#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sampling/directions.hpp"
#include "sampling/hash.hpp"

namespace texmap::test {
namespace {

/// The unit roundoff, but at least that of double: the tests' normals have no more digits.
template <class Real>
constexpr double roundoff =
    static_cast<double>(std::max<long double>(std::numeric_limits<Real>::epsilon(), 0x1p-52L)) / 2;

/// Sample i of `count`, evenly spread; at most 2^24.
template <class Real>
Point2<Real> sample_number(std::uint32_t i) {
  return {unit_interval<Real>(UInt<Real>(i * 0xc13fa9a9U)),
          unit_interval<Real>(UInt<Real>(i * 0x91e10da5U))};
}

/// Samples in which something could fail: corners, edges, the middle and the diagonals.
template <class Real>
std::vector<Point2<Real>> hard_samples() {
  std::vector<Point2<Real>> all;
  const double last = 1 - 0x1p-24;
  for (const double u : {0.0, 0x1p-24, 0.25, 0.5 - 0x1p-24, 0.5, 0.5 + 0x1p-24, 0.75, last}) {
    for (const double v : {0.0, 0x1p-24, 0.25, 0.5 - 0x1p-24, 0.5, 0.5 + 0x1p-24, 0.75, last})
      all.push_back({Real(u), Real(v)});
  }
  const Real below = below_one<Real>();
  all.push_back({below, below});
  all.push_back({below, Real(0)});
  all.push_back({(Real(1) - Real(0x1p-24)) * Real(0.5), (Real(1) - Real(0x1p-24)) * Real(0.5)});
  return all;
}

/// Unit normals: the axes both ways, off the poles by less than a step, and some of no interest.
std::vector<Point> hard_normals() {
  std::vector<Point> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},         {0, -1, 0},
                            {0, 0, 1}, {0, 0, -1}, {0, 0.0, -0.0 - 1}};
  for (const double small : {1e-3, 1e-6, 1e-9, 1e-20}) {
    for (const double z : {-1.0, 1.0, 0.0}) {
      all.push_back(normalize(Point{small, -small, z == 0 ? -small * small : z}));
      all.push_back(normalize(Point{0, small, z == 0 ? small : z}));
    }
  }
  for (std::uint32_t i = 0; i < 500; ++i) {
    const Point pole{0, 0, i % 2 == 0 ? 1.0 : -1.0};
    all.push_back(cosine_direction(pole, sample_number<double>(i)));
  }
  return all;
}

TEST_CASE("the disk: neighbours stay neighbours") {
  constexpr std::uint32_t side = 512;
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 1; column < side; ++column) {
      const auto at = [&](double u) {
        return uniform_disk<double>({u / side, (row + 0.5) / side});
      };
      const OnDisk<double> here = at(column + 0.5), before = at(column - 0.5);
      REQUIRE(std::hypot(here.x - before.x, here.y - before.y) * side < 3);
    }
  }
}

TEST_CASE_TEMPLATE(
    "at every normal the frame is right-handed and square, and directions of unit length leave the "
    "surface",
    Real, float, double, long double) {
  for (const Point& exact : hard_normals()) {
    const Vec3<Real> normal = number_cast<Real>(exact);
    const Frame<Real> frame = frame_about(normal);
    const Vec3<Real> off = cross(frame.right, frame.up) - normal;
    for (const Real& error :
         {dot(frame.right, frame.up), dot(frame.right, normal), dot(frame.up, normal), off.x, off.y,
          off.z, length(frame.right) - Real(1), length(frame.up) - Real(1)})
      REQUIRE(std::abs(static_cast<double>(error)) < 8 * roundoff<Real>);
    for (const Point2<Real>& sample : hard_samples<Real>()) {
      const Vec3<Real> direction = cosine_direction(normal, sample);
      REQUIRE(std::abs(static_cast<double>(length(direction)) - 1) < 8 * roundoff<Real>);
      REQUIRE(static_cast<double>(dot(normal, direction)) > 3e-4);
    }
  }
}

TEST_CASE_TEMPLATE("scattered directions have the density cosine / pi about the normal", Real,
                   float, double, long double) {
  for (const Point& exact : {Point{0, 0, 1}, Point{0, 0, -1}, Point{0, 1, 0}, Point{0, -1, 0},
                             Point{0.36, 0.48, -0.8}}) {
    const Vec3<Real> normal = number_cast<Real>(exact);
    const Frame<Real> frame = frame_about(normal);
    constexpr std::uint32_t count = 1 << 14;
    double cosines = 0;
    std::array<double, 32> bins{};  // 8 rings of equal squared cosine by 4 sectors
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3<Real> direction = cosine_direction(normal, sample_number<Real>(i));
      const auto cosine = static_cast<double>(dot(direction, normal));
      const bool right = dot(direction, frame.right) > 0;
      const bool up = dot(direction, frame.up) > 0;
      cosines += cosine;
      const auto ring = std::min<std::size_t>(static_cast<std::size_t>(cosine * cosine * 8), 7);
      bins[ring * 4 + (right ? 2U : 0U) + (up ? 1U : 0U)] += 1;
    }
    CHECK(std::abs(cosines / count - 2.0 / 3) < 1e-3);
    for (const double found : bins) CHECK(std::abs(found / (count / 32.0) - 1) < 0.1);
  }
}

}  // namespace
}  // namespace texmap::test
