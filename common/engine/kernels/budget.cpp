// The error budget: reads it and chooses the kernels that keep it.
#include "engine/kernels/budget.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/kernels/biquadratic.hpp"
#include "engine/kernels/power_kernel.hpp"
#include "engine/kernels/root_texture.hpp"
#include "engine/kernels/srgb_kernel.hpp"
#include "engine/kernels/turns.hpp"
#include "engine/measure/text.hpp"

namespace texmap {
namespace {

[[noreturn]] void refuse(std::string_view text) {
  throw std::invalid_argument(
      "a budget is 'exact', 'texels=X' or 'levels=X' with a number X above 0 and up to 255, not '" +
      std::string(text) + "'");
}

/// A kernel: its errors, and its time in units of the reference's.
struct UvOffer {
  KernelNumber number;
  int degree;
  UvError worst;
  double cost;
};

template <int Degree>
UvOffer offer(KernelNumber number, double cost) {
  using Mapping = FastUnitMapping<Degree>;
  UvError worst = Mapping::template worst<double>;
  if (number == KernelNumber::float_) worst = Mapping::template worst<float>;
  return {number, Degree, worst, cost};
}

/// Sorted by cost. In float, rounding dominates beyond degree 17.
std::vector<UvOffer> uv_offers() {
  using enum KernelNumber;
  return {
      offer<5>(float_, 0.022),   offer<7>(float_, 0.025),   offer<9>(float_, 0.028),
      offer<11>(float_, 0.029),  offer<13>(float_, 0.034),  offer<15>(float_, 0.036),
      offer<17>(float_, 0.039),  offer<23>(double_, 0.103), offer<29>(double_, 0.121),
      offer<35>(double_, 0.143),
  };
}

/// The budget with two digits: what remains of one may have many.
std::string brief(const Budget& budget) {
  const std::string text = to_text(budget);
  return budget.unit == Budget::Unit::exact
             ? text
             : text.substr(0, text.find('=') + 1) + shown(budget.limit, 2);
}

std::string describe(const UvChoice& choice, const Budget& budget, int width, int height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (choice.degree == 0) {
    return "(u, v) for " + brief(budget) + " on " + size +
           ": the reference formula in double, by the C library, at cost 1";
  }
  return "(u, v) for " + brief(budget) + " on " + size + ": polynomials in " +
         (choice.number == KernelNumber::float_ ? "float" : "double") + ", arc tangent of degree " +
         std::to_string(choice.degree) + ", unit vectors; at worst " +
         shown(choice.worst_texels, 2) + " texels and " + shown(choice.worst_levels, 2) +
         " levels; " + shown(choice.cost, 2) + " of the reference's time";
}

bool keeps_to(const Budget& budget, const UvChoice& choice) {
  switch (budget.unit) {
    case Budget::Unit::texels:
      return choice.worst_texels <= budget.limit;
    case Budget::Unit::levels:
      return choice.worst_levels <= budget.limit;
    case Budget::Unit::exact:
      break;
  }
  return false;
}

std::string describe(const std::string& what, const Budget& budget, int terms, double worst,
                     const std::string& exact) {
  const std::string start = what + " for " + brief(budget) + ": ";
  if (terms == 0) return start + exact;
  return start + "a polynomial of " + std::to_string(terms) + " terms; at worst " +
         shown(worst, 2) + " levels";
}

}  // namespace

Budget parse_budget(std::string_view text) {
  if (text == "exact") return {};
  Budget budget;
  std::string_view number = text;
  if (text.starts_with("texels=")) {
    budget.unit = Budget::Unit::texels;
  } else if (text.starts_with("levels=")) {
    budget.unit = Budget::Unit::levels;
  } else {
    refuse(text);
  }
  number.remove_prefix(7);
  // A sign is none that a budget has.
  const bool begins = number.starts_with('.') || (number >= "0" && number < ":");
  const std::optional<double> limit = begins ? read_decimal(number) : std::nullopt;
  if (!limit || !(*limit > 0 && *limit <= 255)) refuse(text);
  budget.limit = *limit;
  return budget;
}

std::string to_text(const Budget& budget) {
  if (budget.unit == Budget::Unit::exact) return "exact";
  return (budget.unit == Budget::Unit::texels ? "texels=" : "levels=") + round_trip(budget.limit);
}

UvChoice choose_uv_kernel(const Budget& budget, int width, int height) {
  if (width < 1 || height < 1) {
    throw std::invalid_argument("a texture is at least 1x1, not " + std::to_string(width) + "x" +
                                std::to_string(height));
  }
  for (const UvOffer& offer : uv_offers()) {
    const double u = offer.worst.u * width;
    const double v = offer.worst.v * height;
    UvChoice choice{offer.number, offer.degree, std::max(u, v), 255 * (u + v), offer.cost, {}};
    if (keeps_to(budget, choice)) {
      choice.text = describe(choice, budget, width, height);
      return choice;
    }
  }
  UvChoice choice{KernelNumber::reference, 0, 0, 0, 1, {}};
  choice.text = describe(choice, budget, width, height);
  return choice;
}

SurfaceChoice choose_surface_kernel(const Budget& budget, int width, int height) {
  Budget part = budget;
  part.limit /= 4;
  SurfaceChoice choice{choose_uv_kernel(part, width, height), {}, {}};
  const bool levels = budget.unit == Budget::Unit::levels;
  const double in_u = width, in_v = height;
  // One rounding of the sum, and a little for smaller ones.
  const double rounding = 0.3 * static_cast<double>(std::numeric_limits<float>::epsilon());
  const double grown = Biquadratic<double>::worst_growth;
  double rest = 0;
  if (levels) {
    // An error of a direction changes the sky by half as much. Levels change fastest at light 1:
    // by half of 255 with the square root, by 5/12 of it with the sRGB curve.
    const double levels_per_normal_error = 128 * 0.5 * Smoothing::direction_per_normal_error;
    choice.smoothing.most_normal_error = budget.limit / 5 / levels_per_normal_error;
    rest =
        0.8 * budget.limit - grown * choice.mapping.worst_levels - 255 * rounding * (in_u + in_v);
    choice.smoothing.most_curvature_error =
        rest / (255 * (Smoothing::turns_per_curvature_error * in_u +
                       Smoothing::half_turns_per_curvature_error * in_v));
  } else {
    rest = budget.limit - grown * choice.mapping.worst_texels - rounding * std::max(in_u, in_v);
    choice.smoothing.most_curvature_error =
        rest / std::max(Smoothing::turns_per_curvature_error * in_u,
                        Smoothing::half_turns_per_curvature_error * in_v);
  }
  if (choice.mapping.number != KernelNumber::float_ || rest <= 0) {
    choice = {choose_uv_kernel(budget, width, height), {}, {}};
    choice.text = choice.mapping.text;
    return choice;
  }
  choice.text = choice.mapping.text + "\npixels for " + brief(budget) +
                ": polynomials through nine probes for each that bends the picture by less than " +
                shown(choice.smoothing.most_curvature_error, 2) + "; at worst " +
                (levels ? shown(budget.limit, 2) + " levels" : shown(budget.limit, 2) + " texels") +
                " with (u, v)";
  return choice;
}

ColorChoice choose_srgb_kernel(const Budget& budget) {
  ColorChoice choice{0, 0, {}};
  const auto try_terms = [&]<int Terms>(double worst_levels) {
    const double before = fits::SrgbCurve<Terms>::worst;
    if (budget.unit != Budget::Unit::levels || worst_levels > budget.limit ||
        before > budget.limit / 4)
      return;
    choice = {Terms, worst_levels, {}, before};
  };
  try_terms.template operator()<6>(1);
  try_terms.template operator()<4>(1);
  try_terms.template operator()<3>(2);
  choice.text = describe("sRGB bytes", budget, choice.terms, choice.worst_levels,
                         "the exact curve, by thresholds");
  return choice;
}

ColorChoice choose_power_kernel(const Budget& budget) {
  ColorChoice choice{0, 0, {}};
  const auto try_terms = [&]<int Terms>() {
    const double worst = PowerKernel<Terms>::template worst_levels<float>;
    if (choice.terms == 0 && budget.unit == Budget::Unit::levels && worst <= budget.limit)
      choice = {Terms, worst, {}};
  };
  try_terms.template operator()<3>();
  try_terms.template operator()<4>();
  try_terms.template operator()<6>();
  try_terms.template operator()<8>();
  choice.text = describe("Phong's power", budget, choice.terms, choice.worst_levels,
                         "the C library's exponential and logarithm");
  return choice;
}

TexelChoice choose_texel_kernel(const Budget& budget) {
  const double worst = RootTexture::worst_levels;
  const std::string start = "texels for " + brief(budget) + ": ";
  if (budget.unit == Budget::Unit::levels && 2 * worst <= budget.limit) {
    return {true, worst,
            start + "ten bits for the root of light; at worst " + shown(worst, 2) + " levels"};
  }
  return {false, 0, start + "as they are, decoded by a table"};
}

}  // namespace texmap
