// Tests of common/published/uv.hpp and sphere.hpp: the published formulas as printed, where they
// hold, and where they fail or differ from the stable ones.
#include <doctest.h>

#include <algorithm>
#include <numbers>

#include "published/sphere.hpp"
#include "published/uv.hpp"
#include "support/whole_numbers.hpp"
#include "texture/texel.hpp"
#include "texture/uv.hpp"

namespace texmap::test {
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

const Sphere<> unit{{0, 0, 0}, 1};

/// A ray along -z from `away` radii in front of the unit sphere, `impact` away from its center.
template <class Real>
Ray<Real> ray_from(double away, double impact) {
  return {{Real(impact), Real(0), Real(away)}, {Real(0), Real(0), Real(-1)}};
}

/// How many of 1000 rays, no closer than 1 % to grazing, a formula answers wrongly: a hit missed, a
/// miss hit, or a distance off by more than a hundredth of the radius.
template <class Real, class Formula>
int wrong_answers(double away, Formula formula) {
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const double impact = i % 2 == 0 ? 0.99 * i / 1000 : 1.01 + 0.1 * i / 1000;
    // The reference uses the impact as Real holds it, and nothing cancels: along -z the distance is
    // away - sqrt(1 - impact^2).
    const double held = static_cast<double>(Real(impact));
    const bool hits = held < 1;
    const Real got = formula(unit, ray_from<Real>(away, impact));
    const bool answered = got < infinity<Real>();
    const double expected = away - std::sqrt(hits ? (1 - held) * (1 + held) : 0);
    wrong +=
        answered != hits || (hits && std::abs(static_cast<double>(got) - expected) > 0.01) ? 1 : 0;
  }
  return wrong;
}

TEST_CASE_TEMPLATE("near the sphere both published formulas are right", Real, float, double) {
  CHECK(published::distance_daily(unit, ray_from<Real>(3, 0)) == Real(2));
  CHECK(published::distance_half_b(unit, ray_from<Real>(3, 0)) == Real(2));
  CHECK(published::distance_daily({{1, 0, 0}, 2}, Ray<Real>{{1, 0, 0}, {0, 2, 0}}) == Real(1));
  CHECK(published::distance_daily(unit, ray_from<Real>(-3, 0)) == infinity<Real>());
  CHECK(published::distance_daily(unit, ray_from<Real>(1.0005, 0)) > Real(1.9));  // its 0.001
  CHECK(wrong_answers<Real>(5, published::distance_daily<Real>) == 0);
  CHECK(wrong_answers<Real>(5, published::distance_half_b<Real>) == 0);
}

TEST_CASE(
    "4096 radii away in float the published formulas lose the sphere and the stable form does "
    "not") {
  CHECK(wrong_answers<float>(4096, published::distance_daily<float>) > 100);
  CHECK(wrong_answers<float>(4096, published::distance_half_b<float>) > 100);
  CHECK(wrong_answers<float>(4096, distance_to<float, Sphere<>>) == 0);
  CHECK(wrong_answers<double>(4096, published::distance_half_b<double>) == 0);
}

TEST_CASE("a tangent is a hit for us and the daily exercise, and a miss for One Weekend 2020") {
  const Ray<double> tangent{{1, 0, -5}, {0, 0, 1}};
  for (const SphereForm form : {SphereForm::plain, SphereForm::robust, SphereForm::hybrid})
    CHECK(distance_to(Sphere<>{{}, 1, form}, tangent) == doctest::Approx(5).epsilon(1e-15));
  CHECK(published::distance_daily(unit, tangent) == 5);
  CHECK(published::distance_half_b(unit, tangent) == infinity<double>());
}

}  // namespace
}  // namespace texmap::test
