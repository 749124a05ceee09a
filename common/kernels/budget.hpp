// The error budget: how far off a picture may be, and the cheapest kernels that keep to it.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

#include "compiler.hpp"
#include "pixel_look.hpp"
#include "power_kernel.hpp"
#include "root_texture.hpp"
#include "srgb_kernel.hpp"
#include "turns.hpp"

namespace texmap {

/// How far off a picture may be.
struct Budget {
  enum class Unit {
    exact,   ///< as the reference formulas have it
    texels,  ///< a place on the texture
    levels,  ///< a channel of a color, of 255
  };
  Unit unit = Unit::exact;
  double limit = 0;  ///< 0 for `exact`, otherwise above 0
};

/// Reads `exact`, `texels=0.01` or `levels=1`: the unit in small letters, and a decimal number above 0 and up to 255.
///
/// Errors: std::invalid_argument, with what was expected and what was given.
[[nodiscard]] Budget parse_budget(std::string_view text);

/// The budget as parse_budget reads it.
[[nodiscard]] std::string to_text(const Budget& budget);

/// What is known of the directions that a mapping will be given.
enum class Directions {
  any,   ///< of any length: FastMapping
  unit,  ///< of length 1: FastUnitMapping
};

/// The number that a kernel works with.
enum class KernelNumber {
  single,     ///< float
  twice,      ///< double
  reference,  ///< double, by the reference formula of the C library
};

/// The kernel that a budget allows for (u, v).
struct UvChoice {
  Directions directions;
  KernelNumber number;
  int degree;           ///< of the arc tangent; 0 for the reference
  double worst_texels;  ///< stated; 0 for the reference, by which the others are judged
  double worst_levels;  ///< 255 a texel, in u and v together: black beside white, filtered
  double cost;          ///< time, as a part of the reference's; measured with eight floats or four doubles at once
  std::string text;     ///< one sentence that says all this
};

/// The cheapest kernel whose stated worst case on a texture of this size keeps to the budget.
///
/// @param width, height  in texels, 1 or more
/// The worst case in texels is the larger of those in u and in v. Levels are counted for a filtered texture. A texture read at
/// its nearest texel jumps at edges: there every kernel but the exact one can pick the neighbour, where a place lies within the
/// stated number of texels of the edge.
/// Errors: std::invalid_argument for a size below 1.
[[nodiscard]] UvChoice choose_uv_kernel(const Budget& budget, int width, int height, Directions directions = Directions::any);

/// How a budget finds (u, v) on a surface whose pixels have many samples.
struct SurfaceChoice {
  UvChoice mapping;     ///< for each sample, or for the nine looks of a patch
  Smoothing smoothing;  ///< of pixels; none where the mapping leaves nothing of the budget
  std::string text;     ///< one or two sentences that say all this
};

/// The mapping of unit directions and the smoothing of pixels that keep to the budget together.
///
/// The errors of a patch's nine looks can grow nearly threefold, so that the mapping gets a quarter of the budget, and what it
/// makes of it is taken off with what patches make of their own roundings. A budget in levels gives a fifth to directions; one
/// in texels speaks of places alone, and leaves directions as they are.
/// @param width, height  in texels, 1 or more
/// Domain, for directions: a sky that is nowhere darker than half of its brightest place.
/// Errors: std::invalid_argument for a size below 1.
[[nodiscard]] SurfaceChoice choose_surface_kernel(const Budget& budget, int width, int height);

/// A choice of polynomial for colors.
struct ColorChoice {
  int terms;            ///< 0 for the exact formula
  double worst_levels;  ///< stated; 0 for the exact formula
  std::string text;
  double worst_before_rounding = 0;  ///< the same, where levels are rounded to whole ones at the end: before that
};

/// The cheapest way to sRGB bytes that keeps to the budget: 3, 4 or 6 terms of srgb_byte, or srgb_byte_exact.
///
/// Before rounding it takes at most a quarter of the budget: the rest is for what comes before the curve.
/// Bytes are off by whole levels or not at all. A budget in texels speaks of places alone: colors stay exact.
[[nodiscard]] ColorChoice choose_srgb_kernel(const Budget& budget);

/// The cheapest Phong power that keeps to the budget, for a full highlight on packs of float: a PowerKernel of 3, 4, 6 or 8
/// terms, or the formula of `highlight`.
[[nodiscard]] ColorChoice choose_power_kernel(const Budget& budget);

/// How texels are kept.
struct TexelChoice {
  bool roots;           ///< as a RootTexture; or as they are
  double worst_levels;  ///< stated; 0 for texels as they are
  std::string text;
};

/// The cheapest way to the light of a texel that leaves at least half of the budget to the mapping.
[[nodiscard]] TexelChoice choose_texel_kernel(const Budget& budget);

/// draw(mapping) with the mapping of the choice; its results must be of one type.
///
/// @tparam directions  those that the choice was made for
template <Directions directions, class Draw>
decltype(auto) with_uv_mapping(const UvChoice& choice, const Draw& draw) {
  const auto with_degree = [&]<int Degree>() -> decltype(auto) {
    if constexpr (directions == Directions::unit) {
      return draw(FastUnitMapping<Degree>{});
    } else {
      return draw(FastMapping<Degree>{});
    }
  };
  switch (choice.degree) {
    case 5:
      return with_degree.template operator()<5>();
    case 7:
      return with_degree.template operator()<7>();
    case 9:
      return with_degree.template operator()<9>();
    case 11:
      return with_degree.template operator()<11>();
    case 13:
      return with_degree.template operator()<13>();
    case 15:
      return with_degree.template operator()<15>();
    case 17:
      return with_degree.template operator()<17>();
    case 23:
      return with_degree.template operator()<23>();
    case 29:
      return with_degree.template operator()<29>();
    case 35:
      return with_degree.template operator()<35>();
    default:
      return draw(RtiowMapping{});
  }
}

/// Phong's power of a choice, to be handed to highlight_by.
struct BudgetPower {
  int terms = 0;  ///< of the choice; 0 stands for the formula, which is not to be had here
  double exponent = 0;

  /// @param versine  1 - cos, 0 or more
  template <class Real>
  [[nodiscard]] Real operator()(const Real& versine) const {
    switch (terms) {
      case 3:
        return PowerKernel<3>(exponent)(versine);
      case 4:
        return PowerKernel<4>(exponent)(versine);
      case 6:
        return PowerKernel<6>(exponent)(versine);
      default:
        return PowerKernel<8>(exponent)(versine);
    }
  }
};

/// The mapping of a choice for unit directions, to be handed to a paint.
struct BudgetMapping {
  UvChoice choice = choose_uv_kernel({}, 1, 1, Directions::unit);

  /// Not inlined: eleven mappings would stand in each of a program's many loops, and take minutes to compile.
  template <class Real>
  [[nodiscard]] TEXMAP_NOINLINE Uv<Real> operator()(const Vec3<Real>& p) const {
    return with_uv_mapping<Directions::unit>(choice, [&p](const auto& mapping) { return mapping(p); });
  }
};

}  // namespace texmap
