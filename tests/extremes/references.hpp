// The exact answers. What they judge are other formulas: if one of these were wrong, claims would
// break in the numbers of most digits.
#pragma once

#include "digits.hpp"

namespace texmap::extremes {

/// (u, v) of a vector, by angles: convention rtiow. For a vector on the y axis u has no meaning.
[[nodiscard]] inline Uv<Digits50> exact_uv(const Vec3<Digits50>& p) {
  const Digits50 turn = atan2(p.z, -p.x) / (2 * circle<Digits50>());
  return {turn < 0 ? Digits50(turn + 1) : turn,
          atan2(sqrt(p.x * p.x + p.z * p.z), -p.y) / circle<Digits50>()};
}

/// How far apart two places on a circle of length 1 are.
[[nodiscard]] inline Digits50 around(const Digits50& a, const Digits50& b) {
  const Digits50 apart = abs(a - b);
  return apart < 1 - apart ? apart : Digits50(1 - apart);
}

/// Where a ray meets a sphere around the origin.
struct ExactMeeting {
  bool meets = false;
  Digits50 impact;  ///< distance of the ray's line from the center, over the radius: 1 if it grazes
  Digits50 distance;
  Vec3<Digits50> normal;
};

/// The first point ahead by the quadratic equation. Digits cancel as they always do; 50 are enough.
[[nodiscard]] inline ExactMeeting exact_meeting(const Vec3<Digits50>& f, const Vec3<Digits50>& d,
                                                const Digits50& r) {
  const Digits50 a = dot(d, d);
  const Digits50 b = -dot(f, d);
  const Digits50 c = dot(f, f) - r * r;
  const Digits50 discriminant = b * b - a * c;
  ExactMeeting meeting;
  meeting.impact = sqrt(r * r - discriminant / a) / r;
  if (discriminant < 0) return meeting;
  const Digits50 root = sqrt(discriminant);
  // The sign of c tells inside from outside without an error. On the sphere (c = 0) the ray meets
  // the other end or nothing.
  if (c >= 0 && b <= 0) return meeting;
  meeting.meets = true;
  meeting.distance = c > 0 ? Digits50(c / (b + root)) : Digits50((b + root) / a);
  meeting.normal = (f + d * meeting.distance) * Digits50(1 / r);
  return meeting;
}

}  // namespace texmap::extremes
