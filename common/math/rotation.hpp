// Rotation about the vertical axis, exact in degrees.
#pragma once
#include "math/circle.hpp"
#include "math/vec3.hpp"

namespace texmap {

/// Cosine and sine of an angle in degrees, of one plain number; exact at multiples of 90.
///
/// @param degrees  any finite angle; NaN and infinities give NaN
template <class Real>
[[nodiscard]] OnCircle<Real> on_circle_of_degrees(Real degrees) {
  using std::fmod;
  const Real turn = fmod(degrees, Real(360));
  const Real quarter = floor(turn / Real(90) + Real(0.5));
  const Real rest = (turn - quarter * Real(90)) * pi<Real>() / Real(180);
  const Real s = sin(rest);
  const Real c = cos(rest);
  const Real quadrant = quarter - Real(4) * floor(quarter / Real(4));
  if (quadrant == Real(1)) return {-s, c};
  if (quadrant == Real(2)) return {-c, -s};
  if (quadrant == Real(3)) return {s, -c};
  return {c, s};
}

/// A rotation about +y, computed once a picture.
struct RotationY {
  double cosine = 1;
  double sine = 0;

  /// The rotated point: x' = x cos + z sin, y' = y, z' = z cos - x sin.
  ///
  /// @param p  any point or direction with coordinates below half of the largest number
  /// Source: the lecture, which multiplies row vectors by the matrix.
  template <class Real>
  [[nodiscard]] Vec3<Real> operator()(const Vec3<Real>& p) const {
    const Real s = Real(sine);
    const Real c = Real(cosine);
    return {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
  }
};

/// The rotation by an angle.
///
/// @param degrees  any finite angle; a positive one carries +z towards +x and adds degrees / 360
///                 to the u of uv_rtiow
[[nodiscard]] inline RotationY rotation_y(double degrees) {
  const OnCircle<double> angle = on_circle_of_degrees(degrees);
  return {angle.cosine, angle.sine};
}

}  // namespace texmap
