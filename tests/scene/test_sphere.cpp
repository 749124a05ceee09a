// Tests of scene/sphere.hpp. How exact its forms are, tests/extremes searches.
#include <doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "number/kinds/pack.hpp"
#include "scene/paint.hpp"
#include "scene/sphere_choice.hpp"

namespace texmap::test {

constexpr SphereForm all_forms[] = {SphereForm::plain, SphereForm::robust, SphereForm::hybrid};
const Sphere<> unit_sphere{{0, 0, 0}, 1};

TEST_CASE_TEMPLATE("distances obey their table: outside, inside, behind, missing and on the sphere",
                   Real, float, double, long double) {
  const Real miss = infinity<Real>();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  struct Row {
    std::string what;
    Sphere<> sphere;
    Ray<Real> ray;
    Real distance;
  };
  const Row table[] = {
      {"from the front", unit_sphere, {{0, 0, 5}, {0, 0, -1}}, 4},
      {"from the left, a long direction", unit_sphere, {{-3, 0, 0}, {2, 0, 0}}, 1},
      {"from above, another sphere", {{1, 2, 3}, 2}, {{1, 10, 3}, {0, -1, 0}}, 6},
      {"from the center, P21", {{0, 0, 0}, 3}, {{0, 0, 0}, {1, 2, 2}}, 1},
      {"from inside, ahead of the center", unit_sphere, {{0, 0, Real(0.5)}, {0, 0, 1}}, Real(0.5)},
      {"from inside, behind the center", unit_sphere, {{0, 0, Real(-0.5)}, {0, 0, 1}}, Real(1.5)},
      {"behind the ray", unit_sphere, {{0, 0, 5}, {0, 0, 1}}, miss},
      {"beside the ray", unit_sphere, {{0, 2, 5}, {0, 0, -1}}, miss},
      {"from the surface inward", unit_sphere, {{0, 0, 1}, {0, 0, -1}}, 2},
      {"from the surface outward", unit_sphere, {{0, 0, 1}, {0, 0, 1}}, miss},
      {"from the surface along it", unit_sphere, {{1, 0, 0}, {0, 0, 1}}, miss},
      {"without a direction", unit_sphere, {{0, 0, 5}, {0, 0, 0}}, miss},
      {"with a direction that is no number", unit_sphere, {{0, 0, 5}, {0, nan, -1}}, miss},
  };
  for (const Row& row : table) {
    for (const SphereForm form : all_forms) {
      CAPTURE(row.what);
      CAPTURE(static_cast<int>(form));
      CHECK(distance_to(Sphere<>{row.sphere.center, row.sphere.radius, form}, row.ray) ==
            row.distance);
    }
  }
}

TEST_CASE_TEMPLATE("a sphere without a radius is missed by every form, and from everywhere", Real,
                   float, double, long double, Pack<float>) {
  for (const SphereForm form : all_forms) {
    for (const double radius : {0.0, -1.0, std::nan("")}) {
      const Ray<Real> ray{{Real(0), Real(0), Real(0.5)}, {Real(0), Real(0), Real(-1)}};
      const Real distance = distance_to(Sphere<>{{0, 0, 0}, radius, form}, ray);
      CHECK(lane(distance, 0) == infinity<Scalar<Real>>());
    }
  }
}

TEST_CASE("robust gives way to hybrid where it does not hold") {
  struct Object {
    Sphere<> shape;
  };
  constexpr SphereForm plain = all_forms[0], robust = all_forms[1], hybrid = all_forms[2];
  struct Row {
    double radius, away;
    int digits;
    SphereForm asked, given;
  };
  const Row table[] = {
      {1, 1e4, 24, robust, robust},       {1, 1.01e4, 24, robust, hybrid},
      {1e3, 1e7, 24, robust, robust},     {1, 1e7, 53, robust, robust},
      {1, 1.01e7, 53, robust, hybrid},    {1e30, 2e30, 24, robust, hybrid},
      {1e-30, 2e-30, 24, robust, hybrid}, {1e30, 2e30, 53, robust, robust},
      {1, 1e9, 24, plain, plain},         {1, 1, 24, hybrid, hybrid},
  };
  for (const Row& row : table) {
    CAPTURE(row.radius);
    CAPTURE(row.away);
    std::vector<Object> objects{{{{0, 0, -row.away}, row.radius, row.asked}}};
    keep_to_domains(objects, {0, 0, 0}, row.digits);
    CHECK(objects[0].shape.form == row.given);
  }
  // Rays start on other objects, too: the large one's far side is 2e6 radii from the small one.
  std::vector<Object> objects{{{{0, 0, 0}, 1e-3}}, {{{0, -1000, 0}, 1e3}}};
  keep_to_domains(objects, {0, 0, 1}, 24);
  CHECK(objects[0].shape.form == hybrid);
  CHECK(objects[1].shape.form == robust);
  // Other shapes in the list change nothing.
  std::vector<Painted<Solid, AnyShape<Sphere<>, Cylinder>>> mixed{
      {.shape = Cylinder{}, .paint = {}}, {.shape = Sphere<>{{0, 0, 0}, 1e-5}, .paint = {}}};
  keep_to_domains(mixed, {0, 0, 1}, 24);
  CHECK(std::get<Sphere<>>(mixed[1].shape).form == hybrid);
}

TEST_CASE_TEMPLATE("a hit has its normal, its point and its lifted point where geometry puts them",
                   Real, float, double, long double) {
  const Sphere<> sphere{{2, 0, -4}, 2};
  const Hit<Real> hit = hit_at(sphere, Ray<Real>{{2, 0, 6}, {0, 0, -2}}, Real(4));
  const Real u = unit_roundoff<Real>();
  CHECK(largest(hit.normal - Vec3<Real>{0, 0, 1}) == Real(0));
  CHECK(largest(hit.point - Vec3<Real>{2, 0, -2}) == Real(0));
  // 16 u of |center| + 2 radius, which is 8.
  CHECK(abs(hit.outside.z - (hit.point.z + Real(128) * u)) <= Real(4) * u);
  CHECK(hit.outside.x == Real(2));
}

TEST_CASE("rays that leave a sphere never meet it") {
  // From 1e4 radii away: where the length of the normal takes all terms of its series.
  const Ray<float> far{{1542.07446F, 769.21637F, -8833.47656F},
                       {-.171341956F, -.0854512379F, .981498837F}};
  const Vec3<float> onward{-.327263355F, .554320931F, -.451564074F};
  for (const SphereForm form : {SphereForm::robust, SphereForm::hybrid}) {
    const Sphere<> sphere{{0, 0, 0}, 1, form};
    const Hit<float> hit = hit_at(sphere, far, distance_to(sphere, far));
    CHECK(dot(hit.normal, onward) > 0);
    CHECK(distance_to(sphere, Ray<float>{hit.outside, onward}) == infinity<float>());
  }
}

TEST_CASE_TEMPLATE(
    "the normal of a sphere far from the world's origin keeps the digits a texture needs", Real,
    float, double) {
  // Whole numbers, which every number type holds; along -z Pythagoras gives the rest.
  for (const double away : {0.0, 1e3, 1e6}) {
    long double worst = 0;
    for (int i = -10; i <= 10; ++i) {
      const Sphere<> sphere{{away, -away, away}, 16};
      const Ray<Real> ray{{Real(away + i), Real(-away), Real(away + 64)}, {0, 0, -1}};
      const Vec3<Real> normal = hit_at(sphere, ray, distance_to(sphere, ray)).normal;
      const long double x = i / static_cast<long double>(16);
      worst = std::max({worst, abs(static_cast<long double>(normal.x) - x),
                        abs(static_cast<long double>(normal.z) - sqrt(1 - x * x))});
      REQUIRE(normal.y == Real(0));
    }
    CAPTURE(away);
    CHECK(worst <= 8 * static_cast<long double>(unit_roundoff<Real>()));
  }
}

}  // namespace texmap::test
