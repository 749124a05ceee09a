// What is known of a variant before it is tried: how far off a place can be, and what a pixel can
// then show.
#pragma once
#include "engine/kernels/turns.hpp"
#include "number/kinds/judge.hpp"
#include "variant.hpp"

namespace texmap::chapter_13 {

/// The worst error of the (u, v) kernel of a degree: stated by the kernels themselves, and for the
/// reference formula in docs/numbers.md.
[[nodiscard]] UvError kernel_bound(NumberKind number, int degree);

/// The least cosine that the figures of places include: rays that pass the center within 0.99
/// radii, as in docs/numbers.md. Nearer to the rim a rounding of the ray may go a long way on the
/// globe.
inline constexpr double least_cosine = 0.141;

/// How far a place can be off at most, in texels along u or v, for all hits that are not nearer to
/// the rim than `least_cosine`, for any view: the kernel's error and the normal's.
[[nodiscard]] double texels_bound(const Globe& globe, NumberKind number, int degree);

/// Where a pixel's ray meets the globe, by the judge.
struct ReferenceHit {
  bool met = false;
  double cosine = 0;    ///< of the angle between normal and ray
  double from_rim = 0;  ///< how far from touching the globe the ray passes, in radii
  double round = 0;     ///< length of the circle of this v, as a part of the equator's
  Uv<Judge> uv{};
};

/// By how many levels of 255 a pixel can be off; 0 if no rounding can change its bytes. A pixel
/// may change by all 255 if its ray is so near to the rim that a rounding may take it past it.
[[nodiscard]] int levels_bound(const Globe& globe, const Variant& variant, const ReferenceHit& hit);

/// By how many levels of 255 a channel can be off before it is rounded to a byte, compared with the
/// exact curve of the texel's bytes in the same number.
///
/// @param rays  that a channel is the mean of, 1 or more
[[nodiscard]] double unrounded_bound(const Variant& variant, int rays = 1);

/// By how many levels bytes can differ if their channels differ by `unrounded` before rounding.
[[nodiscard]] int rounded_bound(double unrounded);

}  // namespace texmap::chapter_13
