// Structural similarity of two pictures.
#pragma once
#include "image.hpp"
#include "plane.hpp"

namespace texmap {

/// The structural similarity of two pictures at each pixel, row by row.
///
/// With the means m, the variances s^2 and the covariance s_ab of the levels in a window around the pixel, for one channel:
///
///     SSIM = (2 m_a m_b + C1)(2 s_ab + C2) / ((m_a^2 + m_b^2 + C1)(s_a^2 + s_b^2 + C2)),  C1 = (0.01 255)^2,  C2 = (0.03
///     255)^2
///
/// where the window is a bell of sigma 1.5 pixels, 11 pixels wide and high; a pixel's value is the mean of its three channels.
///
/// The paper treats grey pictures, and only pixels whose window lies inside. Here, as in ImageMagick's `compare -metric SSIM`,
/// the picture goes on beyond its edges with the pixels at the edge, so that every pixel has a value and no picture is too
/// small.
///
/// @param a, b  pictures of one size, at least one pixel; not checked
/// @param take  gets values in [-1, 1], exactly 1 where the windows are equal
/// Errors: std::bad_alloc, and what `take` throws.
/// Source: Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to Structural Similarity, 2004,
/// equation 13 and section III-C for the window.
void ssim_rows(const Image& a, const Image& b, const TakeRow& take);

}  // namespace texmap
