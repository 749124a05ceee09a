// Tests of number/kinds/pack_u32.hpp: lanes of 32-bit integers compute as single ones do.
#include <doctest.h>

#include <array>
#include <cstdint>
#include <type_traits>

#include "number/kinds/pack_u32.hpp"
#include "sampling/sampled_numbers.hpp"

namespace texmap::test {
namespace {

/// Integers at which arithmetic is apt to go wrong, and some of no interest.
constexpr std::array<std::uint32_t, 20> corners = {
    0,          1,          2,          3,          255,        256,        0xffff,
    0x10000,    0xffffff,   0x1000000,  0x7fffffff, 0x80000000, 0x80000001, 0xfffffffe,
    0xffffffff, 0x9e3779b9, 0x12345678, 0xdeadbeef, 0x55555555, 0xaaaaaaaa};

/// A different corner in every lane, from `first` on.
template <class Real>
UInt<Real> from_corner(std::size_t first) {
  return uint_from_lanes<Real>(
      [first](std::size_t i) { return corners[(first + 7 * i) % corners.size()]; });
}

TEST_CASE("plain numbers have plain 32-bit integers") {
  CHECK(std::is_same_v<UInt<float>, std::uint32_t>);
  CHECK(std::is_same_v<UInt<double>, std::uint32_t>);
  CHECK(std::is_same_v<UInt<long double>, std::uint32_t>);
}

TEST_CASE_TEMPLATE("every lane computes modulo 2^32, as a single integer does", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for (std::size_t first = 0; first < corners.size(); ++first) {
    for (std::size_t second = 0; second < corners.size(); ++second) {
      const UInt<Real> a = from_corner<Real>(first);
      const UInt<Real> b = from_corner<Real>(second);
      for (std::size_t i = 0; i < lanes<Real>; ++i) {
        const std::uint32_t x = corners[(first + 7 * i) % corners.size()];
        const std::uint32_t y = corners[(second + 7 * i) % corners.size()];
        REQUIRE(uint_lane<Real>(a, i) == x);
        REQUIRE(uint_lane<Real>(a + b, i) == x + y);
        REQUIRE(uint_lane<Real>(a - b, i) == x - y);
        REQUIRE(uint_lane<Real>(a * b, i) == x * y);
        REQUIRE(uint_lane<Real>(a ^ b, i) == (x ^ y));
        REQUIRE(uint_lane<Real>(a & b, i) == (x & y));
        REQUIRE(uint_lane<Real>(a | b, i) == (x | y));
        REQUIRE(uint_lane<Real>(~a, i) == ~x);
        REQUIRE(uint_lane<Real>(select_less(a, b, UInt<Real>(5U), a), i) == (x < y ? 5U : x));
      }
    }
  }
}

TEST_CASE_TEMPLATE("all lanes shift by the same count, from 0 to 31", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for (std::size_t first = 0; first < corners.size(); ++first) {
    for (int count = 0; count < 32; ++count) {
      const UInt<Real> a = from_corner<Real>(first);
      for (std::size_t i = 0; i < lanes<Real>; ++i) {
        const std::uint32_t x = corners[(first + 7 * i) % corners.size()];
        REQUIRE(uint_lane<Real>(a << count, i) == x << count);
        REQUIRE(uint_lane<Real>(a >> count, i) == x >> count);
      }
    }
  }
}

TEST_CASE_TEMPLATE("integers mix with lanes: a scalar is in all of them", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  const UInt<Real> a = from_corner<Real>(3);
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const std::uint32_t x = corners[(3 + 7 * i) % corners.size()];
    CHECK(uint_lane<Real>(a * 0x9e3779b9U, i) == x * 0x9e3779b9U);
    CHECK(uint_lane<Real>(0U - a, i) == 0U - x);
    CHECK(uint_lane<Real>(UInt<Real>(17U), i) == 17U);
  }
}

TEST_CASE_TEMPLATE("an integer below 2^24 is a number without an error", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for (const std::uint32_t corner : corners) {
    const std::uint32_t whole = corner & 0xffffffU;
    const Real number = real_from_uint<Real>(UInt<Real>(whole));
    for (std::size_t i = 0; i < lanes<Real>; ++i)
      CHECK(static_cast<double>(lane(number, i)) == static_cast<double>(whole));
  }
}

TEST_CASE_TEMPLATE("the unit interval gets the upper 24 bits, the same in every number", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for (std::size_t first = 0; first < corners.size(); ++first) {
    const Real number = unit_interval<Real>(from_corner<Real>(first));
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      const std::uint32_t x = corners[(first + 7 * i) % corners.size()];
      CHECK(static_cast<double>(lane(number, i)) == static_cast<double>(x >> 8) / 16777216);
      CHECK(static_cast<double>(lane(number, i)) >= 0);
      CHECK(static_cast<double>(lane(number, i)) < 1);
    }
  }
}

}  // namespace
}  // namespace texmap::test
