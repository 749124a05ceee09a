// The difference of two pictures as seen by a viewer who alternates between them.
#pragma once
#include "engine/compare/plane.hpp"
#include "texture/image.hpp"

namespace texmap {

/// A viewer 0.7 m away from a screen of 3840 pixels on 0.7 m: 3840 pi / 180, rounded.
inline constexpr double usual_pixels_per_degree = 67;

/// FLIP: how much a viewer who alternates between two pictures sees change, at each pixel.
///
/// @param a, b               sRGB pictures of one size, at least one pixel; not checked
/// @param pixels_per_degree  of the field of view, 1 to 1000; more: smaller pixels or farther away
/// @param take               receives the rows: values in [0, 1], 0 for no difference
/// Source: Andersson and others: FLIP, 2020, sections 4.1 to 4.3. Summary: docs/numerics.md.
void flip_rows(const Image& a, const Image& b, double pixels_per_degree, const TakeRow& take);

}  // namespace texmap
