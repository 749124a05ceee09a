// Points of the unit circle: cosines and sines of turns, in every number.
#pragma once
#include <array>

#include "number/number.hpp"

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

/// cos(2 pi x) and sin(2 pi x); exact at quarter turns.
///
/// @param x  in turns, |x| up to 1 / (8 unit roundoffs); NaN gives NaN
template <class Real>
[[nodiscard]] inline OnCircle<Real> on_circle(const Real& x) {
  const Real quarters = floor(Real(4) * x + Real(0.5));
  const OnCircle<Real> near = on_circle_eighth(x - quarters * Real(0.25));
  const Real quadrant = quarters - Real(4) * floor(quarters * Real(0.25));
  const Mask<Real> odd = quadrant == Real(1) || quadrant == Real(3);
  const Real cosine = select(odd, near.sine, near.cosine);
  const Real sine = select(odd, near.cosine, near.sine);
  return {select(quadrant == Real(1) || quadrant == Real(2), -cosine, cosine),
          select(quadrant >= Real(2), -sine, sine)};
}

}  // namespace texmap
