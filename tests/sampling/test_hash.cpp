// Tests of common/sampling/hash.hpp: numbers that look like chance, and are the same in any lane.
#include <doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sampling/hash.hpp"
#include "sampling/sampled_numbers.hpp"
#include "support/shown_values.hpp"
#include "support/whole_numbers.hpp"

namespace texmap::test {
namespace {

constexpr int many = 1 << 20;

TEST_CASE_TEMPLATE("each lane has the hash of its own integer", Real, TEXMAP_SAMPLED_NUMBERS) {
  for (std::uint32_t start = 0; start < 5000; start += 16) {
    const UInt<Real> x = uint_from_lanes<Real>(
        [start](std::size_t i) { return start * 77777U + static_cast<std::uint32_t>(i); });
    const UInt<Real> hashed = hash_bits(x);
    for (std::size_t i = 0; i < lanes<Real>; ++i)
      REQUIRE(uint_lane<Real>(hashed, i) == hash_bits(uint_lane<Real>(x, i)));
  }
}

TEST_CASE("the hash is the published one") {  // by hand, step for step, from its five operations
  CHECK(hash_bits(0U) == 0U);
  std::uint32_t x = 1;
  x *= 0x21f0aaadU;
  x ^= x >> 15;
  x *= 0xd35a2d97U;
  x ^= x >> 15;
  CHECK(hash_bits(1U) == x);
}

TEST_CASE("no two integers share a hash: every step can be undone") {
  std::vector<std::uint32_t> all(many);
  for (std::uint32_t i = 0; i < many; ++i) all[i] = hash_bits(i * 4099U);
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST_CASE("each bit of the integer changes each bit of the hash about half the time") {
  std::array<std::array<int, 32>, 32> changes{};
  constexpr int trials = 1 << 14;
  for (std::uint32_t k = 0; k < trials; ++k) {
    const std::uint32_t x = k * 0x9e3779b1U;
    for (std::size_t in = 0; in < 32; ++in) {
      const std::uint32_t changed = hash_bits(x) ^ hash_bits(x ^ (1U << in));
      for (std::size_t out = 0; out < 32; ++out)
        changes[in][out] += static_cast<int>((changed >> out) & 1U);
    }
  }
  double worst = 0;
  for (const auto& row : changes) {
    for (const int count : row)
      worst = std::max(worst, std::abs(static_cast<double>(count) / trials - 0.5));
  }
  MESSAGE("worst deviation from one half: " << worst);
  CHECK(worst < 0.03);  // chance alone, over 1024 pairs of bits, gives about 0.014
}

TEST_CASE("counters hash to numbers with the mean, the variance and the bins of chance") {
  double sum = 0, squares = 0, neighbours = 0, before = 0.5;
  std::array<double, 256> bins{};
  for (std::uint32_t i = 0; i < many; ++i) {
    const double x = unit_interval<double>(hash_bits(i));
    sum += x;
    squares += (x - 0.5) * (x - 0.5);
    neighbours += (x - 0.5) * (before - 0.5);
    before = x;
    bins[static_cast<std::size_t>(x * 256)] += 1;
  }
  CHECK(std::abs(sum / many - 0.5) < 4 * std::sqrt(1 / 12.0 / many));
  CHECK(std::abs(squares / many - 1 / 12.0) < 4 * std::sqrt(1 / 180.0 / many));
  CHECK(std::abs(neighbours / many) < 4 / 12.0 / std::sqrt(many));
  double chi = 0;
  for (const double count : bins)
    chi += (count - many / 256.0) * (count - many / 256.0) / (many / 256.0);
  CHECK(chi > 255 - 4 * std::sqrt(2 * 255.0));
  CHECK(chi < 255 + 4 * std::sqrt(2 * 255.0));
}

TEST_CASE("pixels of a large picture all have different numbers") {
  std::vector<std::uint32_t> all;
  for (std::uint32_t row = 0; row < 4096; row += 13) {
    for (std::uint32_t column = 0; column < 8192; column += 7)
      all.push_back(test::hash_row<float>(column, row));
  }
  for (std::uint32_t row = 0; row < 13; ++row) {
    for (std::uint32_t column = row == 0 ? 8192 : 0; column < 65536; column += 64) {
      if (column % 7 != 0 || column >= 8192 || row % 13 != 0)
        all.push_back(test::hash_row<float>(column, row));
    }
  }
  for (const std::uint32_t edge : {0U, 65535U}) {
    for (const std::uint32_t other : {65533U, 65534U})
      all.push_back(test::hash_row<float>(edge, other));
  }
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST_CASE_TEMPLATE("a pack of pixels has the numbers of its pixels, in their order", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for (std::uint32_t column = 0; column < 400; column += 31) {
    const UInt<Real> pixels = test::hash_row<Real>(column, 225 - column / 2);
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      CHECK(uint_lane<Real>(pixels, i) ==
            test::hash_row<double>(column + static_cast<std::uint32_t>(i), 225 - column / 2));
    }
  }
}

TEST_CASE("neighbouring pixels have nothing in common") {
  double along = 0, down = 0;
  for (std::uint32_t row = 0; row < 512; ++row) {
    for (std::uint32_t column = 0; column < 512; ++column) {
      const double x = unit_interval<double>(test::hash_row<double>(column, row)) - 0.5;
      along += x * (unit_interval<double>(test::hash_row<double>(column + 1, row)) - 0.5);
      down += x * (unit_interval<double>(test::hash_row<double>(column, row + 1)) - 0.5);
    }
  }
  CHECK(std::abs(along * 12 / (512 * 512)) < 4.0 / 512);
  CHECK(std::abs(down * 12 / (512 * 512)) < 4.0 / 512);
}

}  // namespace
}  // namespace texmap::test
