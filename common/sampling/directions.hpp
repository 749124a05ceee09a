// From two numbers in [0, 1) to points on a disk and to directions, without a branch and without a weak spot at the poles.
#pragma once
#include "sample2.hpp"
#include "vec3.hpp"

namespace texmap {

/// The cosine and the sine of an angle: a point on the unit circle.
template <class Real>
struct OnCircle {
  Real cosine, sine;
};

/// cos(2 pi x) and sin(2 pi x) for at most an eighth of a turn either way.
///
/// @param x  in [-1/8, 1/8], in turns
/// Errors: below 2 unit roundoffs of 1; measured 1.6 in float and 1.4 in double.
/// Source: Taylor's series, cut where the rest is below half a unit roundoff.
template <class Real>
[[nodiscard]] inline OnCircle<Real> on_circle_eighth(const Real& x) {
  constexpr int digits = std::numeric_limits<Scalar<Real>>::digits;
  constexpr int terms = digits <= 24 ? 5 : digits <= 53 ? 9 : 12;
  const Real angle = x * (Real(2) * pi<Real>());
  const Real squared = angle * angle;
  Real sine = Real(1);
  Real cosine = Real(1);
  for (int i = terms; i > 0; --i) {  // Horner's rule; 1 / ((2i)(2i + 1)) is from one term of the series to the next
    using Single = Scalar<Real>;
    sine = Real(1) - sine * squared * Real(Single(1) / static_cast<Single>(2 * i * (2 * i + 1)));
    cosine = Real(1) - cosine * squared * Real(Single(1) / static_cast<Single>(2 * i * (2 * i - 1)));
  }
  return {cosine, sine * angle};
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
