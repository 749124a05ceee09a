// Where two pictures differ, as a picture.
#pragma once
#include "engine/compare/difference.hpp"

namespace texmap {

/// The color of a difference, on one scale from dark blue through grey and sand to bright yellow.
///
/// Each doubling of `levels` + 1 is one eighth of the scale. Reasons for it: docs/numerics.md.
/// @param levels  channel_difference, 0 to 255; 0 gives black, which is not on the scale
[[nodiscard]] Rgb8 difference_color(int levels);

/// The map: each pixel in the color of its difference, hatched where the mask is black, and below
/// it a legend with the scale, unless the picture would then be too large for a file.
///
/// @param a, b, mask  as for measure()
/// Errors: DifferenceError if the sizes differ.
[[nodiscard]] Image difference_map(const Image& a, const Image& b, const Image& mask = {});

}  // namespace texmap
