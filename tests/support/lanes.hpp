// The law of packs: each lane computes what a plain number computes.
#pragma once
#include <doctest.h>

#include <cmath>
#include <tuple>

#include "number/kinds/pack.hpp"
#include "support/dice.hpp"
#include "support/lane_of.hpp"

namespace texmap::test {

/// The same numbers to the last bit, or NaN in both.
template <class T>
[[nodiscard]] bool alike(const T& a, const T& b) {
  if (a != a || b != b) return a != a && b != b;
  return a == b && std::signbit(a) == std::signbit(b);
}
template <HasParts Thing>
[[nodiscard]] bool alike(const Thing& a, const Thing& b);
template <class... Parts>
[[nodiscard]] bool alike(const std::tuple<Parts...>& a, const std::tuple<Parts...>& b) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (alike(std::get<i>(a), std::get<i>(b)) && ...);
  }
  (std::make_index_sequence<sizeof...(Parts)>());
}
template <HasParts Thing>
[[nodiscard]] bool alike(const Thing& a, const Thing& b) {
  return alike(parts_of(a), parts_of(b));
}

/// Checks that `function` gives for packs, in each lane, what it gives for that lane's numbers.
///
/// @param inputs  packs, or vectors, colors, places and rays of them
template <class Many, class Function, class... Inputs>
void check_each_lane(const Function& function, const Inputs&... inputs) {
  const auto many = function(inputs...);
  for (std::size_t i = 0; i < lanes<Many>; ++i) {
    CAPTURE(i);
    REQUIRE(alike(lane_of(many, i), function(lane_of(inputs, i)...)));
  }
}

}  // namespace texmap::test
