// Structural similarity of two pictures.
#pragma once
#include "texture/image.hpp"

namespace texmap {

/// The mean structural similarity (SSIM) of two pictures over all channels, -1 to 1. The same bits
/// with any number of threads.
///
/// @param a, b, mask  as for measure(), not checked; where the mask is black, `b` is taken for `a`
/// Source: Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to
/// Structural Similarity, 2004, equation 13. Formula and edges: docs/numerics.md.
[[nodiscard]] double mean_ssim(const Image& a, const Image& b, const Image& mask);

}  // namespace texmap
