// Tests of common/scene/phong.hpp: the highlight, and what the slides' formula makes of it.
#include <doctest.h>

#include "scene/phong.hpp"
#include "support/exact.hpp"
#include "support/lanes.hpp"

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
    Exact sine, cosine;
    double shininess;
    Exact power;
  };
  const Row table[] = {
      {0, 1, 1, 1},
      {0, 1, 1e6, 1},
      {0.6L, 0.8L, 1, 0.8L},
      {0.6L, 0.8L, 2, 0.64L},
      {0.6L, 0.8L, 5, 0.32768L},
      {0.8L, 0.6L, 3, 0.216L},
      {0.6L, 0.8L, 0, 1},
      {0.28L, 0.96L, 2, 0.9216L},
      {0.96L, 0.28L, 2, 0.0784L},
      {0.8L, 0.6L, 10, 0.0060466176L},
      {1, 0, 1, 0},
      {1, 0, 0, 0},
      {0.6L, -0.8L, 2, 0},
      {0, -1, 100, 0},
      {0.6L, 0.8L, 1e30, 0},
  };
  for (const Row& row : table) {
    const Vec3<Real> to_eye{static_cast<Real>(row.sine), static_cast<Real>(row.cosine), 0};
    CAPTURE(row.cosine);
    CAPTURE(row.shininess);
    // Rounding turns the eye's direction by half an epsilon; the power multiplies it by n tan.
    const Exact allowed = row.power * (4 + 4 * static_cast<Exact>(row.shininess)) *
                          widened(std::numeric_limits<Real>::epsilon());
    CHECK(abs(widened(highlight_towards(to_eye, row.shininess)) - row.power) <= allowed);
  }
}

TEST_CASE_TEMPLATE("the power keeps its digits however large the exponent is", Real, float,
                   double) {
  constexpr auto epsilon = static_cast<Exact>(std::numeric_limits<Real>::epsilon());
  for (const double shininess : {10.0, 100.0, 101.0, 500.5, 1e4, 1e6}) {
    Exact worst = 0;
    double worst_level = 0;
    int seen = 0;
    for (int i = 1; i <= 400; ++i) {
      // Angles at which the power goes from nearly 1 down to about a thousandth.
      const double angle = std::sqrt(14 / shininess) * i / 400;
      if (angle > 1.2) continue;
      const Vec3<Real> to_eye = number_cast<Real>(Point{std::sin(angle), std::cos(angle), 0});
      // The cosine of the directions as they are stored, by the chord between them, in long double.
      const Exact x = widened(to_eye.x);
      const Exact y = widened(to_eye.y);
      const Exact versine = (x * x + (1 - y) * (1 - y)) / 2;
      const Exact exact = std::exp(
          widened(shininess) * std::log1p(-versine));  // pow(1 - versine) would round 1 - versine
      const Exact relative =
          abs(widened(highlight_towards(to_eye, shininess)) - exact) / exact / epsilon;
      worst = std::max(worst, relative);
      worst_level = std::max(worst_level, static_cast<double>(relative * epsilon * exact * 255));
      ++seen;
    }
    CAPTURE(shininess);
    MESSAGE("worst: " << static_cast<double>(worst) << " eps, " << worst_level
                      << " of 255 levels at exponent " << shininess);
    CHECK(seen >= 300);
    // pow of the scalar product is off by more than 100 at 100 and by a million at a million.
    CHECK(worst <= 24);
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
}

TEST_CASE_TEMPLATE("the strength of the highlight is a factor", Real, float, double, long double) {
  const Vec3<Real> mirror{0, 1, 0};
  CHECK(highlight_towards(mirror, 50, Real(1), 0.5) == Real(0.5));
  CHECK(highlight_towards(mirror, 50, Real(1), 0) == Real(0));
  CHECK(PhongMaterial{}.specular == 0);
}

TEST_CASE_TEMPLATE("a surface that the light does not reach has no highlight, for any exponent",
                   Real, float, double, long double) {
  for (const double shininess : {0.0, 1.0, 100.0, 101.0, 500.5, 1e6}) {
    CHECK(highlight_towards<Real>({0, 1, 0}, shininess, Real(0)) == Real(0));
    CHECK(highlight_towards<Real>({0, -1, 0}, shininess, Real(0)) == Real(0));
    CHECK(highlight_towards<Real>({1, 0, 0}, shininess, Real(0)) == Real(0));
  }
}

TEST_CASE_TEMPLATE("the highlight is a number from 0 to its strength for all angles and exponents",
                   Real, float, double, long double) {
  int outside = 0;
  for (const double shininess : {0.0, 0.5, 1.0, 5.0, 100.0, 101.0, 500.5, 1e6, 1e30}) {
    for (int i = -1000; i <= 1000; ++i) {
      const Real cosine = static_cast<Real>(i) / Real(1000);
      for (const Real sine : {sqrt(Real(1) - square(cosine)), -sqrt(Real(1) - square(cosine))}) {
        const Real got = highlight_towards(Vec3<Real>{sine, cosine, 0}, shininess);
        if (!(got >= Real(0) && got <= Real(1))) ++outside;
        if (cosine <= Real(0) && got > Real(0) && shininess >= 1 &&
            got > std::numeric_limits<Real>::epsilon())
          ++outside;
      }
    }
  }
  CHECK(outside == 0);
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
}

TEST_CASE_TEMPLATE("each formula is found by its name", Real, float, double, long double) {
  const Vec3<Real> up{0, 1, 0};
  const LightSample<Real> light{up, Real(1)};
  const PhongMaterial odd{{}, 1, 101};
  CHECK(highlight(HighlightFormula::phong, odd, light, up, up) == Real(1));
  CHECK(highlight(HighlightFormula::lecture, odd, light, up, up) == Real(-1));
}

TEST_CASE_TEMPLATE("a pack has in each lane the highlight of a single number, to a few ulps", T,
                   float, double) {
  using Many = Pack<T>;
  const auto facing_up = []<class Real>(const Real& cosine) {
    return LightSample<Real>{{Real(0), Real(1), Real(0)}, cosine};
  };
  Dice dice;
  for (int i = 0; i < 200; ++i) {
    const Vec3<Many> to_eye = normalize(any_vectors<Many>(dice, -1, 1));
    const Many cosine = from_lanes<Many>([](std::size_t k) { return k % 2 == 0 ? T(1) : T(0); });
    check_each_lane<Many>(
        [&]<class Real>(const Vec3<Real>& eye, const Real& lit) {
          const LightSample<Real> light = facing_up(lit);
          return highlight_of_the_slides(PhongMaterial{{}, 1, 100}, light, light.to_light, eye);
        },
        to_eye, cosine);
    for (const double shininess : {1.0, 50.0, 500.5}) {
      const LightSample<Many> light = facing_up(cosine);
      const Many got = highlight(PhongMaterial{{}, 1, shininess}, light, light.to_light, to_eye);
      for (std::size_t k = 0; k < lanes<Many>; ++k) {
        const T alone = highlight_towards(lane_of(to_eye, k), shininess, lane(cosine, k));
        // A power of 1e-30 is black, and below the smallest normal number packs may give 0.
        REQUIRE(abs(lane(got, k) - alone) <=
                T(64) * std::numeric_limits<T>::epsilon() * alone + T(1e-30));
      }
    }
  }
}

}  // namespace
}  // namespace texmap::test
