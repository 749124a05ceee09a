// Tests of number/kinds/pack2.hpp: a pair of packs computes what its lanes compute by themselves.
#include <doctest.h>

#include <cmath>

#include "number/kinds/pack2.hpp"
#include "support/lanes.hpp"
#include "support/shown_values.hpp"

namespace texmap::test {
namespace {

/// Checks that operations on pairs are those on single numbers in each lane; some are equal.
template <class T, class... Operations>
void check_lanes(const Operations&... operations) {
  using Many = Pack2<Pack<T>>;
  Dice dice(7);
  const auto some = [&dice] {
    return from_lanes<Many>([&](std::size_t) {
      return std::ldexp(static_cast<T>(dice.within(-20, 20)), dice.within(-5, 5));
    });
  };
  for (int i = 0; i < 200; ++i) {
    const Many a = some(), b = some();
    (check_each_lane<Many>(operations, a, b), ...);
  }
}

/// The same for functions that packs round in their own way: each half gives what a pack gives.
template <class T, class... Functions>
void check_halves(const Functions&... functions) {
  Dice dice(7);
  for (int i = 0; i < 200; ++i) {
    const Pack2<Pack<T>> a(any_pack<Pack<T>>(dice, -9, 9), any_pack<Pack<T>>(dice, -9, 9));
    const Pack2<Pack<T>> b(any_pack<Pack<T>>(dice, -9, 9), any_pack<Pack<T>>(dice, -9, 9));
    const auto check = [&](const auto& function) {
      const auto both = function(a, b);
      const auto first = function(a.first, b.first), second = function(a.second, b.second);
      for (std::size_t k = 0; k < lanes<Pack<T>>; ++k) {
        REQUIRE(alike(lane(both.first, k), lane(first, k)));
        REQUIRE(alike(lane(both.second, k), lane(second, k)));
      }
    };
    (check(functions), ...);
  }
}

TEST_CASE_TEMPLATE("every operation on a pair is that operation in each lane", T, float, double) {
  check_lanes<T>([](auto a, auto b) { return a + b; }, [](auto a, auto b) { return a - b; },
                 [](auto a, auto b) { return a * b; }, [](auto a, auto b) { return a / b; },
                 [](auto a, auto) { return -a; }, [](auto a, auto b) { return max(a, b); },
                 [](auto a, auto b) { return min(a, b); }, [](auto a, auto) { return abs(a); },
                 [](auto a, auto) { return sqrt(abs(a)); },
                 [](auto a, auto) { return floor(a) + decltype(a)(0); });
}

TEST_CASE_TEMPLATE("every function of a pair is that function of its halves", T, float, double) {
  check_halves<T>([](auto a, auto) { return exp(a); }, [](auto a, auto) { return log1p(abs(a)); },
                  [](auto a, auto b) { return atan2(a, b); });
}

TEST_CASE_TEMPLATE("every comparison, and masks of them, choose in each lane by itself", T, float,
                   double) {
  check_lanes<T>([](auto a, auto b) { return select(a < b, a, b); },
                 [](auto a, auto b) { return select(a <= b, a, b); },
                 [](auto a, auto b) { return select(a > b, a, b); },
                 [](auto a, auto b) { return select(a >= b, a, b); },
                 [](auto a, auto b) { return select(a == b, a, -b); },
                 [](auto a, auto b) { return select(a < b && b < -a, a, b); },
                 [](auto a, auto b) { return select(a < b || b < -a, a, b); },
                 [](auto a, auto b) { return select(!(a < b), a, b); });
}

TEST_CASE_TEMPLATE("lanes count through the first half and then the second", T, float, double) {
  using Real = Pack2<Pack<T>>;
  constexpr std::size_t half = lanes<Pack<T>>;
  REQUIRE(lanes<Real> == 2 * half);
  const Real x = from_lanes<Real>([](std::size_t i) { return static_cast<T>(i); });
  const auto all = all_lanes(x);
  for (std::size_t i = 0; i < 2 * half; ++i) {
    CHECK(lane(x, i) == static_cast<T>(i));
    CHECK(all[i] == static_cast<T>(i));
  }
  CHECK(lane(x.second, 0) == static_cast<T>(half));
  CHECK(all_lanes(Real(T(3))) == all_lanes(Real(Pack<T>(3), Pack<T>(3))));
}

TEST_CASE_TEMPLATE("any finds a single lane, wherever it is", T, float, double) {
  using Real = Pack2<Pack<T>>;
  for (std::size_t one = 0; one < lanes<Real>; ++one) {
    const Real x = from_lanes<Real>([one](std::size_t i) { return i == one ? T(1) : T(0); });
    CHECK(any(x > Real(T(0))));
    CHECK_FALSE(any(x > Real(T(1))));
  }
}

TEST_CASE_TEMPLATE("whole numbers go to bits and back, and fractions are cut off", T, float,
                   double) {
  using Real = Pack2<Pack<T>>;
  const Real x =
      from_lanes<Real>([](std::size_t i) { return static_cast<T>(100000 * i) + T(0.75); });
  const UInt<Real> bits = uint_from_real(x);
  const Real back = real_from_uint<Real>(bits);
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    CHECK(uint_lane<Real>(bits, i) == 100000 * i);
    CHECK(lane(back, i) == static_cast<T>(100000 * i));
  }
}

}  // namespace
}  // namespace texmap::test
