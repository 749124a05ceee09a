// The source documents' (u, v) and texel formulas as printed, and where they fail.
#pragma once
#include "texture/texel.hpp"
#include "texture/uv.hpp"
#include "texture/wrap.hpp"

namespace texmap::published {

/// The daily exercise: u = 1/2 + atan2(z, x) / 2 pi, v = 1/2 - asin(y) / pi.
/// Any vector: it is normalized first.
template <class Real>
[[nodiscard]] Uv<Real> uv_daily(const Vec3<Real>& point) {
  const Vec3<Real> p = normalize(point);
  return {Real(0.5) + atan2(p.z, p.x) / (Real(2) * pi<Real>()), Real(0.5) - asin(p.y) / pi<Real>()};
}

/// One Weekend 2020: u = 1 - (atan2(z, x) + pi) / 2 pi, v = (asin(y) + pi / 2) / pi.
/// Domain: a unit vector; |y| > 1 gives NaN.
template <class Real>
[[nodiscard]] Uv<Real> uv_one_weekend_2020(const Vec3<Real>& p) {
  return {Real(1) - (atan2(p.z, p.x) + pi<Real>()) / (Real(2) * pi<Real>()),
          (asin(p.y) + pi<Real>() / Real(2)) / pi<Real>()};
}

/// Next Week: u = (atan2(-z, x) + pi) / 2 pi, v = acos(-y) / pi.
/// Domain: a unit vector; |y| > 1 gives NaN.
template <class Real>
[[nodiscard]] Uv<Real> uv_next_week_v4(const Vec3<Real>& p) {
  return {(atan2(-p.z, p.x) + pi<Real>()) / (Real(2) * pi<Real>()), acos(-p.y) / pi<Real>()};
}

/// The lecture: u = atan2(x, z) / 2 pi, plus 1 if negative, v = 1 - acos(y) / pi.
/// Domain: a unit vector; |y| > 1 gives NaN.
template <class Real>
[[nodiscard]] Uv<Real> uv_lecture(const Vec3<Real>& p) {
  Real phi = atan2(p.x, p.z);
  if (phi < Real(0)) phi = phi + Real(2) * pi<Real>();
  return {phi / (Real(2) * pi<Real>()), Real(1) - acos(p.y) / pi<Real>()};
}

/// One Weekend 2020's row from the top: (int)((1 - v) n - 0.001), clamped.
template <class Real>
[[nodiscard]] TexelNumber<Real> row_one_weekend_2020(const Real& v, int n) {
  return clamp_number((Real(1) - v) * Real(n) - Real(0.001), n);
}

/// Next Week's row from the top: (int)((1 - v) n), v and row clamped. Domain: finite v.
template <class Real>
[[nodiscard]] int row_next_week_v4(Real v, int n) {
  const int j = static_cast<int>((Real(1) - clamp(v, Real(0), Real(1))) * Real(n));
  return j < n ? j : n - 1;
}

/// The triangle article's column or row: |(int)(u n)| mod n. It mirrors at 0, where rounding toward
/// 0 makes a texel twice as wide, and repeats at 1. Domain of u n: as remainder_of.
template <class Real>
[[nodiscard]] TexelNumber<Real> index_triangle(const Real& u, int n) {
  return clamp_number(remainder_of(floor(abs(u * Real(n))), Real(n)), n);
}

/// The lecture's row, counted from the top: n - 1 - (int)((n - 1) v). Domain: v in [0, 1].
template <class Real>
[[nodiscard]] int row_lecture(Real v, int n) {
  return n - 1 - static_cast<int>(Real(n - 1) * v);
}

}  // namespace texmap::published
