// The option --budget.
#pragma once
#include <string>
#include <utility>

#include "budget.hpp"
#include "mapped.hpp"
#include "standard_streams.hpp"
#include "studio.hpp"

namespace texmap {

/// How far off a picture may be, as the user chooses: the cheapest kernels that keep to it are taken.
struct BudgetOptions {
  std::string text = "exact";

  void declare(CommandLine& line, const char* help =
                                      "how far off a place on the texture may be: exact, texels=0.01 or levels=1; says which "
                                      "kernels it takes") {
    line.text("--budget", "BUDGET", text, help);
  }

  // Once settled:
  int srgb_terms = 0;   ///< of the curve from light to bytes; 0 for the exact curve
  Smoothing smoothing;  ///< of pixels

  /// Settles the curve to bytes, then how texels are kept, and with what both leave of the budget the mapping and how
  /// smooth pixels may be; and the number
  /// that the mapping was made for, if the user chose none. Errors: UsageError.
  [[nodiscard]] Mapped<BudgetMapping, BudgetTexture> settle(Studio& studio, ImageTexture texture) {
    Budget rest = read();
    const ColorChoice curve = choose_srgb_kernel(rest);
    tell(studio, curve.text);
    srgb_terms = curve.terms;
    // Bytes are rounded once, at the end: what counts is by how much each step is off before.
    spend(rest, curve.worst_before_rounding);
    TexelChoice texels = choose_texel_kernel(rest);
    // Turning a texel into a word takes as long as four reads save.
    const double reads = double{1} * studio.width * studio.height * studio.samples;
    if (reads < 4 * static_cast<double>(texture.image.pixels.size())) texels = choose_texel_kernel({});
    tell(studio, texels.text);
    spend(rest, texels.worst_levels);
    const SurfaceChoice surface = choose_surface_kernel(rest, texture.image.width, texture.image.height);
    smoothing = surface.smoothing;
#ifdef TEXMAP_HAVE_PACKS
    if (surface.mapping.number == KernelNumber::single && !studio.typed("--number")) studio.number = Number::float_pack;
#endif
    tell(studio, surface.text);
    RootTexture roots = texels.roots ? RootTexture(texture) : RootTexture();
    return {{surface.mapping}, {std::move(texture), std::move(roots)}};
  }

  /// Settles Phong's power with that exponent; of 0 terms where the budget wants the formula. Errors: UsageError.
  [[nodiscard]] BudgetPower settle_power(const Studio& studio, double exponent) const {
    const ColorChoice choice = choose_power_kernel(read());
    tell(studio, choice.text);
    return {choice.terms, exponent};
  }

 private:
  [[nodiscard]] Budget read() const {
    try {
      return parse_budget(text);
    } catch (const std::invalid_argument& error) {
      throw UsageError("--budget: " + std::string(error.what()));
    }
  }
  static void spend(Budget& budget, double levels) {
    if (budget.unit == Budget::Unit::levels) budget.limit -= levels;
  }
  static void tell(const Studio& studio, const std::string& choice) {
    if (!studio.quiet && studio.typed("--budget")) print(choice + "\n");
  }
};

}  // namespace texmap
