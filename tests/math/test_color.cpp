// Tests of common/math/color.hpp: light adds, falls on surfaces and mixes.
#include <doctest.h>

#include "engine/render/render.hpp"
#include "math/color.hpp"

namespace texmap::test {
namespace {

template <class Real>
bool equal(const Color<Real>& a, const Color<Real>& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

TEST_CASE_TEMPLATE("colors add, multiply and scale channel by channel", Real, float, double,
                   long double) {
  const Color<Real> a{Real(0.25), Real(0.5), 1};
  const Color<Real> b{2, Real(0.5), Real(0.125)};
  CHECK(equal(a + b, {Real(2.25), 1, Real(1.125)}));
  CHECK(equal(a * b, {Real(0.5), Real(0.25), Real(0.125)}));
  CHECK(equal(a * Real(4), {1, 2, 4}));
  CHECK(equal(gray(Real(0.75)), {Real(0.75), Real(0.75), Real(0.75)}));
}

TEST_CASE_TEMPLATE("select takes whole colors", Real, float, double, long double) {
  CHECK(equal(select(true, Color<Real>{1, 2, 3}, Color<Real>{4, 5, 6}), {1, 2, 3}));
  CHECK(equal(select(false, Color<Real>{1, 2, 3}, Color<Real>{4, 5, 6}), {4, 5, 6}));
}

TEST_CASE_TEMPLATE("number_cast keeps each channel in its place and rounds once", Real, float,
                   double, long double) {
  CHECK(equal(number_cast<Real>(Rgb{0.1, 0.2, 0.3}),
              {static_cast<Real>(0.1), static_cast<Real>(0.2), static_cast<Real>(0.3)}));
}

TEST_CASE_TEMPLATE("mix goes straight from the first color to the second", Real, float, double,
                   long double) {
  const Color<Real> a{0, Real(0.5), 1};
  const Color<Real> b{1, Real(0.25), Real(0.5)};
  CHECK(equal(mix(a, b, Real(0)), a));
  CHECK(equal(mix(a, b, Real(1)), b));
  CHECK(equal(mix(a, b, Real(0.25)), {Real(0.25), Real(0.4375), Real(0.875)}));
  CHECK(equal(mix(a, b, Real(0.5)), {Real(0.5), Real(0.375), Real(0.75)}));
}

TEST_CASE_TEMPLATE("a color mixed with itself stays itself, to the bit and to the byte", Real,
                   float, double, long double) {
  int changed = 0;
  int changed_bytes = 0;
  for (int byte = 0; byte < 256; ++byte) {
    const Real c = static_cast<Real>(byte) / Real(255);
    for (int k = 0; k <= 1000; ++k) {
      const Color<Real> mixed = mix(gray(c), gray(c), static_cast<Real>(k) / Real(1000));
      if (!equal(mixed, gray(c))) ++changed;
      if (byte_of(static_cast<double>(mixed.g)) != byte) ++changed_bytes;
    }
  }
  CHECK(changed == 0);
  CHECK(changed_bytes == 0);
}

TEST_CASE_TEMPLATE(
    "mix is the first color at 0 and the second at 1, to the bit and to the byte, for all pairs",
    Real, float, double, long double) {
  int wrong = 0;
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const Color<Real> a = gray(static_cast<Real>(first) / Real(255));
      const Color<Real> b = gray(static_cast<Real>(second) / Real(255));
      if (!equal(mix(a, b, Real(0)), a) || !equal(mix(a, b, Real(1)), b)) ++wrong;
      if (byte_of(static_cast<double>(mix(a, b, Real(0)).r)) != first) ++wrong;
      if (byte_of(static_cast<double>(mix(a, b, Real(1)).r)) != second) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace texmap::test
