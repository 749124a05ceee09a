// Tests of common/sampling/hash.hpp: numbers that look like chance.
#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sampling/hash.hpp"
#include "support/whole_numbers.hpp"

namespace texmap::test {
namespace {

bool all_differ(std::vector<std::uint32_t>& all) {
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) == all.end();
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
  std::vector<std::uint32_t> all(1 << 20);
  for (std::uint32_t i = 0; i < 1 << 20; ++i) all[i] = hash_bits(i * 4099U);
  CHECK(all_differ(all));
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

TEST_CASE("pixels of a large picture all have different numbers") {
  std::vector<std::uint32_t> all;
  for (std::uint32_t row = 0; row < 4096; row += row < 13 ? 1 : 13) {
    for (std::uint32_t column = 0; column < 65536; column += row == 0 ? 1 : 63)
      all.push_back(test::hash_row<float>(column, row));
  }
  for (const std::uint32_t edge : {0U, 65535U}) {
    for (const std::uint32_t other : {65533U, 65534U})
      all.push_back(test::hash_row<float>(edge, other));
  }
  CHECK(all_differ(all));
}

}  // namespace
}  // namespace texmap::test
