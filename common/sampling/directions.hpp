// From two numbers in [0, 1) to points on a disk and to directions.
#pragma once
#include <array>

#include "math/vec3.hpp"
#include "sampling/point2.hpp"

namespace texmap {

/// The cosine and the sine of an angle: a point on the unit circle.
template <class Real>
struct OnCircle {
  Real cosine, sine;
};

/// Taylor series of cos(2 pi x) and sin(2 pi x) / x in powers of x^2, for |x| <= 1/8; the rest is
/// below half a unit roundoff.
template <class Number>
struct CircleSeries {
  static constexpr int digits = std::numeric_limits<Number>::digits;
  static constexpr std::size_t terms = digits <= 24   ? 6
                                       : digits <= 53 ? 10
                                       : digits <= 64 ? 12
                                                      : 25;
  std::array<Number, terms> cosine{}, sine{};

  constexpr CircleSeries() {
    const Number turn = Number(2) * static_cast<Number>(pi_digits);
    cosine[0] = Number(1);
    sine[0] = turn;
    for (std::size_t k = 1; k < terms; ++k) {
      cosine[k] = -cosine[k - 1] * turn * turn / static_cast<Number>(2 * k * (2 * k - 1));
      sine[k] = -sine[k - 1] * turn * turn / static_cast<Number>(2 * k * (2 * k + 1));
    }
  }
};

/// cos(2 pi x) and sin(2 pi x) for at most an eighth of a turn.
///
/// @param x  in [-1/8, 1/8], in turns
/// Bound: 2 unit roundoffs of 1.
template <class Real>
[[nodiscard]] inline OnCircle<Real> on_circle_eighth(const Real& x) {
  static constexpr CircleSeries<Scalar<Real>> series;
  const Real squared = x * x;
  Real cosine = Real(series.cosine.back());
  Real sine = Real(series.sine.back());
  for (std::size_t k = series.terms - 1; k-- > 0;) {  // Horner's rule
    cosine = cosine * squared + Real(series.cosine[k]);
    sine = sine * squared + Real(series.sine[k]);
  }
  return {cosine, sine * x};
}

/// A point of the unit disk.
template <class Real>
struct OnDisk {
  Real x, y;
  Real radius;  ///< distance from the center, in [0, 1)
  Real height;  ///< sqrt(1 - radius^2), of the unit hemisphere above the point, in (0, 1]
};

/// A uniform point of the unit disk: concentric squares become concentric circles.
///
/// @param sample  u and v in [0, 1)
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
