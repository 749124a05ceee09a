// The number by which chapters 13 and 14 judge float and double.
#pragma once
#include <string>

#include "number/kinds/double_pair.hpp"

namespace texmap {

/// True where long double is no wider than double; TEXMAP_JUDGE_PAIR makes it true anywhere.
#ifdef TEXMAP_JUDGE_PAIR
inline constexpr bool judge_is_pair = true;
#else
inline constexpr bool judge_is_pair = std::numeric_limits<long double>::digits < 64;
#endif

/// A number with enough digits to judge double by.
using Judge = std::conditional_t<judge_is_pair, DoublePair, long double>;

/// A line for tables, such as: judge: long double, 64 bits.
[[nodiscard]] inline std::string judge_line() {
  return std::string("judge: ") + (judge_is_pair ? "pairs of doubles, " : "long double, ") +
         std::to_string(std::numeric_limits<Judge>::digits) + " bits\n";
}

}  // namespace texmap
