// Where the published ray-sphere formulas hold, and where they differ from the stable one.
#include <doctest.h>

#include "published/sphere.hpp"

using namespace texmap;

namespace {

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

}  // namespace

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
