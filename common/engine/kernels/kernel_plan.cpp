// The kernels of a picture, chosen from its budget.
#include "engine/kernels/kernel_plan.hpp"

namespace texmap {
namespace {

void spend(Budget& budget, double levels) {
  if (budget.unit == Budget::Unit::levels) budget.limit -= levels;
}

}  // namespace

KernelPlan plan_surface(const Budget& budget, const Image& texture, double reads) {
  Budget rest = budget;
  const ColorChoice curve = choose_srgb_kernel(rest);
  // Bytes are rounded once, at the end, so each step counts with its error before rounding.
  spend(rest, curve.worst_before_rounding);
  TexelChoice texels = choose_texel_kernel(rest);
  // Converting a texel to roots takes as long as four reads save.
  if (reads < 4 * static_cast<double>(texture.pixels.size())) texels = choose_texel_kernel({});
  spend(rest, texels.worst_levels);
  const SurfaceChoice surface = choose_surface_kernel(rest, texture.width, texture.height);
  return {
      .uv_degree = surface.mapping.degree,
      .floats_are_enough = surface.mapping.number == KernelNumber::float_,
      .smoothing = surface.smoothing,
      .root_texels = texels.roots,
      .srgb_terms = curve.terms,
      .text = curve.text + "\n" + texels.text + "\n" + surface.text + "\n",
  };
}

KernelPlan plan_highlight(const Budget& budget) {
  const ColorChoice power = choose_power_kernel(budget);
  return {.power_terms = power.terms, .text = power.text + "\n"};
}

}  // namespace texmap
