// Tests of common/number/bits.hpp: lanes of 32-bit integers compute as single ones do.
#include <doctest.h>

#include <array>
#include <cstdint>
#include <type_traits>

#include "bits.hpp"
#include "sampled_numbers.hpp"

namespace texmap {
namespace {

/// Integers at which arithmetic is apt to go wrong, and some of no interest.
constexpr std::array<std::uint32_t, 20> corners = {
    0,          1,          2,          3,          255,        256,        0xffff,     0x10000,    0xffffff,   0x1000000,
    0x7fffffff, 0x80000000, 0x80000001, 0xfffffffe, 0xffffffff, 0x9e3779b9, 0x12345678, 0xdeadbeef, 0x55555555, 0xaaaaaaaa};

/// A different corner in every lane, from `first` on.
template <class Real>
Bits<Real> from_corner(std::size_t first) {
  return bits_from_lanes<Real>([first](std::size_t i) { return corners[(first + 7 * i) % corners.size()]; });
}

TEST_CASE("plain numbers have plain 32-bit integers") {
  CHECK(std::is_same_v<Bits<float>, std::uint32_t>);
  CHECK(std::is_same_v<Bits<double>, std::uint32_t>);
  CHECK(std::is_same_v<Bits<long double>, std::uint32_t>);
}

TEST_CASE_TEMPLATE("every lane computes modulo 2^32, as a single integer does", Real, TEXMAP_SAMPLED_NUMBERS) {
  for (std::size_t first = 0; first < corners.size(); ++first) {
    for (std::size_t second = 0; second < corners.size(); ++second) {
      const Bits<Real> a = from_corner<Real>(first);
      const Bits<Real> b = from_corner<Real>(second);
      for (std::size_t i = 0; i < lanes<Real>; ++i) {
        const std::uint32_t x = corners[(first + 7 * i) % corners.size()];
        const std::uint32_t y = corners[(second + 7 * i) % corners.size()];
        REQUIRE(lane_of<Real>(a, i) == x);
        REQUIRE(lane_of<Real>(a + b, i) == x + y);
        REQUIRE(lane_of<Real>(a - b, i) == x - y);
        REQUIRE(lane_of<Real>(a * b, i) == x * y);
        REQUIRE(lane_of<Real>(a ^ b, i) == (x ^ y));
        REQUIRE(lane_of<Real>(a & b, i) == (x & y));
        REQUIRE(lane_of<Real>(a | b, i) == (x | y));
        REQUIRE(lane_of<Real>(~a, i) == ~x);
        REQUIRE(lane_of<Real>(select_less(a, b, Bits<Real>(5U), a), i) == (x < y ? 5U : x));
      }
    }
  }
}

TEST_CASE_TEMPLATE("all lanes shift by the same count, from 0 to 31", Real, TEXMAP_SAMPLED_NUMBERS) {
  for (std::size_t first = 0; first < corners.size(); ++first) {
    for (int count = 0; count < 32; ++count) {
      const Bits<Real> a = from_corner<Real>(first);
      for (std::size_t i = 0; i < lanes<Real>; ++i) {
        const std::uint32_t x = corners[(first + 7 * i) % corners.size()];
        REQUIRE(lane_of<Real>(a << count, i) == x << count);
        REQUIRE(lane_of<Real>(a >> count, i) == x >> count);
      }
    }
  }
}

TEST_CASE_TEMPLATE("integers mix with lanes: a scalar stands in all of them", Real, TEXMAP_SAMPLED_NUMBERS) {
  const Bits<Real> a = from_corner<Real>(3);
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const std::uint32_t x = corners[(3 + 7 * i) % corners.size()];
    CHECK(lane_of<Real>(a * 0x9e3779b9U, i) == x * 0x9e3779b9U);
    CHECK(lane_of<Real>(0U - a, i) == 0U - x);
    CHECK(lane_of<Real>(Bits<Real>(17U), i) == 17U);
  }
}

TEST_CASE_TEMPLATE("an integer below 2^24 is a number without an error", Real, TEXMAP_SAMPLED_NUMBERS) {
  for (const std::uint32_t corner : corners) {
    const std::uint32_t whole = corner & 0xffffffU;
    const Real number = real_from_bits<Real>(Bits<Real>(whole));
    for (std::size_t i = 0; i < lanes<Real>; ++i) CHECK(static_cast<double>(lane(number, i)) == static_cast<double>(whole));
  }
}

TEST_CASE_TEMPLATE("the unit interval gets the upper 24 bits, the same in every number", Real, TEXMAP_SAMPLED_NUMBERS) {
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
}  // namespace texmap
