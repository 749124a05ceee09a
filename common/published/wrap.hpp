// The triangle article's way from a coordinate to a texel, to compare with `Wrap::mirror`.
#pragma once
#include <cstdlib>

namespace texmap::published {

/// abs(int(u n)) % n: the texel, from 0 to n - 1, of any coordinate.
///
/// @param u  of one plain number; u n must fit in an int
/// Fails at 0, which rounding toward 0 makes twice as wide; it mirrors there, and repeats at 1.
/// Source: the triangle article.
template <class Real>
[[nodiscard]] int article_texel(Real u, int n) {
  return std::abs(static_cast<int>(u * static_cast<Real>(n))) % n;
}

}  // namespace texmap::published
