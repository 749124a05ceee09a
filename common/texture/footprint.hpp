// What a pixel covers on a texture: its footprint.
#pragma once
#include "number/dual.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// A pixel's area on the texels, as a rectangle. The pixel covers a parallelogram, near enough;
/// the rectangle has the same area and the same spread in every direction.
template <class Real>
struct Footprint {
  Real along_u, along_v;  ///< the longer side, as a vector in texels
  Real longer, shorter;   ///< the lengths of the sides in texels, from 0 to 2^25
};

/// A derivative in texels a pixel, limited to 2^24 of either sign; a NaN counts as the largest.
template <class Real>
[[nodiscard]] Real limited_derivative(const Real& derivative, const Real& texels) {
  const Real limit = Real(16777216);
  return max(min(derivative * texels, limit), -limit);
}

/// The footprint of a pixel from the derivatives of (u, v) by the pixel's column and row.
///
/// @param uv             any derivatives; NaN counts as a footprint wider than any texture
/// @param width, height  of the texture in texels
/// Bound: 6 unit roundoffs of `longer`, for `longer` above 1e-15, in float 1e-9.
/// Source: Heckbert, "Fundamentals of Texture Mapping and Image Warping" (1989), section 3.5.8.
template <class Real>
[[nodiscard]] Footprint<Real> footprint_of(const Uv<Dual<Real>>& uv, const Real& width,
                                           const Real& height) {
  const Real u_by_x = limited_derivative(uv.u.dx, width);
  const Real u_by_y = limited_derivative(uv.u.dy, width);
  const Real v_by_x = limited_derivative(uv.v.dx, height);
  const Real v_by_y = limited_derivative(uv.v.dy, height);

  // Spread along u, along v, and of both together: 12 times the parallelogram's covariance.
  const Real uu = u_by_x * u_by_x + u_by_y * u_by_y;
  const Real vv = v_by_x * v_by_x + v_by_y * v_by_y;
  const Real uv_both = u_by_x * v_by_x + u_by_y * v_by_y;

  // The squares of the sides are the eigenvalues of the matrix ((uu, uv_both), (uv_both, vv)).
  const Real half = (uu - vv) * Real(0.5);
  const Real root = sqrt(half * half + uv_both * uv_both);
  const Real longer = sqrt((uu + vv) * Real(0.5) + root);
  const Real area = abs(u_by_x * v_by_y - u_by_y * v_by_x);
  const Real shorter = min(select(longer > Real(0), area / longer, Real(0)), longer);

  // The eigenvector of the larger one, from the row of the matrix that does not cancel.
  const Mask<Real> wide = half > Real(0);
  const Real along_u = select(wide, half + root, uv_both);
  const Real along_v = select(wide, uv_both, root - half);
  const Real size = max(abs(along_u), abs(along_v));
  const Mask<Real> has_axis = size > Real(0);
  const Real u = select(has_axis, along_u / size, Real(1));
  const Real v = select(has_axis, along_v / size, Real(0));
  const Real stretch = longer / sqrt(u * u + v * v);
  return {u * stretch, v * stretch, longer, shorter};
}

}  // namespace texmap
