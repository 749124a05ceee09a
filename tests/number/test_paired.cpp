// Tests of common/number/paired.hpp: a pair computes what its two halves compute by themselves.
#include <doctest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "paired.hpp"

namespace texmap {
namespace {

#ifndef TEXMAP_HAVE_PACKS

TEST_CASE("without xsimd there are no packs to pair") {
  MESSAGE("skipped: xsimd is not installed, so pairs of packs are not tested");
  CHECK(lanes<double> == 1);
}

#else

/// The same bits in every lane.
template <class Real>
bool same(const Real& a, const Real& b) {
  const auto x = all_lanes(a);
  const auto y = all_lanes(b);
  return std::memcmp(x.data(), y.data(), sizeof x) == 0;
}

/// Numbers of all sizes and both signs, some of them equal.
template <class Half>
Half some_numbers(std::mt19937& random) {
  std::uniform_int_distribution<int> whole(-20, 20);
  return from_lanes<Half>(
      [&](std::size_t) { return std::ldexp(static_cast<Scalar<Half> >(whole(random)), whole(random) / 4); });
}

template <class T>
struct Halves {
  using Half = Pack<T>;
  Half a, b;
  Paired<Half> both() const { return {a, b}; }
};

/// Checks that an operation on pairs is the operation on each half.
template <class T, class Operation>
void check_halves(const Operation& operation) {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const Halves<T> x{some_numbers<Pack<T> >(random), some_numbers<Pack<T> >(random)};
    const Halves<T> y{some_numbers<Pack<T> >(random), some_numbers<Pack<T> >(random)};
    const auto both = operation(x.both(), y.both());
    REQUIRE(same(both.first, operation(x.a, y.a)));
    REQUIRE(same(both.second, operation(x.b, y.b)));
  }
}

TEST_CASE_TEMPLATE("every operation on a pair is that operation on its halves", T, float, double) {
  check_halves<T>([](const auto& a, const auto& b) { return a + b; });
  check_halves<T>([](const auto& a, const auto& b) { return a - b; });
  check_halves<T>([](const auto& a, const auto& b) { return a * b; });
  check_halves<T>([](const auto& a, const auto& b) { return a / b; });
  check_halves<T>([](const auto& a, const auto&) { return -a; });
  check_halves<T>([](const auto& a, const auto& b) { return larger(a, b); });
  check_halves<T>([](const auto& a, const auto& b) { return smaller(a, b); });
  check_halves<T>([](const auto& a, const auto&) { return abs(a); });
  check_halves<T>([](const auto& a, const auto&) { return sqrt(abs(a)); });
  check_halves<T>([](const auto& a, const auto&) { return floor(a); });
  check_halves<T>([](const auto& a, const auto&) { return exp(a); });
  check_halves<T>([](const auto& a, const auto&) { return log1p(abs(a)); });
  check_halves<T>([](const auto& a, const auto& b) { return atan2(a, b); });
}

TEST_CASE_TEMPLATE("every comparison, and masks of them, choose in each half by itself", T, float, double) {
  check_halves<T>([](const auto& a, const auto& b) { return select(a < b, a, b); });
  check_halves<T>([](const auto& a, const auto& b) { return select(a <= b, a, b); });
  check_halves<T>([](const auto& a, const auto& b) { return select(a > b, a, b); });
  check_halves<T>([](const auto& a, const auto& b) { return select(a >= b, a, b); });
  check_halves<T>([](const auto& a, const auto& b) { return select(a == b, a, -b); });
  check_halves<T>([](const auto& a, const auto& b) { return select(a < b && b < -a, a, b); });
  check_halves<T>([](const auto& a, const auto& b) { return select(a < b || b < -a, a, b); });
  check_halves<T>([](const auto& a, const auto& b) { return select(!(a < b), a, b); });
}

TEST_CASE_TEMPLATE("lanes count through the first half and then the second", T, float, double) {
  using Real = Paired<Pack<T> >;
  constexpr std::size_t half = lanes<Pack<T> >;
  REQUIRE(lanes<Real> == 2 * half);
  const Real x = from_lanes<Real>([](std::size_t i) { return static_cast<T>(i); });
  const auto all = all_lanes(x);
  for (std::size_t i = 0; i < 2 * half; ++i) {
    CHECK(lane(x, i) == static_cast<T>(i));
    CHECK(all[i] == static_cast<T>(i));
  }
  CHECK(lane(x.second, 0) == static_cast<T>(half));
  CHECK(same(Real(T(3)), Real(Pack<T>(3), Pack<T>(3))));
}

TEST_CASE_TEMPLATE("any finds a single lane, wherever it is", T, float, double) {
  using Real = Paired<Pack<T> >;
  for (std::size_t one = 0; one < lanes<Real>; ++one) {
    const Real x = from_lanes<Real>([one](std::size_t i) { return i == one ? T(1) : T(0); });
    CHECK(any(x > Real(T(0))));
    CHECK_FALSE(any(x > Real(T(1))));
  }
}

TEST_CASE_TEMPLATE("whole numbers go to bits and back, and fractions are cut off", T, float, double) {
  using Real = Paired<Pack<T> >;
  const Real x = from_lanes<Real>([](std::size_t i) { return static_cast<T>(100000 * i) + T(0.75); });
  const Bits<Real> bits = bits_from_real(x);
  const Real back = real_from_bits<Real>(bits);
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    CHECK(lane_of<Real>(bits, i) == 100000 * i);
    CHECK(lane(back, i) == static_cast<T>(100000 * i));
  }
}

#endif

}  // namespace
}  // namespace texmap
