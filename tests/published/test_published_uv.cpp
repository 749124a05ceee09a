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

TEST_CASE_TEMPLATE("the published formulas put the axes where their programs do", Real, float,
                   double, long double) {
  struct Row {
    Vec3<Real> p;
    double daily_u, daily_v, book_u, lecture_u, up_v;
  };
  const Row table[] = {
      {{0, 0, 1}, 0.75, 0.5, 0.25, 0, 0.5},
      {{1, 0, 0}, 0.5, 0.5, 0.5, 0.25, 0.5},
      {{0, 0, -1}, 0.25, 0.5, 0.75, 0.5, 0.5},
      {{0, 1, 0}, 0.5, 0, 0.5, 0, 1},
      {{0, -1, 0}, 0.5, 1, 0.5, 0, 0},
      {{Real(0.6L), Real(0), Real(0.8L)},
       0.6475836176504333,
       0.5,
       0.3524163823495667,
       0.1024163823495667,
       0.5},
  };
  for (const Row& row : table) {
    CAPTURE(row.daily_u);
    CHECK(close(published::uv_daily(row.p), row.daily_u, row.daily_v));
    CHECK(close(published::uv_one_weekend_2020(row.p), row.book_u, row.up_v));
    // Next Week's -z makes a pole's +0 a -0; atan2 then still gives a zero, as x is +0.
    CHECK(close(published::uv_next_week_v4(row.p), row.book_u, row.up_v));
    CHECK(close(published::uv_lecture(row.p), row.lecture_u, row.up_v));
  }
  CHECK(close(published::uv_lecture(Vec3<Real>{-1, 0, 0}), 0.75, 0.5));
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

TEST_CASE("the triangle article mirrors negative coordinates") {
  CHECK(published::index_triangle(-0.1F, 8192) == 819);
  for (const double u : {-0.1, 0.1, 1.1}) CHECK(published::index_triangle(u, 8192) == 819);
  CHECK(published::index_triangle(1.0, 8192) == 0);
  CHECK(published::index_triangle(0.5, 3) == 1);
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

TEST_CASE("the published rows obey their table") {
  using Row = std::pair<double, int>;
  for (const auto& [v, row] : {Row{0, 9}, {0.5, 4}, {1, 0}, {2, 0}, {-1, 9}})
    CHECK(published::row_one_weekend_2020(v, 10) == row);
  for (const auto& [v, row] : {Row{0, 9}, {0.5, 5}, {1, 0}, {2, 0}, {-1, 9}})
    CHECK(published::row_next_week_v4(v, 10) == row);
  for (const auto& [v, row] : {Row{0, 9}, {0.5, 5}, {below_one<double>(), 1}, {1, 0}})
    CHECK(published::row_lecture(v, 10) == row);
  // One Weekend's 0.001 is too much here: 0.95 of a row up, less than a thousandth below the edge.
  CHECK(published::row_one_weekend_2020(0.49995, 10) == 4);
  CHECK(published::row_one_weekend_2020(0.4998, 10) == 5);
}

}  // namespace
}  // namespace texmap
