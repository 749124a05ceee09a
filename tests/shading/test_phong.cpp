// Tests of common/shading/phong.hpp: the highlight, and what the slides' formula makes of it.
#include <doctest.h>

#include "exact.hpp"
#include "pack.hpp"
#include "phong.hpp"

namespace texmap {
namespace {

/// The highlight on a surface that faces up, for the mirror image of a lamp straight above and an eye at an angle to it.
template <class Real>
Real highlight_towards(const Vec3<Real>& to_eye, double shininess, Real lamp_cosine = Real(1), double specular = 1) {
  const Vec3<Real> up{0, 1, 0};
  return highlight(Finish{{}, specular, shininess}, Illumination<Real>{up, lamp_cosine}, up, to_eye);
}

TEST_CASE_TEMPLATE("the highlight is the power of the cosine at exact points", Real, float, double, long double) {
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
    // Rounding the eye's direction turns it by half an epsilon, which the power multiplies by n tan.
    const Exact allowed =
        row.power * (4 + 4 * static_cast<Exact>(row.shininess)) * widened(std::numeric_limits<Real>::epsilon());
    CHECK(abs(widened(highlight_towards(to_eye, row.shininess)) - row.power) <= allowed);
  }
}

TEST_CASE_TEMPLATE("the power keeps its digits however large the exponent is", Real, float, double) {
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
      const Exact exact = std::exp(widened(shininess) * std::log1p(-versine));  // pow(1 - versine) would round 1 - versine
      const Exact relative = abs(widened(highlight_towards(to_eye, shininess)) - exact) / exact / epsilon;
      worst = std::max(worst, relative);
      worst_level = std::max(worst_level, static_cast<double>(relative * epsilon * exact * 255));
      ++seen;
    }
    CAPTURE(shininess);
    MESSAGE("worst: " << static_cast<double>(worst) << " eps, " << worst_level << " of 255 levels at exponent " << shininess);
    CHECK(seen >= 300);
    CHECK(worst <= 24);  // pow of the scalar product is off by more than 100 at 100 and by a million at a million
  }
}

TEST_CASE_TEMPLATE("the mirror image is where the law of reflection puts it", Real, float, double, long double) {
  const Vec3<Real> up{0, 1, 0};
  const Illumination<Real> lamp{{Real(0.6L), Real(0.8L), 0}, Real(0.8L)};
  const Finish finish{{}, 1, 1000};
  const Real tolerance = Real(100) * std::numeric_limits<Real>::epsilon();
  CHECK(abs(highlight(finish, lamp, up, {Real(-0.6L), Real(0.8L), 0}) - Real(1)) <= tolerance);
  CHECK(highlight(finish, lamp, up, {Real(0.6L), Real(0.8L), 0}) < Real(1e-20L));
  CHECK(highlight(finish, lamp, up, {0, 1, 0}) < Real(1e-20L));
}

TEST_CASE_TEMPLATE("the strength of the highlight is a factor", Real, float, double, long double) {
  const Vec3<Real> mirror{0, 1, 0};
  CHECK(highlight_towards(mirror, 50, Real(1), 0.5) == Real(0.5));
  CHECK(highlight_towards(mirror, 50, Real(1), 0) == Real(0));
  CHECK(Finish{}.specular == 0);
}

TEST_CASE_TEMPLATE("a surface that the lamp does not reach has no highlight, for any exponent", Real, float, double,
                   long double) {
  for (const double shininess : {0.0, 1.0, 100.0, 101.0, 500.5, 1e6}) {
    CHECK(highlight_towards<Real>({0, 1, 0}, shininess, Real(0)) == Real(0));
    CHECK(highlight_towards<Real>({0, -1, 0}, shininess, Real(0)) == Real(0));
    CHECK(highlight_towards<Real>({1, 0, 0}, shininess, Real(0)) == Real(0));
  }
}

