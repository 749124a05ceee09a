// The sphere on the six faces of a cube, in one image of three by two faces.
#pragma once
#include "math/circle.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// Where the texels of a face lie.
enum class CubeSpacing {
  even,          ///< evenly on the face, as a camera sees it: the tangent of an angle
  equi_angular,  ///< evenly in the angle
};

/// The two rows of the image. Each is a band of three faces side by side; the lower one is the
/// upper one turned by (x, y, z) -> (y, x, -z), like the two pieces of a tennis ball:
///
///     -x  +z  +x    (up in the image is +y)
///     -y  -z  +y    (up in the image is +x)
template <class Real>
[[nodiscard]] Vec3<Real> other_band(const Vec3<Real>& p) {
  return {p.y, p.x, -p.z};
}

/// Texture coordinates of a direction on the cube.
///
/// @param p  any vector but zero; only its direction matters
/// @return   u in [0, 1), a third for each face of a band; v from 0.5 on for the upper band
/// Bound: 0.001 texel of 4096 in float, 4e-12 texel in double.
template <class Real>
[[nodiscard]] Uv<Real> uv_cube(CubeSpacing spacing, const Vec3<Real>& p) {
  const Mask<Real> lower = max(abs(p.y), -p.z) > max(abs(p.x), p.z);
  const Vec3<Real> q = select(lower, other_band(p), p);

  // The face of the band, and the place on it times `depth`, from -depth to depth.
  const Mask<Real> middle = q.z >= abs(q.x);
  const Real depth = select(middle, q.z, abs(q.x));
  const Real side = select(middle, Real(0), select(q.x < Real(0), Real(-1), Real(1)));
  const Real across = select(middle, q.x, -side * q.z);

  const auto on_face = [&](const Real& offset) {
    if (spacing == CubeSpacing::even) return offset / depth;
    return atan2(offset, depth) * (Real(4) / pi<Real>());
  };
  const Real u = (side + Real(1) + Real(0.5) * (on_face(across) + Real(1))) / Real(3);
  // Below one: the upper edge of the lower band must not be read from the upper band.
  const Real height = clamp_u(Real(0.5) + Real(0.5) * on_face(q.y));
  return {clamp_u(u), Real(0.5) * height + select(lower, Real(0), Real(0.5))};
}

/// The direction at (u, v) on the cube, of unit length. Bound: 8 unit roundoffs.
template <class Real>
[[nodiscard]] Vec3<Real> direction_cube(CubeSpacing spacing, const Uv<Real>& uv) {
  const auto of_place = [&](const Real& place) {  // tan(place * 45 degrees)
    if (spacing == CubeSpacing::even) return place;
    const OnCircle<Real> angle = on_circle_eighth(Real(0.125) * place);
    return angle.sine / angle.cosine;
  };
  const Mask<Real> lower = uv.v < Real(0.5);
  const Real thirds = Real(3) * uv.u;
  const Real face = clamp(floor(thirds), Real(0), Real(2));
  const Real across = of_place(Real(2) * (thirds - face) - Real(1));
  const Real height = of_place(Real(4) * uv.v - select(lower, Real(1), Real(3)));

  const Mask<Real> middle = face == Real(1);
  const Real side = face - Real(1);
  const Vec3<Real> q{select(middle, across, side), height, select(middle, Real(1), -side * across)};
  return normalize(select(lower, other_band(q), q));
}

}  // namespace texmap
