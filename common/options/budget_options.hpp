// The option --budget.
#pragma once
#include <string>

#include "budget.hpp"
#include "standard_streams.hpp"
#include "studio.hpp"

namespace texmap {

/// How far off a picture may be, as the user chooses: the cheapest kernels that keep to it are taken.
struct BudgetOptions {
  std::string text = "exact";

  void declare(CommandLine& line) {
    line.text("--budget", "BUDGET", text,
              "how far off a place on the texture may be: exact, texels=0.01 or levels=1; says which kernels it takes");
  }

  /// The mapping that keeps to the budget on a texture, and the number that it was made for, if the user chose none.
  /// Errors: UsageError.
  [[nodiscard]] BudgetMapping settle(Studio& studio, const Image& texture) const {
    Budget budget;
    try {
      budget = parse_budget(text);
    } catch (const std::invalid_argument& error) {
      throw UsageError("--budget: " + std::string(error.what()));
    }
    BudgetMapping mapping{choose_uv_kernel(budget, texture.width, texture.height, Directions::unit)};
#ifdef TEXMAP_HAVE_PACKS
    if (mapping.choice.number == KernelNumber::single && !studio.typed("--number")) studio.number = Number::float_pack;
#endif
    if (!studio.quiet && studio.typed("--budget")) print(mapping.choice.text + "\n");
    return mapping;
  }
};

}  // namespace texmap
