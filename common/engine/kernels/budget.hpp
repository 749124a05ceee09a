// The error budget: how far off a picture may be, and the cheapest kernels that keep it.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/kernels/smoothing.hpp"

namespace texmap {

/// How far off a picture may be.
struct Budget {
  enum class Unit {
    exact,   ///< by the reference formulas
    texels,  ///< distance on the texture
    levels,  ///< difference of a color channel, of 255
  };
  Unit unit = Unit::exact;
  double limit = 0;  ///< 0 for `exact`, otherwise above 0
};

/// Reads `exact`, `texels=0.01` or `levels=1`: a unit and a decimal number in (0, 255].
/// Errors: std::invalid_argument, with what was expected and what was given.
[[nodiscard]] Budget parse_budget(std::string_view text);

/// The budget as text that parse_budget reads.
[[nodiscard]] std::string to_text(const Budget& budget);

/// The number that a kernel works with.
enum class KernelNumber {
  float_,
  double_,
  reference,  ///< double, with the C library's functions
};

/// The kernel that a budget allows for (u, v).
struct UvChoice {
  KernelNumber number;
  int degree;           ///< of the arc tangent; 0 for the reference
  double worst_texels;  ///< largest error in texels; 0 for the reference
  double worst_levels;  ///< largest error in levels: 255 a texel, filtered, u and v together
  double cost;          ///< time in units of the reference's, with 8 floats or 4 doubles at once
  std::string text;     ///< a sentence that says all this
};

/// The cheapest kernel with a worst case within the budget, for a filtered texture.
/// With the nearest texel, places that close to an edge can get the neighboring texel.
///
/// @param width, height  in texels, 1 or more
/// Errors: std::invalid_argument for a size below 1.
[[nodiscard]] UvChoice choose_uv_kernel(const Budget& budget, int width, int height);

/// How a budget computes (u, v) on a surface with many samples per pixel.
struct SurfaceChoice {
  UvChoice mapping;     ///< for each sample, or for the nine probes of a patch
  Smoothing smoothing;  ///< of pixels; off where the mapping uses up the budget
  std::string text;     ///< one or two sentences that say all this
};

/// The mapping and the smoothing of pixels that keep the budget together.
///
/// @param width, height  in texels, 1 or more
/// Domain, in levels: a sky that is nowhere darker than half of its brightest place.
/// Errors: std::invalid_argument for a size below 1.
[[nodiscard]] SurfaceChoice choose_surface_kernel(const Budget& budget, int width, int height);

/// A choice of polynomial for colors.
struct ColorChoice {
  int terms;            ///< 0 for the exact formula
  double worst_levels;  ///< largest error; 0 for the exact formula
  std::string text;
  double worst_before_rounding = 0;  ///< the same before levels are rounded to whole numbers
};

/// The cheapest sRGB curve within the budget: 3, 4 or 6 terms of srgb_byte, or srgb_byte_exact.
/// Before rounding it uses at most a quarter of the budget. In texels, colors stay exact.
[[nodiscard]] ColorChoice choose_srgb_kernel(const Budget& budget);

/// The cheapest Phong power within the budget, for a full highlight in packs of float:
/// a PowerKernel of 3, 4, 6 or 8 terms, or the formula of `highlight`.
[[nodiscard]] ColorChoice choose_power_kernel(const Budget& budget);

/// How texels are stored.
struct TexelChoice {
  bool roots;           ///< as a RootTexture, else as bytes
  double worst_levels;  ///< largest error; 0 for bytes
  std::string text;
};

/// The cheapest texels that leave at least half of the budget to the mapping.
[[nodiscard]] TexelChoice choose_texel_kernel(const Budget& budget);

}  // namespace texmap
