// What is typed for the option --budget.
#pragma once
#include <string>
#include <string_view>

#include "engine/fast/budget.hpp"
#include "engine/run/command_line.hpp"

namespace texmap {

/// The budget that a user typed. Errors: UsageError.
[[nodiscard]] inline Budget read_budget(std::string_view typed) {
  try {
    return parse_budget(typed);
  } catch (const std::invalid_argument& error) {
    throw UsageError("--budget: " + std::string(error.what()));
  }
}

}  // namespace texmap
