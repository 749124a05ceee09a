// Tests of common/math/rotation.hpp: turns about the vertical axis, in degrees.
#include <doctest.h>

#include <cstdint>

#include "math/rotation.hpp"
#include "texture/uv.hpp"

namespace texmap::test {
namespace {

template <class Real>
bool equal(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// The distance of `got` from the exact value, in ulps of 1 or of the value, whichever is smaller.
template <class Real>
Real ulps(Real got, long double exact) {
  const auto rounded = static_cast<Real>(exact);
  const Real magnitude = abs(rounded);
  return abs(got - rounded) / (std::nextafter(magnitude, infinity<Real>()) - magnitude);
}

TEST_CASE_TEMPLATE("quarter turns are exact, forwards and backwards", Real, float, double,
                   long double) {
  const int sines[] = {0, 1, 0, -1};
  const int cosines[] = {1, 0, -1, 0};
  for (int quarter = -400; quarter <= 400; ++quarter) {
    const std::size_t place = static_cast<std::size_t>(quarter + 400) % 4;
    const SineCosine<Real> angle = sine_cosine_of_degrees(static_cast<Real>(90 * quarter));
    CAPTURE(quarter);
    CHECK(angle.sine == static_cast<Real>(sines[place]));
    CHECK(angle.cosine == static_cast<Real>(cosines[place]));
  }
}

TEST_CASE_TEMPLATE("sines and cosines have every digit", Real, float, double, long double) {
  struct Row {
    int degrees;
    long double sine, cosine;
  };
  const Row table[] = {
      {1, 0.0174524064372835128194189785163161924723L, 0.999847695156391239157011558813919210067L},
      {15, 0.258819045102520762348898837624048328349L, 0.965925826289068286749743199728897367633L},
      {30, 0.5L, 0.866025403784438646763723170752936183471L},
      {36, 0.587785252292473129168705954639072768597L, 0.809016994374947424102293417182819058860L},
      {45, 0.707106781186547524400844362104849039284L, 0.707106781186547524400844362104849039284L},
      {60, 0.866025403784438646763723170752936183471L, 0.5L},
      {89, 0.999847695156391239157011558813919210067L, 0.0174524064372835128194189785163161924723L},
  };
  Real worst = 0;
  for (const Row& row : table) {
    for (const int turns : {-3, 0, 2}) {
      for (int quarter = 0; quarter < 4; ++quarter) {
        CAPTURE(row.degrees);
        CAPTURE(quarter);
        const SineCosine<Real> angle =
            sine_cosine_of_degrees(static_cast<Real>(row.degrees + 90 * quarter + 360 * turns));
        const long double sine = quarter == 0   ? row.sine
                                 : quarter == 1 ? row.cosine
                                 : quarter == 2 ? -row.sine
                                                : -row.cosine;
        const long double cosine = quarter == 0   ? row.cosine
                                   : quarter == 1 ? -row.sine
                                   : quarter == 2 ? -row.cosine
                                                  : row.sine;
        worst = std::max({worst, ulps(angle.sine, sine), ulps(angle.cosine, cosine)});
        CHECK(ulps(angle.sine, sine) <= Real(2));
        CHECK(ulps(angle.cosine, cosine) <= Real(2));
      }
    }
  }
  MESSAGE("worst: " << static_cast<double>(worst) << " ulps");
}

TEST_CASE_TEMPLATE("an angle and the same angle whole turns on are one", Real, float, double,
                   long double) {
  for (int degrees = 0; degrees < 360; ++degrees) {
    const SineCosine<Real> here = sine_cosine_of_degrees(static_cast<Real>(degrees));
    for (const int turns : {-1000, -1, 1, 1000}) {
      const SineCosine<Real> there =
          sine_cosine_of_degrees(static_cast<Real>(degrees + 360 * turns));
      REQUIRE(there.sine == here.sine);
      REQUIRE(there.cosine == here.cosine);
    }
  }
}

TEST_CASE("a billion degrees are 280 degrees") {
  const RotationY far = rotation_y(1e9);
  const RotationY near = rotation_y(280);
  CHECK(far.sine == near.sine);
  CHECK(far.cosine == near.cosine);
  CHECK(far.sine == doctest::Approx(-0.984807753012208059366743024589523013671).epsilon(1e-15));
  CHECK(far.cosine == doctest::Approx(0.173648177666930348851716626769314796000).epsilon(1e-15));
}

/// A number that is whole, modulo 360, by whole numbers alone: its digits times a power of two.
int modulo_turn(double whole) {
  int exponent = 0;
  const double fraction = std::frexp(whole, &exponent);
  auto rest = static_cast<std::int64_t>(std::ldexp(fraction, 53)) % 360;
  for (int i = 53; i < exponent; ++i) rest = rest * 2 % 360;
  return static_cast<int>(rest);
}

TEST_CASE("any finite angle counts, up to the largest number there is") {
  for (const double degrees :
       {1e17, 1e100, 1e300, 123456789e200, std::numeric_limits<double>::max()}) {
    CAPTURE(degrees);
    const RotationY far = rotation_y(degrees);
    const RotationY near = rotation_y(modulo_turn(degrees));
    CHECK(far.sine == near.sine);
    CHECK(far.cosine == near.cosine);
    const RotationY back = rotation_y(-degrees);
    CHECK(back.sine == doctest::Approx(-near.sine).epsilon(1e-15));
    CHECK(back.cosine == doctest::Approx(near.cosine).epsilon(1e-15));
  }
}

TEST_CASE_TEMPLATE("a negative angle turns the other way", Real, float, double, long double) {
  const Real eps = std::numeric_limits<Real>::epsilon();
  for (int tenths = 0; tenths <= 7200; ++tenths) {
    const Real degrees = static_cast<Real>(tenths) / Real(10);
    const SineCosine<Real> forth = sine_cosine_of_degrees(degrees);
    const SineCosine<Real> back = sine_cosine_of_degrees(-degrees);
    REQUIRE(abs(back.sine + forth.sine) <= eps);
    REQUIRE(abs(back.cosine - forth.cosine) <= eps);
    REQUIRE(abs(square(forth.sine) + square(forth.cosine) - Real(1)) <= Real(2) * eps);
  }
}

TEST_CASE_TEMPLATE("an angle that is no number gives no number", Real, float, double, long double) {
  for (const Real degrees :
       {std::numeric_limits<Real>::quiet_NaN(), infinity<Real>(), -infinity<Real>()}) {
    const SineCosine<Real> angle = sine_cosine_of_degrees(degrees);
    CHECK(angle.sine != angle.sine);
    CHECK(angle.cosine != angle.cosine);
  }
}

TEST_CASE_TEMPLATE("the lecture's matrix carries the axes round: +z to +x to -z to -x", Real, float,
                   double, long double) {
  const Vec3<Real> x{1, 0, 0};
  const Vec3<Real> y{0, 1, 0};
  const Vec3<Real> z{0, 0, 1};
  CHECK(equal(rotation_y(90)(z), x));
  CHECK(equal(rotation_y(90)(x), -z));
  CHECK(equal(rotation_y(90)(-z), -x));
  CHECK(equal(rotation_y(90)(-x), z));
  CHECK(equal(rotation_y(90)(y), y));
  CHECK(equal(rotation_y(180)(Vec3<Real>{1, 2, 3}), {-1, 2, -3}));
  CHECK(equal(rotation_y(270)(Vec3<Real>{1, 2, 3}), {-3, 2, 1}));
  CHECK(equal(rotation_y(-90)(Vec3<Real>{1, 2, 3}), {-3, 2, 1}));
  CHECK(equal(rotation_y(0)(Vec3<Real>{1, 2, 3}), {1, 2, 3}));
  CHECK(equal(rotation_y(-720)(Vec3<Real>{1, 2, 3}), {1, 2, 3}));
  CHECK(equal(RotationY{}(Vec3<Real>{1, 2, 3}), {1, 2, 3}));
}

TEST_CASE("a rotation adds degrees / 360 to u and leaves v") {
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const Point p{std::sin(i * 1.7), std::sin(i * 0.9) * 2, std::cos(i * 1.3)};
    const double degrees = i * 0.7919 - 1800;
    const Uv<double> before = uv_rtiow(p);
    const Uv<double> after = uv_rtiow(rotation_y(degrees)(p));
    const double off = after.u - before.u - degrees / 360;
    worst = std::max(worst, abs(off - std::round(off)));
    REQUIRE(abs(after.v - before.v) <= 4e-16);
  }
  MESSAGE("worst: " << worst << " of a turn");
  CHECK(worst <= 2e-15);  // degrees / 360 itself is rounded at up to 6 turns
}

}  // namespace
}  // namespace texmap::test
