// Arrays small and large: the same to their users.
#include "large_array.hpp"

#include <doctest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

using namespace texmap;

TEST_CASE("arrays on both sides of a large page hold what is put in, also when they grow and move") {
  for (const std::size_t size : {0U, 1U, 1000U, (1U << 18) - 1, 1U << 18, (1U << 19) + 1, 3U << 19}) {
    LargeArray<std::uint32_t> array(size);
    CHECK(std::all_of(array.begin(), array.end(), [](std::uint32_t x) { return x == 0; }));
    std::iota(array.begin(), array.end(), 7U);
    for (std::uint32_t more = 0; more < 3; ++more) array.push_back(more);
    const LargeArray<std::uint32_t> moved = std::move(array);
    LargeArray<std::uint32_t> copied;
    copied = moved;
    REQUIRE(copied.size() == size + 3);
    if (size > 0) CHECK(copied[size - 1] == size + 6);
    CHECK(copied.back() == 2);
    CHECK(copied == moved);
  }
}

TEST_CASE("large arrays begin where a large page does, small ones take no more than they need") {
  const auto begins = [](std::size_t bytes) {
    const LargeArray<std::uint8_t> array(bytes);
    return reinterpret_cast<std::uintptr_t>(array.data()) % (std::uintptr_t{2} << 20);
  };
  CHECK(begins(std::size_t{1} << 20) == 0);
  CHECK(begins(std::size_t{5} << 20) == 0);
  CHECK(begins(1000) != 0);
}

TEST_CASE("more than an address can count is an exception") {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  CHECK_THROWS_AS((void)LargePages<std::uint64_t>().allocate(most / 8), std::bad_array_new_length);
  CHECK_THROWS_AS((void)allocate_bytes(most), std::bad_alloc);
#ifndef TEXMAP_INSTRUMENTED  // there the watcher ends the program
  CHECK_THROWS_AS((void)allocate_bytes(most / 4), std::bad_alloc);
#endif
}
