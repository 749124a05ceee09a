// What a texture shows beyond its edges.
#pragma once
#include "number/number.hpp"

namespace texmap {

/// What lies beyond the edges of an image. A mode treats opposite edges alike, because the filters
/// count v from the top. A new one also needs its word at both --wrap in engine/run/options.cpp.
enum class Wrap {
  repeat,     ///< the image again
  mirror,     ///< its mirror image, then the image again
  clamp,      ///< the texels of its edge
  border,     ///< a color of its own
  spherical,  ///< over the poles: half a turn further in u, and back in v; u repeats
};

/// A whole number modulo `n` >= 1, from 0 to n - 1. Domain: whole numbers to 2^22 in float.
template <class Real>
[[nodiscard]] Real remainder_of(const Real& x, const Real& n) {
  const Real turns = floor(x * (Real(1) / n));  // rounding can make it one too many or too few
  const Real rest = x - n * turns;
  return select(rest < Real(0), rest + n, select(rest >= n, rest - n, rest));
}

/// `x` mirrored at the edges of [0, n - 1]: n gives n - 1, and -1 gives 0.
/// Domain: as remainder_of.
template <class Real>
[[nodiscard]] Real mirrored(const Real& x, const Real& n) {
  const Real rest = remainder_of(x, Real(2) * n);
  return min(rest, Real(2) * n - Real(1) - rest);
}

/// A coordinate moved into [0, 1] as `wrap` says: the image again, mirrored, or its edge.
///
/// @param x  any number; NaN gives 0
/// Bound: 1 unit roundoff of 1, or of x where |x| > 1. Domain of `wrap`: repeat, mirror and clamp.
template <class Real>
[[nodiscard]] Real wrapped_coordinate(Wrap wrap, const Real& x) {
  switch (wrap) {
    case Wrap::repeat:
      return clamp(x - floor(x), Real(0), below_one<Real>());
    case Wrap::mirror: {
      const Real in_two = x - Real(2) * floor(x * Real(0.5));  // 0 to 2: the image and its mirror
      return clamp(min(in_two, Real(2) - in_two), Real(0), Real(1));
    }
    case Wrap::clamp:
    case Wrap::border:
    case Wrap::spherical:
      break;
  }
  return clamp(x, Real(0), Real(1));
}

/// Two neighboring columns or rows.
template <class Real>
struct Neighbors {
  Real first, second;
};

/// The columns or rows that are seen at `x` and at x + 1: one of them may be beyond an edge.
///
/// @param x  a whole number from -1 to n - 1
/// @param n  the number of columns or rows, a whole number
/// Domain of `wrap`: repeat, mirror and clamp.
template <class Real>
[[nodiscard]] Neighbors<Real> wrapped_neighbors(Wrap wrap, const Real& x, const Real& n) {
  const Real last = n - Real(1), next = x + Real(1);
  switch (wrap) {
    case Wrap::repeat:
      return {select(x < Real(0), last, x), select(next > last, Real(0), next)};
    case Wrap::mirror:
    case Wrap::clamp:
    case Wrap::border:
    case Wrap::spherical:
      break;
  }
  return {select(x < Real(0), Real(0), x), select(next > last, last, next)};
}

/// A texel after wrapping.
template <class Real>
struct WrappedTexel {
  Real column, row;   ///< whole numbers inside the image
  Mask<Real> inside;  ///< false where the border is seen
};

/// The texel of the image that is seen at a column and a row, inside the image or beyond.
///
/// @param column, row    whole numbers; rows in either direction
/// @param columns, rows  of the image, whole numbers; `spherical` needs an even number of columns
/// Domain: as remainder_of.
template <class Real>
[[nodiscard]] WrappedTexel<Real> wrapped_texel(Wrap wrap, const Real& column, const Real& row,
                                               const Real& columns, const Real& rows) {
  const Real nearest_column = clamp(column, Real(0), columns - Real(1));
  const Real nearest_row = clamp(row, Real(0), rows - Real(1));
  const Mask<Real> anywhere = mask_of<Real>(true);
  switch (wrap) {
    case Wrap::repeat:
      return {remainder_of(column, columns), remainder_of(row, rows), anywhere};
    case Wrap::mirror:
      return {mirrored(column, columns), mirrored(row, rows), anywhere};
    case Wrap::clamp:
      return {nearest_column, nearest_row, anywhere};
    case Wrap::border:
      return {nearest_column, nearest_row, column == nearest_column && row == nearest_row};
    case Wrap::spherical:
      break;
  }
  const Mask<Real> beyond_a_pole = remainder_of(row, Real(2) * rows) >= rows;
  const Real turned = column + select(beyond_a_pole, floor(columns * Real(0.5)), Real(0));
  return {remainder_of(turned, columns), mirrored(row, rows), anywhere};
}
/// The same for an image of width x height texels.
template <class Real>
[[nodiscard]] WrappedTexel<Real> wrapped_texel(Wrap wrap, const Real& column, const Real& row,
                                               int width, int height) {
  return wrapped_texel(wrap, column, row, Real(width), Real(height));
}

}  // namespace texmap
