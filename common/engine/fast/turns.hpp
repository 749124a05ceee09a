// Angles in turns, and (u, v) of directions, by polynomials.
#pragma once
#include <type_traits>

#include "engine/fast/polynomial.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// The fit of an arc tangent of degree 5, 9, 17, 23 or 35.
template <int Degree>
using ArcTangentFit = fits::ArcTangent<(Degree + 1) / 2>;

/// The arc cosine for an arc tangent of that degree: about equally good on a texture 2:1.
template <int Degree>
using ArcCosineFit = fits::ArcCosine<(Degree + 1) / 2 + (Degree < 17   ? 1
                                                         : Degree < 23 ? 2
                                                                       : 3)>;

/// Errors of a kernel: of u in turns, of v in half turns.
struct UvError {
  double u, v;
};

/// narrow / wide for 0 <= narrow <= wide; 0 for two zeros; too small for near-subnormal numbers.
template <class Real>
[[nodiscard]] Real safe_ratio(const Real& narrow, const Real& wide) {
  return narrow / (wide + Real(std::numeric_limits<Scalar<Real>>::min()));
}

/// atan(t) in turns for t from 0 to 1: 0 to 1/8. From one float to the next it falls by at most
/// 0.32 epsilon.
template <int Degree, class Real>
[[nodiscard]] Real eighth_turn(const Real& t) {
  return t * polynomial<ArcTangentFit<Degree>>(t * t);
}

/// The angle of the vector (x, y) in turns, counterclockwise from +x.
///
/// @param wide_x  |x|
/// @return  [0, 1): 0, 1/4, 1/2, 3/4 exactly on the axes; 1/2 for zero
/// Bound: as FastUnitMapping's u; longer side at least 1e-30 in float, 1e-290 in double.
template <int Degree, class Real>
[[nodiscard]] Real turn_of_parts(const Real& y, const Real& wide_x, const Mask<Real>& ahead) {
  const Real wide_y = abs(y);
  const Real eighth = eighth_turn<Degree>(safe_ratio(min(wide_x, wide_y), max(wide_x, wide_y)));
  const Real quarter = select(wide_y > wide_x, Real(0.25) - eighth, eighth);
  const Real half = select(ahead, quarter, Real(0.5) - quarter);
  const Real turn = select(y < Real(0), Real(1) - half, half);
  // 1 - half rounds to 1 where half is tiny.
  return min(turn, Real(Scalar<Real>(1) - std::numeric_limits<Scalar<Real>>::epsilon() / 2));
}

/// uv_rtiow for unit vectors, by an arc tangent of that degree.
/// The angle from the nearer pole is sin(a) Q(cos(a)), Q a polynomial, so poles are exact.
///
/// @param p  of length 1 within 2 unit roundoffs; half of what the length is off more adds to v
/// Bound: `worst<Real>`.
template <int Degree>
struct FastUnitMapping {
  static constexpr int degree = Degree;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    const Real sine = sqrt(p.x * p.x + p.z * p.z);
    const Real from_nearer_pole = sine * polynomial<ArcCosineFit<Degree>>(abs(p.y));
    return {turn_of_parts<Degree>(p.z, abs(p.x), p.x < Real(0)),
            select(p.y > Real(0), Real(1) - from_nearer_pole, from_nearer_pole)};
  }

  /// What rounding adds to both, in epsilons: by every float (tests/exhaustive), for other numbers
  /// by proof (tests/proofs). docs/numerics.md has the sums.
  template <class T>
  static constexpr UvError rounding =
      std::is_same_v<T, float>
          ? UvError{0.62, 1.83}
          : UvError{ArcTangentFit<Degree>::rounding + 0.48, ArcCosineFit<Degree>::rounding + 0.25};

  template <class T>
  static constexpr UvError worst = {
      ArcTangentFit<Degree>::worst +
          rounding<T>.u* static_cast<double>(std::numeric_limits<T>::epsilon()),
      ArcCosineFit<Degree>::worst +
          rounding<T>.v* static_cast<double>(std::numeric_limits<T>::epsilon()),
  };
};

}  // namespace texmap
