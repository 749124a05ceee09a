// Tests of common/math/color.hpp: light adds, falls on surfaces and mixes.
#include <doctest.h>

#include "math/color.hpp"

namespace texmap::test {
namespace {

template <class Real>
bool equal(const Color<Real>& a, const Color<Real>& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
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

}  // namespace
}  // namespace texmap::test
