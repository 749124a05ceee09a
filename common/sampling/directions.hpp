// From two numbers in [0, 1) to points on a disk and to directions, without a branch and without a weak spot at the poles.
#pragma once
#include <array>

#include "sample2.hpp"
#include "vec3.hpp"

namespace texmap {

/// The cosine and the sine of an angle: a point on the unit circle.
template <class Real>
struct OnCircle {
  Real cosine, sine;
};

/// The series of cos(2 pi x) and of sin(2 pi x) / x in powers of x^2, cut where the rest is below half a unit roundoff for
/// |x| <= 1/8.
/// Source: Taylor's series.
template <class Number>
struct CircleSeries {
  static constexpr int digits = std::numeric_limits<Number>::digits;
  static constexpr std::size_t terms = digits <= 24 ? 6 : digits <= 53 ? 10 : digits <= 64 ? 12 : 25;
  std::array<Number, terms> cosine{}, sine{};

  constexpr CircleSeries() {
    const Number turn = Number(2) * std::numbers::pi_v<Number>;
    cosine[0] = Number(1);
    sine[0] = turn;
    for (std::size_t k = 1; k < terms; ++k) {
      cosine[k] = -cosine[k - 1] * turn * turn / static_cast<Number>(2 * k * (2 * k - 1));
      sine[k] = -sine[k - 1] * turn * turn / static_cast<Number>(2 * k * (2 * k + 1));
    }
  }
};

/// cos(2 pi x) and sin(2 pi x) for at most an eighth of a turn either way.
///
/// @param x  in [-1/8, 1/8], in turns
/// Errors: below 2 unit roundoffs of 1; measured 1.6 in float and 1.4 in double.
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

/// cos(2 pi x) and sin(2 pi x) for any part of a turn.
///
/// @param x  in [0, 1), in turns; exact at the quarters. Whole turns more or less cost digits of x and nothing else
/// Errors: as on_circle_eighth.
template <class Real>
[[nodiscard]] inline OnCircle<Real> on_circle(const Real& x) {
  const Real quarter = floor(x * Real(4) + Real(0.5F));
  const OnCircle<Real> near = on_circle_eighth<Real>(x - quarter * Real(0.25F));
  const Real half = quarter * Real(0.5F);
  const Mask<Real> swapped = floor(half) < half;  // an odd number of quarters
  const Real quadrant = quarter - floor(quarter * Real(0.25F)) * Real(4);
  const Real cosine = select(swapped, near.sine, near.cosine);
  const Real sine = select(swapped, near.cosine, near.sine);
  return {
      select(abs(quadrant - Real(1.5F)) < Real(1), -cosine, cosine),  // quarters 1 and 2
      select(quadrant > Real(1.5F), -sine, sine),                     // quarters 2 and 3
  };
}

/// A point of the unit disk.
template <class Real>
struct OnDisk {
  Real x, y;
  Real radius;  ///< of the circle about the center through the point, in [0, 1)
  Real height;  ///< of the unit hemisphere above the point, in (0, 1]
};

/// A point of the unit disk, uniform if the sample is: squares about the middle become circles about the center.
///
/// @param sample  u and v in [0, 1)
/// @return  a point inside the disk, never on its edge; a multiple of 2^-24 is taken for the middle of its step of that size,
///          so that the center is missed as well
/// Source: Shirley and Chiu, "A Low Distortion Map Between Disk and Square" (1997).
template <class Real>
[[nodiscard]] inline OnDisk<Real> uniform_disk(const Sample2<Real>& sample) {
  // Exact for multiples of 2^-24; numbers with more digits could step over the edge.
  const auto centered = [](const Real& x) {
    return smaller((Real(2) * x - Real(1)) + Real(0x1p-24F), Real(1) - Real(0x1p-24F));
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
  return {select(wide, along, across), select(wide, across, along), radius, sqrt((Real(1) - radius) * (Real(1) + radius))};
}

/// A direction, each as likely as any other if the sample is uniform.
///
/// @param sample  u and v in [0, 1)
/// @return  unit length, within 4 unit roundoffs
/// Source: Archimedes' theorem on the disk above: equal areas of the disk are equal areas of the sphere.
template <class Real>
[[nodiscard]] inline Vec3<Real> uniform_direction(const Sample2<Real>& sample) {
  const OnDisk<Real> disk = uniform_disk(sample);
  const Real scale = Real(2) * disk.height;
  return {disk.x * scale, disk.y * scale, Real(1) - Real(2) * disk.radius * disk.radius};
}

/// Two directions that make a right-handed frame with a normal: cross(right, up) is the normal.
template <class Real>
struct Frame {
  Vec3<Real> right, up;
};

/// @param normal  unit length, any direction: there is no pole at which it fails
/// Source: Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin, "Building an Orthonormal Basis, Revisited" (2017).
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

/// A direction as a matt surface scatters light: its density is the cosine of its angle to the normal, divided by pi.
///
/// @param normal  unit length
/// @param sample  u and v in [0, 1)
/// @return  unit length within a few unit roundoffs; always on the normal's side, at least 3e-4 from the surface
/// Source: Malley's method: a point of the disk, lifted onto the hemisphere. Pharr, Jakob and Humphreys, Physically Based
/// Rendering, section A.5. The book's "normal plus a random unit vector" has the same density, but loses digits near the
/// surface and can give no direction at all.
template <class Real>
[[nodiscard]] inline Vec3<Real> cosine_direction(const Vec3<Real>& normal, const Sample2<Real>& sample) {
  const OnDisk<Real> disk = uniform_disk(sample);
  const Frame<Real> frame = frame_about(normal);
  return frame.right * disk.x + frame.up * disk.y + normal * disk.height;
}

}  // namespace texmap
