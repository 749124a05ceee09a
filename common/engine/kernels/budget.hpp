// The error budget: how far off a picture may be.
#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/measure/text.hpp"

namespace texmap {

/// How far off a picture may be.
struct Budget {
  enum class Unit {
    exact,   ///< by the reference formulas
    texels,  ///< distance on the texture
    levels,  ///< difference of a color channel, of 255
  };
  Unit unit = Unit::exact;
  double limit = 0;  ///< 0 for `exact`, otherwise above 0
};

/// Reads `exact`, `texels=0.01` or `levels=1`: a unit and a decimal number in (0, 255].
/// Errors: std::invalid_argument, with what was expected and what was given.
[[nodiscard]] inline Budget parse_budget(std::string_view text) {
  if (text == "exact") return {};
  const bool texels = text.starts_with("texels=");
  if (texels || text.starts_with("levels=")) {
    const std::string_view number = text.substr(7);
    // A sign is none that a budget has.
    const bool begins = number.starts_with('.') || (number >= "0" && number < ":");
    const std::optional<double> limit = begins ? read_decimal(number) : std::nullopt;
    if (limit && *limit > 0 && *limit <= 255)
      return {texels ? Budget::Unit::texels : Budget::Unit::levels, *limit};
  }
  throw std::invalid_argument(
      "a budget is 'exact', 'texels=X' or 'levels=X' with a number X above 0 and up to 255, not '" +
      std::string(text) + "'");
}

/// The budget as text that parse_budget reads.
[[nodiscard]] inline std::string to_text(const Budget& budget) {
  if (budget.unit == Budget::Unit::exact) return "exact";
  return (budget.unit == Budget::Unit::texels ? "texels=" : "levels=") + round_trip(budget.limit);
}

}  // namespace texmap
