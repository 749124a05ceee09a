// The option --budget.
#pragma once
#include <string>

#include "engine/app/command_line.hpp"
#include "engine/kernels/budget.hpp"

namespace texmap {

/// The budget that a user typed. Errors: UsageError.
[[nodiscard]] inline Budget read_budget(const std::string& text) {
  try {
    return parse_budget(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError("--budget: " + std::string(error.what()));
  }
}

}  // namespace texmap
