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

  /// Of the curve from light to bytes, once settled; 0 for the exact curve.
  int srgb_terms = 0;

  /// Settles the curve to bytes, and with what it leaves of the budget the mapping on a texture; and the number that the
  /// mapping was made for, if the user chose none. Errors: UsageError.
  [[nodiscard]] BudgetMapping settle(Studio& studio, const Image& texture) {
    Budget rest = read();
    const ColorChoice curve = choose_srgb_kernel(rest);
    tell(studio, curve.text);
    srgb_terms = curve.terms;
    // Bytes are rounded once, after both: what counts is by how much the curve is off before.
    if (rest.unit == Budget::Unit::levels) rest.limit -= curve.worst_before_rounding;
    BudgetMapping mapping{choose_uv_kernel(rest, texture.width, texture.height, Directions::unit)};
#ifdef TEXMAP_HAVE_PACKS
    if (mapping.choice.number == KernelNumber::single && !studio.typed("--number")) studio.number = Number::float_pack;
#endif
    tell(studio, mapping.choice.text);
    return mapping;
  }

 private:
  [[nodiscard]] Budget read() const {
    try {
      return parse_budget(text);
    } catch (const std::invalid_argument& error) {
      throw UsageError("--budget: " + std::string(error.what()));
    }
  }
  static void tell(const Studio& studio, const std::string& choice) {
    if (!studio.quiet && studio.typed("--budget")) print(choice + "\n");
  }
};

}  // namespace texmap