TEST_CASE_TEMPLATE("the highlight is a number from 0 to its strength for all angles and exponents", Real, float, double,
                   long double) {
  int outside = 0;
  for (const double shininess : {0.0, 0.5, 1.0, 5.0, 100.0, 101.0, 500.5, 1e6, 1e30}) {
    for (int i = -1000; i <= 1000; ++i) {
      const Real cosine = static_cast<Real>(i) / Real(1000);
      for (const Real sine : {sqrt(Real(1) - square(cosine)), -sqrt(Real(1) - square(cosine))}) {
        const Real got = highlight_towards(Vec3<Real>{sine, cosine, 0}, shininess);
        if (!(got >= Real(0) && got <= Real(1))) ++outside;
        if (cosine <= Real(0) && got > Real(0) && shininess >= 1 && got > std::numeric_limits<Real>::epsilon()) ++outside;
      }
    }
  }
  CHECK(outside == 0);
}

TEST_CASE_TEMPLATE("the slides' highlight looks the wrong way: an even exponent hides it and an odd one shows it", Real, float,
                   double, long double) {
  const Vec3<Real> up{0, 1, 0};
  const Illumination<Real> lamp{up, Real(1)};
  const Illumination<Real> unlit{up, Real(0)};
  const auto slides = [&](double shininess, const Vec3<Real>& to_eye, const Illumination<Real>& by) {
    return highlight_of_the_slides(Finish{{}, 0.5, shininess}, by, up, to_eye);
  };
  CHECK(slides(100, {0, 1, 0}, lamp) == Real(0.5));
  CHECK(slides(101, {0, 1, 0}, lamp) == Real(-0.5));
  CHECK(slides(100, {0, -1, 0}, lamp) == Real(0.5));   // no lamp is mirrored towards this eye
  CHECK(slides(100, {0, -1, 0}, unlit) == Real(0.5));  // and no lamp shines here at all
  CHECK(abs(slides(3, {Real(0.6L), Real(0.8L), 0}, lamp) + Real(0.256L)) <= std::numeric_limits<Real>::epsilon());
  const Real nothing = slides(500.5, {0, 1, 0}, lamp);
  CHECK(nothing != nothing);
}

TEST_CASE_TEMPLATE("each formula is found by its name", Real, float, double, long double) {
  const Vec3<Real> up{0, 1, 0};
  const Illumination<Real> lamp{up, Real(1)};
  const Finish odd{{}, 1, 101};
  CHECK(highlight(HighlightFormula::phong, odd, lamp, up, up) == Real(1));
  CHECK(highlight(HighlightFormula::lecture, odd, lamp, up, up) == Real(-1));
}

#ifdef TEXMAP_HAVE_PACKS
TEST_CASE_TEMPLATE("a pack has in each lane the highlight of a single number, to a few ulps", T, float, double) {
  using Many = Pack<T>;
  const Vec3<Many> up{Many(0), Many(1), Many(0)};
  for (const double shininess : {1.0, 50.0, 500.5}) {
    for (int start = 0; start < 200; ++start) {
      const auto angle = [start](std::size_t i) { return 0.02 * (start + 3 * static_cast<double>(i)); };
      const auto x = from_lanes<Many>([&](std::size_t i) { return static_cast<T>(std::sin(angle(i))); });
      const auto y = from_lanes<Many>([&](std::size_t i) { return static_cast<T>(std::cos(angle(i))); });
      const auto cosine = from_lanes<Many>([](std::size_t i) { return i % 2 == 0 ? T(1) : T(0); });
      const Many got = highlight(Finish{{}, 1, shininess}, Illumination<Many>{up, cosine}, up, Vec3<Many>{x, y, Many(0)});
      const Many slides =
          highlight_of_the_slides(Finish{{}, 1, 100}, Illumination<Many>{up, cosine}, up, Vec3<Many>{x, y, Many(0)});
      for (std::size_t i = 0; i < lanes<Many>; ++i) {
        const Vec3<T> to_eye{lane(x, i), lane(y, i), 0};
        const T alone = highlight_towards(to_eye, shininess, lane(cosine, i));
        // A power of 1e-30 is black by any measure, and below the smallest normal number packs may give 0.
        REQUIRE(abs(lane(got, i) - alone) <= T(64) * std::numeric_limits<T>::epsilon() * alone + T(1e-30));
        const Vec3<T> one_up{0, 1, 0};
        REQUIRE(lane(slides, i) == highlight_of_the_slides(Finish{{}, 1, 100}, Illumination<T>{one_up, 1}, one_up, to_eye));
      }
    }
  }
}
#endif

}  // namespace
}  // namespace texmap
