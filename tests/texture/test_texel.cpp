// Tests of common/texture/texel.hpp: from a coordinate to a texel that is safe to index with.
#include <doctest.h>

#include "published/uv.hpp"
#include "support/whole_numbers.hpp"
#include "texture/texel.hpp"

namespace texmap::test {
namespace {

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
    const auto last = static_cast<Real>(n - 1);
    CHECK(test::texel_index(nan, n) == Real(0));
    CHECK(test::texel_index(-infinity<Real>(), n) == Real(0));
    CHECK(test::texel_index(infinity<Real>(), n) == last);
    CHECK(clamp_number(nan, n) == 0);
    CHECK(clamp_number(static_cast<Real>(n), n) == n - 1);
  }
}

TEST_CASE("the lecture's rounding is that of its program") {
  for (int i = 0; i <= 100000; ++i) {
    const double v = i / 100000.0;
    REQUIRE(4095 - static_cast<int>(test::texel_index(v, 4096, TexelRounding::lecture)) ==
            published::row_lecture(v, 4096));
  }
}

}  // namespace
}  // namespace texmap::test
