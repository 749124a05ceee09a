// Where two pictures differ, as a picture.
#pragma once
#include "difference.hpp"

namespace texmap {

/// The color for a difference, on a scale from a dark blue through grey and sand to bright yellow.
///
/// Each doubling of `levels` + 1 is one eighth of the scale, so that one level is seen on black, and every map has the same
/// scale and can be held against any other. In L*a*b* the scale is a straight line walked at constant speed: equal steps look
/// equally large, each lighter than the one before. It needs no telling apart of red and green, so color-blind people read it
/// too.
///
/// @param levels  of the channel that differs most, 0 to 255; 0 gives black, which is not on the line
/// Source: CIE 15:2004, section 8.2.1, for L*a*b*; the two ends of the line are our choice.
[[nodiscard]] Rgb8 difference_color(int levels);

/// The map: each pixel in the color of its difference, a hatching where the mask leaves a pixel out, and below it the scale
/// with its numbers. The map's upper left part is pixel for pixel where the pictures are.
///
/// The scale is left out where a picture with it would be larger than a picture file may be.
///
/// @param a, b, mask  as for measure()
/// Errors: DifferenceError if the sizes differ; std::bad_alloc.
[[nodiscard]] Image difference_map(const Image& a, const Image& b, const Image& mask = {});

}  // namespace texmap
