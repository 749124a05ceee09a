// The exact answers, each by two formulas: if one of them were wrong, they would not agree.
#pragma once
#include <numbers>

#include "digits.hpp"
#include "scene/ray.hpp"

namespace texmap::extremes {

/// u and v with all their digits.
template <class Exact>
struct ExactUv {
  Exact u, v;
};

/// (u, v) of a vector, by angles: convention rtiow. For a vector on the y axis u has no meaning.
template <class Exact>
[[nodiscard]] ExactUv<Exact> exact_uv(const Vec3<Exact>& p) {
  const Exact turn = atan2(p.z, -p.x) / (2 * circle<Exact>());
  return {turn < 0 ? turn + 1 : turn, atan2(sqrt(p.x * p.x + p.z * p.z), -p.y) / circle<Exact>()};
}

/// The same by the inverse cosine of a unit vector's coordinates. It loses digits; 100 are enough.
[[nodiscard]] inline ExactUv<Digits100> exact_uv_by_acos(const Vec3<Digits100>& p) {
  const Digits100 wide = sqrt(p.x * p.x + p.z * p.z);
  const Digits100 half = acos(-p.x / wide) / (2 * circle<Digits100>());
  return {p.z < 0 ? 1 - half : half,
          acos(-p.y / sqrt(wide * wide + p.y * p.y)) / circle<Digits100>()};
}

/// How far apart two places on a circle of length 1 are.
template <class Exact>
[[nodiscard]] Exact around(const Exact& a, const Exact& b) {
  const Exact apart = abs(a - b);
  return apart < 1 - apart ? apart : Exact(1 - apart);
}

/// Where a ray meets a sphere around the origin.
template <class Exact>
struct ExactMeeting {
  bool meets = false;
  Exact impact;  ///< distance of the ray's line from the center, over the radius: 1 if it grazes
  Exact distance;
  Vec3<Exact> normal;
};

/// The first point ahead by the quadratic equation. Digits cancel as they always do; 50 are enough.
template <class Exact>
[[nodiscard]] ExactMeeting<Exact> exact_meeting(const Vec3<Exact>& f, const Vec3<Exact>& d,
                                                const Exact& r) {
  const Exact a = dot(d, d);
  const Exact b = -dot(f, d);
  const Exact c = dot(f, f) - r * r;
  const Exact discriminant = b * b - a * c;
  ExactMeeting<Exact> meeting;
  meeting.impact = sqrt(r * r - discriminant / a) / r;
  if (discriminant < 0) return meeting;
  const Exact root = sqrt(discriminant);
  // The sign of c tells inside from outside without an error. On the sphere (c = 0) the ray meets
  // the other end or nothing.
  if (c >= 0 && b <= 0) return meeting;
  meeting.meets = true;
  meeting.distance = c > 0 ? Exact(c / (b + root)) : Exact((b + root) / a);
  meeting.normal = (f + d * meeting.distance) * Exact(1 / r);
  return meeting;
}

/// The same from the line's nearest point to the center and half the chord.
template <class Exact>
[[nodiscard]] ExactMeeting<Exact> exact_meeting_by_chord(const Vec3<Exact>& f, const Vec3<Exact>& d,
                                                         const Exact& r) {
  const Exact speed = sqrt(dot(d, d));
  const Vec3<Exact> unit = d * Exact(1 / speed);
  const Exact along = -dot(f, unit);
  const Vec3<Exact> nearest = f + unit * along;
  ExactMeeting<Exact> meeting;
  meeting.impact = sqrt(dot(nearest, nearest)) / r;
  if (meeting.impact > 1) return meeting;
  const Exact half_chord = sqrt(r * r - dot(nearest, nearest));
  const bool outside = sqrt(dot(f, f)) > r;
  if (outside && along < 0) return meeting;
  meeting.meets = true;
  meeting.distance = (outside ? Exact(along - half_chord) : Exact(along + half_chord)) / speed;
  meeting.normal =
      (nearest + unit * Exact(outside ? Exact(-half_chord) : half_chord)) * Exact(1 / r);
  return meeting;
}

/// The angle between a vector of T and an exact unit vector, in radians; infinity for a NaN.
template <class T>
[[nodiscard]] double angle_off(const Vec3<T>& got, const Vec3<Digits50>& exact) {
  if (!std::isfinite(got.x + got.y + got.z)) return std::numeric_limits<double>::infinity();
  const Vec3<Digits50> n = exactly(got);
  const Vec3<Digits50> sine = cross(n, exact);
  return static_cast<double>(atan2(sqrt(dot(sine, sine)), dot(n, exact)));
}

/// From an angle to texels of a map 8192 wide.
constexpr double texels_per_radian = 8192 / (2 * std::numbers::pi);

template <class Exact>
struct ExactAngle {
  Exact sine, cosine;
};

/// Sine and cosine of an angle in degrees, reduced in whole numbers: every floating-point number is
/// a whole number times a power of two, and whole numbers have exact remainders.
template <class T>
[[nodiscard]] ExactAngle<Digits50> exact_angle(T degrees) {
  int exponent = 0;
  const T mantissa = std::frexp(std::fabs(degrees), &exponent);
  const auto whole =
      static_cast<std::uint64_t>(std::ldexp(mantissa, std::numeric_limits<T>::digits));
  exponent -= std::numeric_limits<T>::digits;
  Digits50 turn;
  if (exponent >= 0) {
    std::uint64_t rest = whole % 360;
    for (int i = 0; i < exponent; ++i) rest = rest * 2 % 360;
    turn = rest;
  } else if (exponent > -80) {
    // whole / 2^-exponent modulo 360, as (whole mod 360 2^-exponent) / 2^-exponent.
    const boost::multiprecision::uint256_t period = boost::multiprecision::uint256_t(360)
                                                    << -exponent;
    turn = ldexp(Digits50(static_cast<boost::multiprecision::uint256_t>(whole % period)), exponent);
  } else {
    turn = ldexp(Digits50(whole), exponent);
  }
  const Digits50 radians = turn * circle<Digits50>() / 180;
  // The sines of whole quarter turns are known; 50 digits of pi would miss them.
  const bool upright = turn == 90 || turn == 270;
  const bool level = turn == 0 || turn == 180;
  const Digits50 sine = level ? Digits50(0) : sin(radians);
  return {degrees < 0 ? Digits50(-sine) : sine, upright ? Digits50(0) : cos(radians)};
}

/// The weights of a point in a triangle's plane, by Cramer's rule on dot products of the sides.
template <class Exact>
[[nodiscard]] Vec3<Exact> exact_weights(const Vec3<Exact>& a, const Vec3<Exact>& b,
                                        const Vec3<Exact>& c, const Vec3<Exact>& p) {
  const Vec3<Exact> ab = b - a;
  const Vec3<Exact> ac = c - a;
  const Vec3<Exact> ap = p - a;
  const Exact bb = dot(ab, ab);
  const Exact bc = dot(ab, ac);
  const Exact cc = dot(ac, ac);
  const Exact pb = dot(ap, ab);
  const Exact pc = dot(ap, ac);
  const Exact whole = bb * cc - bc * bc;
  const Exact at_b = (pb * cc - pc * bc) / whole;
  const Exact at_c = (pc * bb - pb * bc) / whole;
  return {1 - at_b - at_c, at_b, at_c};
}

/// The same as three areas along the normal over the whole area.
template <class Exact>
[[nodiscard]] Vec3<Exact> exact_weights_by_areas(const Vec3<Exact>& a, const Vec3<Exact>& b,
                                                 const Vec3<Exact>& c, const Vec3<Exact>& p) {
  const Vec3<Exact> n = cross(b - a, c - a);
  const Exact whole = dot(n, n);
  return {dot(n, cross(b - p, c - p)) / whole, dot(n, cross(c - p, a - p)) / whole,
          dot(n, cross(a - p, b - p)) / whole};
}

}  // namespace texmap::extremes
