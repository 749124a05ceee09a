// Angles in turns, and (u, v) of directions, by polynomials: no library function, no branch.
#pragma once
#include "polynomial.hpp"
#include "uv.hpp"

namespace texmap {

/// The fit behind an arc tangent of odd degree 5, 7, ... 19, 23, 29 or 35.
template <int Degree>
using ArcTangentFit = fits::ArcTangent<(Degree + 1) / 2>;

/// The fit of the arc cosine that goes with an arc tangent of that degree: together with the rounding about as good on a
/// texture twice as wide as high.
template <int Degree>
using ArcCosineFit = fits::ArcCosine<(Degree + 1) / 2 + (Degree < 13   ? 1
                                                         : Degree < 23 ? 2
                                                                       : 3)>;

/// Errors of a kernel: of u in turns, of v in half turns.
struct UvError {
  double u, v;
};

/// narrow / wide for 0 <= narrow <= wide, and 0 for two zeros. Numbers near the smallest normal one come out too small.
template <class Real>
[[nodiscard]] Real safe_ratio(const Real& narrow, const Real& wide) {
  return narrow / (wide + Real(std::numeric_limits<Scalar<Real>>::min()));
}

/// atan(t) in turns for t from 0 to 1: 0 to 1/8.
template <int Degree, class Real>
[[nodiscard]] Real eighth_turn(const Real& t) {
  return t * polynomial<ArcTangentFit<Degree>>(t * t);
}

/// The angle of the vector (x, y) in turns, from the size of its x and from whether that is above 0.
///
/// Made for callers that know the opposite of x: one negation is a fiftieth of the time of a whole (u, v).
template <int Degree, class Real>
[[nodiscard]] Real turn_of_parts(const Real& y, const Real& wide_x, const Mask<Real>& ahead) {
  const Real wide_y = abs(y);
  const Real eighth = eighth_turn<Degree>(safe_ratio(smaller(wide_x, wide_y), larger(wide_x, wide_y)));
  const Real quarter = select(wide_y > wide_x, Real(0.25) - eighth, eighth);
  const Real half = select(ahead, quarter, Real(0.5) - quarter);
  const Real turn = select(y < Real(0), Real(1) - half, half);
  // 1 - half rounds to 1 where half is tiny. Written out: a global pack would be read from memory.
  return smaller(turn, Real(Scalar<Real>(1) - std::numeric_limits<Scalar<Real>>::epsilon() / 2));
}

/// The angle of the vector (x, y) in turns, counterclockwise from +x.
///
/// @param y, x  any finite numbers
/// @return      [0, 1): exactly 0, 1/4, 1/2, 3/4 on the axes, whatever the signs of the zeros; 1/2 for the zero vector, which
///              has no angle: the middle of a texture's width
/// Worst error: that of the fit and 0.6 epsilon, for a longer side of at least 1e-30 in float, 1e-290 in double. Source: the
/// reduction to an eighth of a turn by min and max is folklore; the polynomial is fitted by fit/fit_kernels.cpp.
template <int Degree, class Real>
[[nodiscard]] Real turn_of(const Real& y, const Real& x) {
  return turn_of_parts<Degree>(y, abs(x), x > Real(0));
}

/// The angle between a vector and -y, in half turns, from its distance to the y axis and its y.
///
/// @param from_axis  0 or more
/// @return           0 to 1; exactly 0, 1/2 and 1 on the axis downwards, at a right angle to it and upwards; 1/2 for two zeros
/// Worst error: twice that of the fit and 1 epsilon. No digit is lost near the poles, where acos loses half of them.
template <int Degree, class Real>
[[nodiscard]] Real half_turn_of(const Real& from_axis, const Real& y) {
  const Real height = abs(y);
  const Real quarter = Real(2) * eighth_turn<Degree>(safe_ratio(smaller(from_axis, height), larger(from_axis, height)));
  const Real from_nearer_pole = select(height > from_axis, quarter, Real(0.5) - quarter);
  return select(y > Real(0), Real(1) - from_nearer_pole, from_nearer_pole);
}

/// The mapping of uv_rtiow, of any finite vector, by an arc tangent of that degree.
///
/// @param p  of a length from 1e-12 to 1e15 in float, 1e-140 to 1e150 in double; only its direction matters
/// @return   as uv_rtiow: u in [0, 1), v in [0, 1], the axes, the poles and the zero vector exactly as there. Vectors outside
/// the
///           stated lengths lose digits, but finite ones give no NaN
/// Worst error: `worst<Real>`.
template <int Degree>
struct FastMapping {
  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    const Real from_axis = sqrt(p.x * p.x + p.z * p.z);
    return {turn_of_parts<Degree>(p.z, abs(p.x), p.x < Real(0)), half_turn_of<Degree>(from_axis, p.y)};
  }

  /// Fit and rounding together. The constants of rounding are measured, with room, in tests/kernels/test_turns.cpp.
  template <class T>
  static constexpr UvError worst = {
      ArcTangentFit<Degree>::worst + 0.6 * static_cast<double>(std::numeric_limits<T>::epsilon()),
      2 * ArcTangentFit<Degree>::worst + 1.0 * static_cast<double>(std::numeric_limits<T>::epsilon()),
  };
};

/// The mapping of uv_rtiow, of unit vectors: faster than FastMapping, whose division for v it saves.
///
/// @param p  as `normalize` gives it: of length 1 within the rounding of its coordinates
/// @return   u as FastMapping; v in [0, 1], the poles exact, the equator within the worst error
/// The angle from the nearer pole is sin(a) Q(cos(a)) with a smooth Q, where sin(a) is the distance from the axis: as safe at
/// the poles as an arc tangent. Worst error: `worst<Real>`, of which about half an epsilon of v is the length's.
template <int Degree>
struct FastUnitMapping {
  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    const Real sine = sqrt(p.x * p.x + p.z * p.z);
    const Real from_nearer_pole = sine * polynomial<ArcCosineFit<Degree>>(abs(p.y));
    return {turn_of_parts<Degree>(p.z, abs(p.x), p.x < Real(0)),
            select(p.y > Real(0), Real(1) - from_nearer_pole, from_nearer_pole)};
  }

  template <class T>
  static constexpr UvError worst = {
      FastMapping<Degree>::template worst<T>.u,
      ArcCosineFit<Degree>::worst + 1.3 * static_cast<double>(std::numeric_limits<T>::epsilon()),
  };
};

}  // namespace texmap
