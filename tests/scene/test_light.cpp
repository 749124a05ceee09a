// Tests of common/scene/light.hpp and shading_normal.hpp: shadows, and light on a surface that is
// shaded with another normal than its own.
#include <doctest.h>

#include <string>
#include <vector>

#include "scene/light.hpp"
#include "scene/paint.hpp"
#include "scene/shading_normal.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

struct Thing {
  Sphere<> shape;
};

/// A point of the ground, which faces up.
template <class Real>
const Hit<Real> ground{.normal = {0, 1, 0}, .point = {0, 0, 0}, .outside = {0, 0, 0}};

/// A list of objects that counts how often somebody looks at it.
struct Watched {
  const std::vector<Thing>& things;
  int& looks;
  [[nodiscard]] auto begin() const {
    ++looks;
    return things.begin();
  }
  [[nodiscard]] auto end() const { return things.end(); }
};

TEST_CASE_TEMPLATE(
    "a thing between the light and the surface takes the light, and anything elsewhere leaves it",
    Real, float, double, long double) {
  const PointLight above{{0, 5, 0}};
  struct Row {
    std::string where;
    Sphere<> sphere;
    bool dark;
  };
  const Row table[] = {
      {"between", {{0, 2.5, 0}, 0.5}, true},
      {"between, off the line", {{0.4, 2.5, 0}, 0.5}, true},
      {"beside", {{0.6, 2.5, 0}, 0.5}, false},
      {"behind the light", {{0, 7, 0}, 0.5}, false},
      {"below the ground", {{0, -2, 0}, 0.5}, false},
      {"around the light", {{0, 5, 0}, 0.5}, true},
      {"around everything", {{0, 0, 0}, 50}, false},
  };
  for (const Row& row : table) {
    CAPTURE(row.where);
    const Sphere<> aside{{9, 9, 9}, 1};
    for (const auto& things :
         {std::vector<Thing>{{row.sphere}, {aside}}, std::vector<Thing>{{aside}, {row.sphere}}})
      CHECK(sample_light(above, things, ground<Real>).cosine == (row.dark ? Real(0) : Real(1)));
  }
}

TEST_CASE_TEMPLATE(
    "a face turned away from the light costs no shadow ray and is as dark as with one", Real, float,
    double, long double) {
  const std::vector<Thing> things = {{{{0, 2.5, 0}, 0.5}}, {{{0, -2.5, 0}, 0.5}}};
  for (const Point& position :
       {Point{0, -5, 0}, Point{3, -4, 0}, Point{5, 0, 0}, Point{0, 5, 0}, Point{3, 4, 0}}) {
    int looks = 0;
    const LightSample<Real> light =
        sample_light(PointLight{position}, Watched{things, looks}, ground<Real>);
    CAPTURE(position.x);
    CAPTURE(position.y);
    CHECK(looks == (position.y > 0 ? 1 : 0));
    if (position.y <= 0) CHECK(light.cosine == Real(0));
  }
}

TEST_CASE_TEMPLATE(
    "the shadow ray starts at the lifted point, and the light's direction at the hit point", Real,
    float, double, long double) {
  const std::vector<Thing> things = {{{{0, 2, 0}, 1}}};
  const PointLight above{{0, 9, 0}};
  Hit<Real> hit = ground<Real>;
  hit.outside = {0, Real(3.5), 0};  // already past the thing
  CHECK(sample_light(above, things, hit).cosine == Real(1));
  CHECK(sample_light(above, things, ground<Real>).cosine == Real(0));
}

TEST_CASE("the factor at the terminator is 0 to 1, rises with the true cosine and has no edge") {
  for (const double shading : {0.1, 0.5, 1.0}) {
    for (const double between : {0.2, 0.7, 1.0}) {
      double before = 0;
      for (double cosine = 0; cosine <= 1; cosine += 0.01) {
        const double factor = terminator(cosine, shading, between);
        CHECK(factor >= before);
        CHECK(factor <= 1);
        CHECK(factor - before < 0.01 / (shading * between) * 1.5);
        before = factor;
      }
      CHECK(terminator(0.0, shading, between) == 0);
      CHECK(terminator(shading * between, shading, between) == 1);
    }
  }
  CHECK(terminator(0.5, 0.0, 1.0) == 0);
  CHECK(terminator(0.5, std::nan(""), 1.0) == 0);
}

TEST_CASE("a bump that faces the lamp stays dark where the globe itself faces away") {
  const std::vector<Painted<Solid>> objects = {
      {.shape = {.center = {0, 0, 0}, .radius = 1}, .paint = {}}};
  const Vec3d normal{0, 0, 1};
  const Hit<double> hit{normal, normal, normal, 0};
  const Vec3d bent = normalize(Vec3d{-1, 0, 1});
  CHECK(sample_light(PointLight{{-9, 0, 0.5}}, objects, hit, bent).cosine == 0);

  const LightSample<double> lit = sample_light(PointLight{{-9, 0, 3}}, objects, hit, bent);
  const double plain = lit.to_light.z, bumped = dot(lit.to_light, bent);
  CHECK(lit.cosine == bumped * terminator(plain, bumped, dot(bent, normal)));
  CHECK(lit.cosine > 0.2);
}

}  // namespace
}  // namespace texmap::test
