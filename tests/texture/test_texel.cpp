// Tests of common/texture/texel.hpp: from a coordinate to a texel that is safe to index with.
#include <doctest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "number/kinds/pack.hpp"
#include "published/uv.hpp"
#include "support/whole_numbers.hpp"
#include "texture/texel.hpp"

namespace texmap::test {
namespace {

TEST_CASE_TEMPLATE("a coordinate of 1 is in the last texel", Real, float, double, long double) {
  for (const int n : {1, 2, 3, 8192, 1 << 24})
    CHECK(test::texel_index(Real(1), n) == static_cast<Real>(n - 1));
}

TEST_CASE_TEMPLATE("the coordinate below 1 is in the last texel for every size", Real, float,
                   double, long double) {
  int wrong = 0;
  for (int n = 1; n <= 65536; ++n) {
    if (test::texel_index(below_one<Real>(), n) != static_cast<Real>(n - 1)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("texels are half-open: each holds its lower edge", Real, float, double,
                   long double) {
  struct Row {
    double u;
    int n, index;
  };
  const Row table[] = {
      {0, 4, 0},     {0.125, 4, 0}, {0.25, 4, 1},  {0.375, 4, 1}, {0.5, 4, 2}, {0.75, 4, 3},
      {0.875, 4, 3}, {0, 1, 0},     {0.999, 1, 0}, {0.5, 2, 1},   {0.5, 3, 1}, {0.75, 3, 2},
  };
  for (const Row& row : table) {
    CAPTURE(row.u);
    CHECK(test::texel_index(static_cast<Real>(row.u), row.n) == static_cast<Real>(row.index));
  }
  CHECK(test::texel_index(std::nextafter(Real(0.25), Real(0)), 4) == Real(0));
  CHECK(test::texel_index(std::nextafter(Real(0.75), Real(0)), 4) == Real(2));
  for (int k = 0; k < 4096; ++k)
    REQUIRE(test::texel_index(static_cast<Real>(k) / Real(4096), 4096) == static_cast<Real>(k));
}

TEST_CASE_TEMPLATE("no coordinate leaves the image: NaN gives 0 and the rest is clamped", Real,
                   float, double, long double) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const int n : {1, 2, 8192, 1 << 24}) {
    for (const TexelRounding rounding : {TexelRounding::floor, TexelRounding::lecture}) {
      CHECK(test::texel_index(nan, n, rounding) == Real(0));
      CHECK(test::texel_index(-infinity<Real>(), n, rounding) == Real(0));
      CHECK(test::texel_index(Real(-1e30L), n, rounding) == Real(0));
      CHECK(test::texel_index(Real(-0.1L), n, rounding) == Real(0));
    }
    const auto last = static_cast<Real>(n - 1);
    CHECK(test::texel_index(infinity<Real>(), n) == last);
    CHECK(test::texel_index(Real(1e30L), n) == last);
    CHECK(test::texel_index(Real(1.5), n) == last);
    CHECK(test::clamp_index(nan, n) == Real(0));
    CHECK(test::clamp_index(static_cast<Real>(n), n) == last);
  }
}

TEST_CASE("every pattern of 32 bits is a coordinate that is safe to index with") {
  std::uint32_t bits = 1;
  int outside = 0;
  for (int i = 0; i < 300000; ++i) {
    bits = bits * 1664525U + 1013904223U;
    const auto u = std::bit_cast<float>(bits);
    // The conversions themselves are what the sanitizer watches.
    const int indices[] = {static_cast<int>(test::texel_index(u, 8192)),
                           static_cast<int>(test::texel_index(u, 8192, TexelRounding::lecture))};
    for (const int index : indices) {
      if (index < 0 || index > 8191) ++outside;
    }
  }
  CHECK(outside == 0);
}

TEST_CASE("every texel has the same share of the coordinates, first and last too") {
  for (const int n : {1, 2, 3, 7, 8192}) {
    std::vector<int> hits(static_cast<std::size_t>(n));
    for (int i = 0; i < 100 * n; ++i)
      ++hits[static_cast<std::size_t>(test::texel_index((i + 0.5) / (100.0 * n), n))];
    int uneven = 0;
    for (const int count : hits) uneven += count == 100 ? 0 : 1;
    CHECK(uneven == 0);
  }
}

TEST_CASE_TEMPLATE("the lecture's rounding gives n - 1 texels a share and the last one none", Real,
                   float, double, long double) {
  struct Row {
    double u;
    int n, index;
  };
  const Row table[] = {{0, 5, 0}, {0.25, 5, 1}, {0.2, 5, 0}, {0.5, 5, 2}, {0.99, 5, 3},
                       {1, 5, 4}, {0.5, 1, 0},  {1, 1, 0},   {0.5, 2, 0}, {1, 2, 1}};
  for (const Row& row : table) {
    CAPTURE(row.u);
    CHECK(test::texel_index(static_cast<Real>(row.u), row.n, TexelRounding::lecture) ==
          static_cast<Real>(row.index));
  }
  CHECK(test::texel_index(below_one<Real>(), 8192, TexelRounding::lecture) == Real(8190));
}

TEST_CASE("the lecture's rounding is that of its program") {
  for (int i = 0; i <= 100000; ++i) {
    const double v = i / 100000.0;
    REQUIRE(4095 - static_cast<int>(test::texel_index(v, 4096, TexelRounding::lecture)) ==
            published::row_lecture(v, 4096));
  }
}

TEST_CASE_TEMPLATE("a pack finds in each lane the texel that a single number finds", T, float,
                   double) {
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const std::vector<T> table = {
      nan,    0,      1, below_one<T>(), T(0.25), T(-0.1), T(1.1), infinity<T>(), -infinity<T>(),
      T(0.7), T(1e30)};
  for (std::size_t start = 0; start < table.size(); ++start) {
    const auto at = [&](std::size_t i) { return table[(start + i) % table.size()]; };
    const auto u = from_lanes<Pack<T>>(at);
    for (std::size_t i = 0; i < lanes<Pack<T>>; ++i) {
      CHECK(lane(test::texel_index(u, 1000), i) == test::texel_index(at(i), 1000));
      CHECK(lane(test::texel_index(u, 1000, TexelRounding::lecture), i) ==
            test::texel_index(at(i), 1000, TexelRounding::lecture));
    }
  }
}

}  // namespace
}  // namespace texmap::test
