// Rotation about the vertical axis, exact in degrees.
#pragma once
#include "vec3.hpp"

namespace texmap {

/// Sine and cosine of an angle.
template <class Real>
struct SineCosine {
  Real sine{}, cosine{};
};

/// Sine and cosine of an angle in degrees, of one plain number.
///
/// @param degrees  any finite angle. NaN and infinities give NaN
/// Bound: both within 3 ulp of themselves, for every angle that the number holds; docs/numbers.md.
/// The angle is reduced by whole turns in degrees, where a turn is the whole number 360 and nothing is rounded, then to the
/// nearest quarter turn: multiples of 90 come out as exactly -1, 0 and 1, and 1e9 degrees equal 280. In radians a turn is no
/// number of the machine: reducing 1e9 degrees there moves a float globe by 1930 texels.
template <class Real>
[[nodiscard]] SineCosine<Real> sine_cosine_of_degrees(Real degrees) {
  using std::cos;
  using std::fmod;
  using std::sin;
  const Real turn = fmod(degrees, Real(360));
  const Real quarter = floor(turn / Real(90) + Real(0.5));
  const Real rest = (turn - quarter * Real(90)) * pi<Real>() / Real(180);
  const Real s = sin(rest);
  const Real c = cos(rest);
  const Real quadrant = quarter - Real(4) * floor(quarter / Real(4));
  if (quadrant == Real(1)) return {c, -s};
  if (quadrant == Real(2)) return {-s, -c};
  if (quadrant == Real(3)) return {-c, s};
  return {s, c};
}

/// A rotation about +y, made once for a whole picture: the angle does not change from pixel to pixel.
struct RotationY {
  double sine = 0;
  double cosine = 1;

  /// The rotated point: x' = x cos + z sin, z' = z cos - x sin.
  ///
  /// @param p  any point or direction with coordinates below half of the largest number
  /// Errors: none; y stays to the bit, and a NaN in x or z makes both NaN.
  /// Bound: its length changes by 2 unit roundoffs at most, those of double in every number with more digits; docs/numbers.md.
  /// Source: seed 4, whose matrix multiplies from the right.
  template <class Real>
  [[nodiscard]] Vec3<Real> operator()(const Vec3<Real>& p) const {
    const Real s = Real(sine);
    const Real c = Real(cosine);
    return {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
  }
};

/// The rotation by an angle.
///
/// @param degrees  any finite angle; positive angles carry +z towards +x and add degrees / 360 to the u of every rtiow place
/// @return         sine and cosine within 3 ulp, as sine_cosine_of_degrees gives them
/// Errors: none; an angle that is not finite gives a rotation to NaN.
[[nodiscard]] inline RotationY rotation_y(double degrees) {
  const SineCosine<double> angle = sine_cosine_of_degrees(degrees);
  return {angle.sine, angle.cosine};
}

}  // namespace texmap
