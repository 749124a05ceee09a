// Tests of common/sampling/directions.hpp: lengths, densities and poles.
#include <doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <type_traits>
#include <vector>

#include "sampling/directions.hpp"
#include "sampling/sampled_numbers.hpp"
#include "sampling/samplers.hpp"
#include "support/whole_numbers.hpp"

namespace texmap::test {
namespace {

/// Errors in units of the number's roundoff: half a step above 1.
template <class Real>
constexpr double roundoff = static_cast<double>(std::numeric_limits<Scalar<Real>>::epsilon()) / 2;

/// How many times the number's roundoff the length of a normal may be off: the tests' are double's.
template <class Real>
constexpr double normals_are_off =
    roundoff<Real> < roundoff<double> ? 2 * roundoff<double> / roundoff<Real> : 1;

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

TEST_CASE_TEMPLATE("the circle: cosine and sine of an eighth, within the stated error", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  double worst = 0;
  const auto judge = [](const OnCircle<Real>& found, double turns) {
    double error = 0;
    const long double angle = 2 * pi_digits * static_cast<long double>(turns);
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      const long double cosine_error =
          std::abs(static_cast<long double>(lane(found.cosine, i)) - std::cos(angle));
      const long double sine_error =
          std::abs(static_cast<long double>(lane(found.sine, i)) - std::sin(angle));
      error = std::max(error, static_cast<double>(std::max(cosine_error, sine_error)));
    }
    return error / roundoff<Real>;
  };
  for (int i = 0; i < 1 << 16; ++i) {
    const double turns = i / 65536.0 + 0x1p-24 * (i % 256);
    const double eighth = (turns - 0.5) / 4;
    worst = std::max(worst, judge(on_circle_eighth(Real(eighth)), eighth));
  }
  MESSAGE("worst error, in unit roundoffs: " << worst);
  CHECK(worst < 2);
}

TEST_CASE_TEMPLATE(
    "the disk: every point is inside, and its radius and height are a right triangle's", Real,
    TEXMAP_SAMPLED_NUMBERS) {
  const auto judge = [](const Point2<Real>& sample) {
    const OnDisk<Real> disk = uniform_disk(sample);
    const auto x = static_cast<double>(lane(disk.x, 0));
    const auto y = static_cast<double>(lane(disk.y, 0));
    const auto radius = static_cast<double>(lane(disk.radius, 0));
    const auto height = static_cast<double>(lane(disk.height, 0));
    REQUIRE(radius < 1);
    REQUIRE(height > 3e-4);
    REQUIRE(std::abs(std::hypot(x, y) - radius) <= 4 * roundoff<Real> + 1e-15);
    REQUIRE(std::abs(radius * radius + height * height - 1) <= 4 * roundoff<Real> + 1e-15);
  };
  for (const Point2<Real>& sample : hard_samples<Real>()) judge(sample);
  for (std::uint32_t i = 0; i < 20000; ++i) judge(sample_number<Real>(i));
}

TEST_CASE("the disk: equal areas hold equally many points, and neighbours stay neighbours") {
  std::array<double, 64> bins{};  // 8 rings by 8 sectors, all of the same area
  constexpr std::uint32_t side = 512;
  double farthest = 0;
  for (std::uint32_t row = 0; row < side; ++row) {
    OnDisk<double> before{};
    for (std::uint32_t column = 0; column < side; ++column) {
      const OnDisk<double> disk = uniform_disk<double>({(column + 0.5) / side, (row + 0.5) / side});
      const double turns = std::atan2(disk.y, disk.x) / (2 * std::numbers::pi) + 0.5;
      const auto sector = std::min<std::size_t>(static_cast<std::size_t>(turns * 8), 7);
      bins[static_cast<std::size_t>(disk.radius * disk.radius * 8) * 8 + sector] += 1;
      if (column > 0)
        farthest = std::max(farthest, std::hypot(disk.x - before.x, disk.y - before.y));
      before = disk;
    }
  }
  for (const double count : bins) CHECK(std::abs(count / (side * side / 64.0) - 1) < 0.06);
  CHECK(farthest * side < 3);
}

TEST_CASE_TEMPLATE("directions have unit length", Real, TEXMAP_SAMPLED_NUMBERS) {
  double worst = 0;
  const auto judge = [&](const Vec3<Real>& direction) {
    const auto x = static_cast<long double>(lane(direction.x, 0));
    const auto y = static_cast<long double>(lane(direction.y, 0));
    const auto z = static_cast<long double>(lane(direction.z, 0));
    const auto error = static_cast<double>(std::abs(std::sqrt(x * x + y * y + z * z) - 1));
    worst = std::max(worst, error / roundoff<Real>);
  };
  for (const Point2<Real>& sample : hard_samples<Real>()) {
    for (const Point& normal : hard_normals())
      judge(cosine_direction(number_cast<Real>(normal), sample));
  }
  const Vec3<Real> up{Real(0), Real(1), Real(0)};
  for (std::uint32_t i = 0; i < 20000; ++i) judge(cosine_direction(up, sample_number<Real>(i)));
  const double of_the_normal = normals_are_off<Real>;
  MESSAGE("worst error of a length, in unit roundoffs: " << worst);
  CHECK(worst < 6 * of_the_normal);
}

TEST_CASE_TEMPLATE("the frame is right-handed and square at every normal, poles included", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  double worst = 0;
  for (const Point& exact : hard_normals()) {
    const Vec3<Real> normal = number_cast<Real>(exact);
    const Frame<Real> frame = frame_about(normal);
    const Vec3<Real> off = cross(frame.right, frame.up) - normal;
    for (const Real& error :
         {dot(frame.right, frame.up), dot(frame.right, normal), dot(frame.up, normal), off.x, off.y,
          off.z, length(frame.right) - Real(1), length(frame.up) - Real(1)}) {
      worst = std::max(worst, std::abs(static_cast<double>(lane(error, 0))));
    }
  }
  const double of_the_normal = normals_are_off<Real>;
  CHECK(worst < 8 * of_the_normal * roundoff<Real>);
}

TEST_CASE_TEMPLATE("scattered directions leave the surface, at whichever normal", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  double lowest = 1;
  for (const Point& exact : hard_normals()) {
    const Vec3<Real> normal = number_cast<Real>(exact);
    for (const Point2<Real>& sample : hard_samples<Real>()) {
      lowest = std::min(
          lowest, static_cast<double>(lane(dot(normal, cosine_direction(normal, sample)), 0)));
    }
  }
  CHECK(lowest > 3e-4);
}

TEST_CASE_TEMPLATE("scattered directions have the density cosine / pi about the normal", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for (const Point& exact : {Point{0, 0, 1}, Point{0, 0, -1}, Point{0, 1, 0}, Point{0, -1, 0},
                             Point{0.36, 0.48, -0.8}}) {
    const Vec3<Real> normal = number_cast<Real>(exact);
    const Frame<Real> frame = frame_about(normal);
    constexpr std::uint32_t count = 1 << 14;
    double cosines = 0;
    std::array<double, 32> bins{};  // 8 rings of equal squared cosine by 4 sectors
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3<Real> direction = cosine_direction(normal, sample_number<Real>(i));
      const auto cosine = static_cast<double>(lane(dot(direction, normal), 0));
      const bool right = lane(dot(direction, frame.right), 0) > 0;
      const bool up = lane(dot(direction, frame.up), 0) > 0;
      cosines += cosine;
      const auto ring = std::min<std::size_t>(static_cast<std::size_t>(cosine * cosine * 8), 7);
      bins[ring * 4 + (right ? 2U : 0U) + (up ? 1U : 0U)] += 1;
    }
    CHECK(std::abs(cosines / count - 2.0 / 3) < 1e-3);
    for (const double found : bins) CHECK(std::abs(found / (count / 32.0) - 1) < 0.1);
  }
}

TEST_CASE_TEMPLATE("every lane of a pack goes where a single number goes", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  const Sampler sampler(SamplerKind::sobol, 64);
  using Single = Scalar<Real>;
  const Vec3<Single> normal{Single(0.36), Single(0.48), Single(-0.8)};
  const Vec3<Real> normals{Real(normal.x), Real(normal.y), Real(normal.z)};
  for (std::uint32_t i = 0; i < 64; ++i) {
    const Point2<Real> pack = sampler.pair<Real>(test::hash_row<Real>(16, 5), i, 3);
    const Vec3<Real> scattered = cosine_direction(normals, pack);
    for (std::size_t at = 0; at < lanes<Real>; ++at) {
      const Point2<Single> sample{lane(pack.u, at), lane(pack.v, at)};
      const Vec3<Single> scattered_one = cosine_direction(normal, sample);
      REQUIRE(lane(scattered.x, at) == scattered_one.x);
      REQUIRE(lane(scattered.y, at) == scattered_one.y);
      REQUIRE(lane(scattered.z, at) == scattered_one.z);
    }
  }
}

}  // namespace
}  // namespace texmap::test
