// The option --budget.
#include "engine/app/budget_options.hpp"

#include "engine/app/command_line.hpp"

namespace texmap {

Budget read_budget(const std::string& text) {
  try {
    return parse_budget(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError("--budget: " + std::string(error.what()));
  }
}

}  // namespace texmap
