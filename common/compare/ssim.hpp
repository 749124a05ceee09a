// Structural similarity of two pictures.
#pragma once
#include "image.hpp"
#include "plane.hpp"

namespace texmap {

/// Pixels from the middle of a window to its edge.
inline constexpr int ssim_window_radius = 5;

/// The structural similarity of two pictures at each pixel, row by row.
///
/// With the means m, the variances s^2 and the covariance s_ab of the levels in a window around the pixel, for one channel:
///
///     SSIM = (2 m_a m_b + C1)(2 s_ab + C2) / ((m_a^2 + m_b^2 + C1)(s_a^2 + s_b^2 + C2)),  C1 = (0.01 255)^2,  C2 = (0.03
///     255)^2
///
/// where the window is a bell of sigma 1.5 pixels, 11 pixels wide and high; a pixel's value is the mean of its three channels.
///
/// The paper has no values where the window does not lie inside the picture. Here every pixel has one: beyond its edges the
/// picture goes on with the pixels at the edge. Who wants the paper's figure takes the mean of the others only, as measure()
/// does.
///
/// @param a, b  pictures of one size, at least one pixel; not checked
/// @param take  gets values in [-1, 1], exactly 1 where the windows are equal
/// Errors: std::bad_alloc, and what `take` throws.
/// Source: Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to Structural Similarity, 2004,
/// equation 13 and section III-C for the window. The paper treats grey pictures; the mean of three channels is the choice of
/// scikit-image and of ImageMagick 7.
void ssim_rows(const Image& a, const Image& b, const TakeRow& take);

}  // namespace texmap
