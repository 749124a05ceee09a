// Tests of common/sampling/hash.hpp: numbers that look like chance.
#include <doctest.h>

#include <algorithm>
#include <vector>

#include "sampling/hash.hpp"
#include "support/whole_numbers.hpp"

namespace texmap::test {

TEST_CASE("the hash is the published one") {  // by hand, step for step, from its five operations
  for (const std::uint32_t number : {0U, 1U, 0x12345678U, 0xffffffffU}) {
    std::uint32_t x = number ^ (number >> 16);
    x *= 0x21f0aaadU;
    x ^= x >> 15;
    x *= 0xd35a2d97U;
    x ^= x >> 15;
    CHECK(hash_bits(number) == x);
  }
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
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

}  // namespace texmap::test
