// The difference of two pictures as an eye would see it that alternates between them.
#pragma once
#include "image.hpp"
#include "plane.hpp"

namespace texmap {

/// A viewer 0.7 m before a screen of 3840 pixels on 0.7 m: 3840 pi / 180, rounded.
inline constexpr double usual_pixels_per_degree = 67;

/// FLIP, the difference that a viewer notices when two pictures are shown in turn in one place, at each pixel, row by row.
///
/// Color: the pictures are blurred as the eye blurs them, each opponent channel by its own contrast sensitivity; the distance
/// of the results in L*a*b*, with colors paler where it is dark (Hunt), is |dL| + sqrt(da^2 + db^2) (HyAB), spread over 0 to 1.
/// Features: edges and points that are in one picture and not in the other, found in the lightness before the blur. With both
/// in [0, 1] the difference is color^(1 - feature): features make a difference of color more visible.
///
/// Beyond its edges the picture goes on with the pixels at the edge.
///
/// @param a, b               pictures of one size, at least one pixel, encoded as sRGB; not checked
/// @param pixels_per_degree  of the viewer's field of view, 1 to 1000: more means smaller pixels or a viewer farther away
/// @param take               gets values in [0, 1], exactly 0 where all that the filters see is equal
/// Errors: std::bad_alloc, and what `take` throws.
/// Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference Evaluator for Alternating
/// Images, 2020, sections 4.1 (color), 4.2 (features) and 4.3 (both), for pictures of low dynamic range.
void flip_rows(const Image& a, const Image& b, double pixels_per_degree, const TakeRow& take);

}  // namespace texmap
