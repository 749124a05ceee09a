// Light on a surface that is shaded with another normal than its own.
#include "scene/shading_normal.hpp"

#include <doctest.h>

#include <cmath>
#include <vector>

#include "scene/paint.hpp"
#include "support/dice.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE_TEMPLATE("with the surface's own normal the light is the plain light, to the bit", Real,
                   float, double, long double) {
  const std::vector<Painted<Solid>> nothing;
  const PointLight light{{5, 4, 3}};
  Dice dice(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3<Real> p = dice.direction<Real>();
    const Hit<Real> hit{p, p, p, p};
    REQUIRE(sample_light(light, nothing, hit, p).cosine ==
            sample_light(light, nothing, hit).cosine);
  }
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
  const Hit<double> hit{normal, normal, normal, normal, 0};
  const Vec3d bent = normalize(Vec3d{-1, 0, 1});
  CHECK(sample_light(PointLight{{-9, 0, 0.5}}, objects, hit, bent).cosine == 0);

  const LightSample<double> lit = sample_light(PointLight{{-9, 0, 3}}, objects, hit, bent);
  const double plain = lit.to_light.z, bumped = dot(lit.to_light, bent);
  CHECK(lit.cosine == bumped * terminator(plain, bumped, dot(bent, normal)));
  CHECK(lit.cosine > 0.2);
}
