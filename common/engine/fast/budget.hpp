// The error budget: how far off a picture may be.
#pragma once
#include <string>
#include <string_view>

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

  [[nodiscard]] bool is_exact() const { return unit == Unit::exact; }
};

/// Reads `exact`, `texels=0.01` or `levels=1`: a unit and a decimal number in (0, 255].
/// Errors: std::invalid_argument, with what was expected and what was given.
[[nodiscard]] Budget parse_budget(std::string_view text);

/// The budget as text that parse_budget reads.
[[nodiscard]] std::string to_text(const Budget& budget);

}  // namespace texmap
