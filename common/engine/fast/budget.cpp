// The error budget as text.
#include "engine/fast/budget.hpp"

#include <optional>
#include <stdexcept>

#include "engine/files/text.hpp"

namespace texmap {

Budget parse_budget(std::string_view text) {
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

std::string to_text(const Budget& budget) {
  if (budget.is_exact()) return "exact";
  return (budget.unit == Budget::Unit::texels ? "texels=" : "levels=") + round_trip(budget.limit);
}

}  // namespace texmap
