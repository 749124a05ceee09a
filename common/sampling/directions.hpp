// From two numbers in [0, 1) to points on a disk and to directions.
#pragma once
#include "math/circle.hpp"
#include "math/vec3.hpp"
#include "sampling/point2.hpp"

namespace texmap {

/// A point of the unit disk.
template <class Real>
struct OnDisk {
  Real x, y;
  Real radius;  ///< distance from the center, in [0, 1)
  Real height;  ///< sqrt(1 - radius^2), of the unit hemisphere above the point, in (0, 1]
};

/// A uniform point of the unit disk: concentric squares become concentric circles.
///
/// @param sample  u and v in [0, 1), multiples of 2^-24
/// @return        inside the disk, never on its edge or at its center
/// Source: Shirley and Chiu, "A Low Distortion Map Between Disk and Square" (1997).
template <class Real>
[[nodiscard]] inline OnDisk<Real> uniform_disk(const Point2<Real>& sample) {
  // Moves multiples of 2^-24 to the middle of their step, exactly. The outermost steps are clamped,
  // or rounding would leave the disk; so is the rest of numbers with more digits.
  const auto centered = [](const Real& x) {
    const Real most = Real(1) - Real(0x1p-22F);
    return max(-most, min((Real(2) * x - Real(1)) + Real(0x1p-24F), most));
  };
  const Real a = centered(sample.u);
  const Real b = centered(sample.v);
  const Mask<Real> wide = abs(a) > abs(b);
  const Real major = select(wide, a, b);
  const Real minor = select(wide, b, a);
  const Real divisor = select(major == Real(0), Real(1), major);
  const OnCircle<Real> from_axis = on_circle_eighth<Real>(minor / divisor * Real(0.125F));
  const Real along = major * from_axis.cosine;
  const Real across = major * from_axis.sine;
  const Real radius = abs(major);
  return {select(wide, along, across), select(wide, across, along), radius,
          sqrt((Real(1) - radius) * (Real(1) + radius))};
}

/// Two unit vectors that form a right-handed frame with a normal: cross(right, up) = normal.
template <class Real>
struct Frame {
  Vec3<Real> right, up;
};

/// The frame about a unit normal, for any direction.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited" (2017).
template <class Real>
[[nodiscard]] inline Frame<Real> frame_about(const Vec3<Real>& normal) {
  const Real sign = select(normal.z < Real(0), Real(-1), Real(1));
  const Real a = Real(-1) / (sign + normal.z);
  const Real b = normal.x * normal.y * a;
  return {
      {Real(1) + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
      {b, sign + normal.y * normal.y * a, -normal.y},
  };
}

/// A direction scattered by a Lambertian surface: its density is cos(angle to the normal) / pi.
///
/// @param normal, sample  unit length; u and v in [0, 1)
/// @return  unit length, at least 3e-4 above the surface
/// Textbook: normal + a random unit vector, which can be zero. Here Malley's method: pbrt, A.5.
template <class Real>
[[nodiscard]] inline Vec3<Real> cosine_direction(const Vec3<Real>& normal,
                                                 const Point2<Real>& sample) {
  const OnDisk<Real> disk = uniform_disk(sample);
  const Frame<Real> frame = frame_about(normal);
  return frame.right * disk.x + frame.up * disk.y + normal * disk.height;
}

}  // namespace texmap
