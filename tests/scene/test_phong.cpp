// Tests of common/scene/phong.hpp: the highlight, and what the slides' formula makes of it. How
// exact it is, tests/extremes searches.
#include <doctest.h>

#include "scene/phong.hpp"

namespace texmap::test {
namespace {

/// The highlight on a surface that faces up: light straight above, eye at an angle to the mirrored
/// light direction.
template <class Real>
Real highlight_towards(const Vec3<Real>& to_eye, double shininess, Real lamp_cosine = Real(1),
                       double specular = 1) {
  const Vec3<Real> up{0, 1, 0};
  return highlight(PhongMaterial{{}, specular, shininess}, LightSample<Real>{up, lamp_cosine}, up,
                   to_eye);
}

TEST_CASE_TEMPLATE("the highlight is the power of the cosine at exact points", Real, float, double,
                   long double) {
  struct Row {
    long double sine, cosine;
    double shininess;
    long double power;
  };
  const Row table[] = {
      {0, 1, 1e6, 1},     {0.6L, 0.8L, 2, 0.64L},     {0.6L, 0.8L, 5, 0.32768L},
      {0.6L, 0.8L, 0, 1}, {0.96L, 0.28L, 2, 0.0784L}, {1, 0, 1, 0},
      {1, 0, 0, 0},       {0.6L, -0.8L, 2, 0},        {0.6L, 0.8L, 1e30, 0},
  };
  for (const Row& row : table) {
    const Vec3<Real> to_eye{static_cast<Real>(row.sine), static_cast<Real>(row.cosine), 0};
    CAPTURE(row.cosine);
    CAPTURE(row.shininess);
    // Rounding turns the eye's direction by half an epsilon; the power multiplies it by n tan.
    const long double allowed = row.power * (4 + 4 * static_cast<long double>(row.shininess)) *
                                static_cast<long double>(std::numeric_limits<Real>::epsilon());
    CHECK(abs(static_cast<long double>(highlight_towards(to_eye, row.shininess)) - row.power) <=
          allowed);
  }
}

TEST_CASE_TEMPLATE("the mirror image is where the law of reflection puts it", Real, float, double,
                   long double) {
  const Vec3<Real> up{0, 1, 0};
  const LightSample<Real> light{{Real(0.6L), Real(0.8L), 0}, Real(0.8L)};
  const PhongMaterial material{{}, 1, 1000};
  const Real tolerance = Real(100) * std::numeric_limits<Real>::epsilon();
  CHECK(abs(highlight(material, light, up, {Real(-0.6L), Real(0.8L), 0}) - Real(1)) <= tolerance);
  CHECK(highlight(material, light, up, {Real(0.6L), Real(0.8L), 0}) < Real(1e-20L));
  CHECK(highlight(material, light, up, {0, 1, 0}) < Real(1e-20L));
  // Its strength is a factor.
  CHECK(highlight_towards<Real>({0, 1, 0}, 50, Real(1), 0.5) == Real(0.5));
}

TEST_CASE("a surface that the light does not reach has no highlight, for any exponent") {
  for (const double shininess : {0.0, 1.0, 100.0, 101.0, 500.5, 1e6})
    CHECK(highlight_towards<double>({0, 1, 0}, shininess, 0) == 0);
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

}  // namespace
}  // namespace texmap::test
