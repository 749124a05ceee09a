// Tests of common/scene/phong.hpp: the highlight, and what the slides' formula makes of it. How
// exact it is, and its direction, tests/extremes searches.
#include <doctest.h>

#include "scene/phong.hpp"

namespace texmap::test {

TEST_CASE("a surface that the light does not reach has no highlight, for any exponent") {
  const Vec3d up{0, 1, 0};
  for (const double shininess : {0.0, 1.0, 100.0, 101.0, 500.5, 1e6})
    CHECK(highlight(PhongMaterial{{}, 1, shininess}, {up, 0.0}, up, up) == 0);
}

TEST_CASE_TEMPLATE(
    "the slides' highlight looks the wrong way: an even exponent hides it and an odd one shows it",
    Real, float, double, long double) {
  const Vec3<Real> up{0, 1, 0};
  const LightSample<Real> light{up, Real(1)};
  const LightSample<Real> unlit{up, Real(0)};
  const auto slides = [&](double shininess, const Vec3<Real>& to_eye, const LightSample<Real>& by) {
    return highlight_of_the_slides(PhongMaterial{{}, 0.5, shininess}, by, up, to_eye);
  };
  CHECK(slides(100, {0, 1, 0}, light) == Real(0.5));
  CHECK(slides(101, {0, 1, 0}, light) == Real(-0.5));
  CHECK(slides(100, {0, -1, 0}, light) == Real(0.5));  // no light is mirrored towards this eye
  CHECK(slides(100, {0, -1, 0}, unlit) == Real(0.5));  // and no light shines here at all
  CHECK(abs(slides(3, {Real(0.6L), Real(0.8L), 0}, light) + Real(0.256L)) <=
        std::numeric_limits<Real>::epsilon());
  const Real nothing = slides(500.5, {0, 1, 0}, light);
  CHECK(nothing != nothing);
  // Each formula is found by its name.
  const PhongMaterial odd{{}, 1, 101};
  CHECK(highlight(HighlightFormula::phong, odd, light, up, up) == Real(1));
  CHECK(highlight(HighlightFormula::lecture, odd, light, up, up) == Real(-1));
}

}  // namespace texmap::test
