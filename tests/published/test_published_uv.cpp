// Tests of common/published/uv.hpp: the published formulas as printed, and where they fail.
#include <doctest.h>

#include "published/uv.hpp"

#include <numbers>
#include "support/whole_numbers.hpp"
#include "texture/texel.hpp"
#include "texture/uv.hpp"

namespace texmap {
namespace {

template <class Real>
bool close(const Uv<Real>& uv, double u, double v) {
  const Real tolerance = std::max(Real(2) * std::numeric_limits<Real>::epsilon(),
                                  Real(1e-16L));  // the table is in double
  return abs(uv.u - Real(u)) <= tolerance && abs(uv.v - Real(v)) <= tolerance;
}

TEST_CASE_TEMPLATE(
    "of a vector longer than 1 only the stable formula and the daily exercise's have a v", Real,
    float, double, long double) {
  const auto is_nan = [](Real x) { return x != x; };
  const Vec3<Real> p{1, 2, 3};
  const Uv<Real> uv = uv_rtiow(p);
  CHECK(
      close(published::uv_daily(p), static_cast<double>(1 - uv.u), static_cast<double>(1 - uv.v)));
  CHECK(is_nan(published::uv_next_week_v4(p).v));
  const Real beyond = std::nextafter(Real(1), Real(2));
  for (const Real pole : {beyond, -beyond}) {
    const Vec3<Real> at_pole{0, pole, 0};
    CHECK_FALSE(is_nan(published::uv_daily(at_pole).v));
    CHECK(is_nan(published::uv_one_weekend_2020(at_pole).v));
    CHECK(is_nan(published::uv_next_week_v4(at_pole).v));
    CHECK(is_nan(published::uv_lecture(at_pole).v));
    CHECK(uv_rtiow(at_pole).v == (pole > Real(0) ? Real(1) : Real(0)));
  }
}

TEST_CASE_TEMPLATE(
    "at the seam all published formulas reach u = 1, where the stable one stays below", Real, float,
    double, long double) {
  const Real tiny = std::numeric_limits<Real>::denorm_min();
  CHECK(published::uv_daily(Vec3<Real>{-1, 0, 0}).u == Real(1));
  CHECK(published::uv_one_weekend_2020(Vec3<Real>{-1, 0, -Real(0)}).u == Real(1));
  CHECK(published::uv_next_week_v4(Vec3<Real>{-1, 0, -Real(0)}).u == Real(1));
  CHECK(published::uv_lecture(Vec3<Real>{-tiny, 0, 1}).u == Real(1));
  CHECK(uv_rtiow(Vec3<Real>{-1, 0, -Real(0)}).u == Real(0));
  CHECK(uv_rtiow(Vec3<Real>{-1, 0, -tiny}).u == below_one<Real>());
}

TEST_CASE("near the pole Next Week's rows are quantized in float, and the stable ones are not") {
  // The point is a thousandth of a row from the pole; the float before 1 is half a row away.
  const Vec3<float> p{1e-6F, -1, 0};
  const double exact = 1e-6 / std::numbers::pi;
  CHECK(published::uv_next_week_v4(p).v == 0);
  CHECK(static_cast<double>(uv_rtiow(p).v) == doctest::Approx(exact).epsilon(1e-6));
}

TEST_CASE_TEMPLATE(
    "on the edges between rows One Weekend 2020 counts and then turns over, and Next Week turns "
    "over first",
    Real, float, double, long double) {
  constexpr int n = 4096;
  int one_weekend = 0;
  int next_week = 0;
  for (int k = 0; k <= n; ++k) {
    const Real v = static_cast<Real>(k) / Real(n);
    const int row = n - 1 - static_cast<int>(test::texel_index(v, n));
    if (published::row_one_weekend_2020(v, n) != row) ++one_weekend;
    if (published::row_next_week_v4(v, n) != row) ++next_week;
  }
  CHECK(one_weekend == 0);
  CHECK(next_week == 4095);
}

TEST_CASE_TEMPLATE("off the edges One Weekend 2020 and Next Week find the same rows", Real, float,
                   double, long double) {
  constexpr int n = 4096;
  for (int k = 0; k < n; ++k) {
    const Real v = (static_cast<Real>(k) + Real(0.5)) / Real(n);
    REQUIRE(published::row_one_weekend_2020(v, n) == n - 1 - k);
    REQUIRE(published::row_next_week_v4(v, n) == n - 1 - k);
  }
}

}  // namespace
}  // namespace texmap
