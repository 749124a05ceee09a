// Tests of number/kinds/pack_u32.hpp: lanes of 32-bit integers compute as single ones do.
#include <doctest.h>

#include <array>
#include <cstdint>

#include "number/kinds/pack_u32.hpp"
#include "sampling/sampled_numbers.hpp"

namespace texmap::test {
namespace {

/// Integers at which arithmetic is apt to go wrong, and some of no interest.
constexpr std::array<std::uint32_t, 20> corners = {
    0,          1,          2,          3,          255,        256,        0xffff,
    0x10000,    0xffffff,   0x1000000,  0x7fffffff, 0x80000000, 0x80000001, 0xfffffffe,
    0xffffffff, 0x9e3779b9, 0x12345678, 0xdeadbeef, 0x55555555, 0xaaaaaaaa};

/// Checks operations on integers in lanes, a different corner in each, against single integers.
template <class Real, class... Operations>
void check_lanes(const Operations&... operations) {
  const auto corner = [](std::size_t i) { return corners[i % corners.size()]; };
  for (std::size_t first = 0; first < corners.size(); ++first) {
    for (std::size_t second = 0; second < corners.size(); ++second) {
      const auto from = [&](std::size_t start) -> UInt<Real> {
        const auto value = [&](std::size_t i) { return corner(start + 7 * i); };
        if constexpr (lanes<Real> == 1) {
          return value(0);
        } else {
          return UInt<Real>::from_lanes(value);
        }
      };
      const auto check = [&](const auto& operation) {
        const UInt<Real> got = operation(from(first), from(second));
        for (std::size_t i = 0; i < lanes<Real>; ++i)
          REQUIRE(uint_lane<Real>(got, i) ==
                  operation(corner(first + 7 * i), corner(second + 7 * i)));
      };
      (check(operations), ...);
    }
  }
}

TEST_CASE_TEMPLATE("every lane computes modulo 2^32, as a single integer does", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  check_lanes<Real>([](auto a, auto) { return a; }, [](auto a, auto) { return ~a; },
                    [](auto a, auto b) { return a + b; }, [](auto a, auto b) { return a - b; },
                    [](auto a, auto b) { return a * b; }, [](auto a, auto b) { return a ^ b; },
                    [](auto a, auto b) { return a & b; }, [](auto a, auto b) { return a | b; },
                    [](auto a, auto b) { return select_less(a, b, decltype(a)(5U), a); },
                    // A scalar is in all lanes.
                    [](auto a, auto) { return a * 0x9e3779b9U; },
                    [](auto a, auto) { return 0U - a; },
                    [](auto a, auto) { return a ^ decltype(a)(17U); });
  for (int count = 0; count < 32; ++count)
    check_lanes<Real>([count](auto a, auto) { return a << count; },
                      [count](auto a, auto) { return a >> count; });
}

TEST_CASE_TEMPLATE("an integer below 2^24 is a number, and the upper 24 bits one below 1", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for (const std::uint32_t corner : corners) {
    const Real whole = real_from_uint<Real>(UInt<Real>(corner & 0xffffffU));
    const Real fraction = unit_interval<Real>(UInt<Real>(corner));
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      CHECK(static_cast<double>(lane(whole, i)) == static_cast<double>(corner & 0xffffffU));
      CHECK(static_cast<double>(lane(fraction, i)) == static_cast<double>(corner >> 8) / 0x1p24);
    }
  }
}

}  // namespace
}  // namespace texmap::test
