// Structural similarity of two pictures.
#pragma once
#include <functional>
#include <span>

#include "texture/image.hpp"

namespace texmap {

/// Pixels from the center of a window to its edge.
inline constexpr int ssim_window_radius = 5;

/// Receives the values of one row of a picture: each row once, in any order and from any thread.
using TakeRow = std::function<void(int row, std::span<const double> values)>;

/// The structural similarity (SSIM) of two pictures at each pixel: the mean of the three channels.
///
/// @param a, b  pictures of one size, at least one pixel; not checked
/// @param take  receives the rows: values in [-1, 1], exactly 1 for equal windows
/// Source: Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to
/// Structural Similarity, 2004, equation 13. Formula and edges: docs/numerics.md.
void ssim_rows(const Image& a, const Image& b, const TakeRow& take);

}  // namespace texmap
