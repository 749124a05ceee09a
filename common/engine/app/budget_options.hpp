// The option --budget.
#pragma once
#include <string>

#include "engine/kernels/budget.hpp"

namespace texmap {

/// The budget that a user typed. Errors: UsageError.
[[nodiscard]] Budget read_budget(const std::string& text);

}  // namespace texmap
