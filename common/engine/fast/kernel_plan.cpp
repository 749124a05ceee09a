// The kernels of a picture, chosen from its budget: the cheapest that keep it.
#include "engine/fast/kernel_plan.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/fast/biquadratic.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

/// The arc tangents' degrees of the polynomials for (u, v), and their time in units of the
/// reference's, which grows with the degree.
constexpr std::array uv_degrees = {5, 9, 17, 23, 35};
constexpr std::array uv_costs = {0.022, 0.028, 0.039, 0.103, 0.143};

/// In float, rounding dominates beyond degree 17.
bool is_for_float(int degree) { return degree >= 5 && degree <= 17; }

bool allows(const Budget& budget, double texels, double levels) {
  if (budget.unit == Budget::Unit::texels) return texels <= budget.limit;
  return budget.unit == Budget::Unit::levels && levels <= budget.limit;
}

/// "what for levels=1: ", the limit with two digits: what remains of one may have many.
std::string beginning(const std::string& what, const Budget& budget) {
  if (budget.unit == Budget::Unit::exact) return what + " for exact";
  return what + (budget.unit == Budget::Unit::texels ? " for texels=" : " for levels=") +
         shown(budget.limit, 2);
}

/// Adds the mapping and the smoothing of pixels that keep a budget together.
void plan_places(KernelPlan& plan, const Budget& budget, const Image& texture) {
  const double in_u = texture.width, in_v = texture.height;
  Budget part = budget;
  part.limit /= 4;
  Polynomial mapping = choose_uv_kernel(part, texture.width, texture.height);
  const bool levels = budget.unit == Budget::Unit::levels;
  // One rounding of the sum, and a little for smaller ones.
  const double rounding = 0.3 * static_cast<double>(std::numeric_limits<float>::epsilon());
  const double grown = Biquadratic<double>::worst_growth;
  const double of_u = Smoothing::turns_per_curvature_error * in_u;
  const double of_v = Smoothing::half_turns_per_curvature_error * in_v;
  double rest = budget.limit - grown * mapping.worst_texels - rounding * std::max(in_u, in_v);
  Smoothing smoothing{.most_curvature_error = rest / std::max(of_u, of_v)};
  if (levels) {
    // An error of a direction changes the sky by half as much. Levels change fastest at light 1:
    // by half of 255 with the square root, by 5/12 of it with the sRGB curve.
    const double levels_per_normal_error = 128 * 0.5 * Smoothing::direction_per_normal_error;
    rest = 0.8 * budget.limit - grown * mapping.worst_levels - 255 * rounding * (in_u + in_v);
    smoothing = {rest / (255 * (of_u + of_v)), budget.limit / 5 / levels_per_normal_error};
  }
  if (is_for_float(mapping.terms) && rest > 0) {
    plan.smoothing = smoothing;
    mapping.text += '\n';
    mapping.text += beginning("pixels", budget) +
                    ": polynomials through nine probes for each that bends the picture by less "
                    "than " +
                    shown(smoothing.most_curvature_error, 2) + "; at worst " +
                    shown(budget.limit, 2) + (levels ? " levels" : " texels") + " with (u, v)";
  } else {  // the mapping uses up the budget
    mapping = choose_uv_kernel(budget, texture.width, texture.height);
  }
  plan.uv_degree = mapping.terms;
  plan.floats_are_enough = is_for_float(mapping.terms);
  plan.text += mapping.text + "\n";
  if (levels && mapping.terms > 0)
    plan.text += "levels are those inside a texel: at its edge a sample may read the neighbor\n";
}

}  // namespace

UvError worst_uv_error(int degree, bool in_float) {
  return with_uv_mapping(degree, [in_float]<class Mapping>(const Mapping&) -> UvError {
    if constexpr (requires { Mapping::template worst<float>; }) {
      if (in_float) return Mapping::template worst<float>;
      return Mapping::template worst<double>;
    } else {
      return {};
    }
  });
}

Polynomial choose_uv_kernel(const Budget& budget, int width, int height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width < 1 || height < 1)
    throw std::invalid_argument("a texture is at least 1x1, not " + size);
  const std::string start = beginning("(u, v)", budget) + " on " + size + ": ";
  for (std::size_t i = 0; i < uv_degrees.size(); ++i) {
    const int degree = uv_degrees[i];
    const UvError worst = worst_uv_error(degree, is_for_float(degree));
    const double u = worst.u * width, v = worst.v * height;
    const double texels = std::max(u, v), levels = 255 * (u + v);
    if (!allows(budget, texels, levels)) continue;
    return {degree, texels, levels,
            start + "polynomials in " + (is_for_float(degree) ? "float" : "double") +
                ", arc tangent of degree " + std::to_string(degree) + ", unit vectors; at worst " +
                shown(texels, 2) + " texels and " + shown(levels, 2) + " levels; " +
                shown(uv_costs[i], 2) + " of the reference's time"};
  }
  return {.text = start + "the reference formula in double, at cost 1"};
}

KernelPlan plan_surface(const Budget& budget, const Image& texture, double reads) {
  KernelPlan plan;
  Budget rest = budget;
  // Roots of light take at most half of it. To convert a texel takes as long as four reads save.
  const double worst = RootTexture::worst_levels;
  const bool pays = reads >= 4 * static_cast<double>(texture.pixels.size());
  plan.root_texels = pays && allows(rest, HUGE_VAL, 2 * worst);
  plan.text = beginning("texels", pays ? rest : Budget{}) + ": " +
              (plan.root_texels
                   ? "ten bits for the root of light; at worst " + shown(worst, 2) + " levels\n"
                   : "as they are, decoded by a table\n");
  if (plan.root_texels) rest.limit -= worst;
  plan_places(plan, rest, texture);
  return plan;
}

KernelPlan plan_highlight(const Budget& budget) {
  const std::string start = beginning("Phong's power", budget) + ": ";
  // The cheapest within the budget, for a full highlight in packs of float.
  for (const auto& [terms, worst] : {std::pair{3, PowerKernel<3>::worst_levels<float>},
                                     std::pair{6, PowerKernel<6>::worst_levels<float>}}) {
    if (!allows(budget, HUGE_VAL, worst)) continue;
    return {.power_terms = terms,
            .text = start + "a polynomial of " + std::to_string(terms) + " terms; at worst " +
                    shown(worst, 2) + " levels\n"};
  }
  return {.text = start + "the exponential and the logarithm\n"};
}

}  // namespace texmap
