// Tests of texture/conventions.hpp: the source documents' conventions. How exact
// they are, and that none leaves [0, 1), tests/extremes searches.
#include <doctest.h>

#include <algorithm>
#include <numbers>

#include "number/dual.hpp"
#include "number/kinds/pack.hpp"
#include "published/uv.hpp"
#include "support/shown_values.hpp"
#include "texture/conventions.hpp"

namespace texmap::test {
namespace {

/// The difference of two places round the globe: 0 and 1 are one.
double apart(double a, double b) {
  const double off = abs(a - b);
  return std::min(off, 1 - off);
}

/// The i-th of n points spread evenly over the unit sphere.
Point spread(int i, int n) {
  const double y = 1 - (2 * i + 1.0) / n;
  const double around = i * 2.399963229728653;
  const double radius = std::sqrt((1 - y) * (1 + y));
  return {radius * std::cos(around), y, radius * std::sin(around)};
}

TEST_CASE_TEMPLATE("the axes have their exact places in each convention, at any length", Real,
                   float, double, long double, Pack<float>, Pack<double>) {
  struct Place {
    double u, v;
  };
  struct Row {
    Point p;
    Place daily, rtiow, lecture;
  };
  const Row table[] = {
      {{-1, 0, 0}, {0, 0.5}, {0, 0.5}, {0.75, 0.5}},
      {{0, 0, 1}, {0.75, 0.5}, {0.25, 0.5}, {0, 0.5}},
      {{1, 0, 0}, {0.5, 0.5}, {0.5, 0.5}, {0.25, 0.5}},
      {{0, 0, -1}, {0.25, 0.5}, {0.75, 0.5}, {0.5, 0.5}},
      {{0, 1, 0}, {0.5, 0}, {0.5, 1}, {0.25, 1}},
      {{0, -1, 0}, {0.5, 1}, {0.5, 0}, {0.25, 0}},
      {{-1, 0, -0.0}, {0, 0.5}, {0, 0.5}, {0.75, 0.5}},
      {{-0.0, 0, 1}, {0.75, 0.5}, {0.25, 0.5}, {0, 0.5}},
      {{-0.0, 1, -0.0}, {0.5, 0}, {0.5, 1}, {0.25, 1}},
      {{0, 0, 0}, {0.5, 0.5}, {0.5, 0.5}, {0.25, 0.5}},
  };
  for (const Row& row : table) {
    CAPTURE(row.p);
    const auto check = [&](Convention convention, const Place& place) {
      for (const double length : {1.0, 0.375, 1e-30, 1e30}) {
        const Uv<Real> uv = uv_of(convention, number_cast<Real>(row.p * length));
        CHECK(lane(uv.u, lanes<Real> - 1) == static_cast<Scalar<Real>>(place.u));
        CHECK(lane(uv.v, lanes<Real> - 1) == static_cast<Scalar<Real>>(place.v));
      }
    };
    check(Convention::daily, row.daily);
    check(Convention::rtiow, row.rtiow);
    check(Convention::lecture, row.lecture);
  }
}

TEST_CASE("each convention is its document's own formula on 100000 points") {
  double worst_u = 0, worst_v = 0;
  constexpr int points = 100000;
  for (int i = 0; i < points; ++i) {
    const Point p = normalize(spread(i, points));
    const auto compare = [&](const Uv<double>& ours, const Uv<double>& theirs) {
      worst_u = std::max(worst_u, apart(ours.u, theirs.u));
      worst_v = std::max(worst_v, abs(ours.v - theirs.v));
    };
    compare(uv_of(Convention::daily, p), published::uv_daily(p));
    compare(uv_of(Convention::rtiow, p), published::uv_one_weekend_2020(p));
    compare(uv_of(Convention::rtiow, p), published::uv_next_week_v4(p));
    compare(uv_of(Convention::lecture, p), published::uv_lecture(p));
  }
  CHECK(worst_u <= 4e-16);
  CHECK(worst_v <= 2e-14);  // the documents' asin and acos lose digits towards the poles
}

TEST_CASE("v has the slopes of its formula where |x| = |z|, too") {
  // v = 1/2 + asin(y / |p|) / pi: the slope along x is -x y / (pi wide |p|^2), wide^2 = x^2 + z^2.
  for (const double x : {1.0, -1.0}) {
    for (const double z : {1.0, -1.0, 0.5, -2.0}) {
      const double y = 0.8, wide = std::hypot(x, z), squared = x * x + y * y + z * z;
      const Dual<double> v = uv_rtiow(Vec3<Dual<double>>{{x, 1, 0}, y, {z, 0, 1}}).v;
      CHECK(v.dx == doctest::Approx(-x * y / (std::numbers::pi * wide * squared)).epsilon(1e-14));
      CHECK(v.dy == doctest::Approx(-z * y / (std::numbers::pi * wide * squared)).epsilon(1e-14));
    }
  }
}

}  // namespace
}  // namespace texmap::test
