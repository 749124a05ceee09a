// Smooth functions of a place in a unit square, as polynomials.
#pragma once
#include <array>
#include <cstddef>

#include "number.hpp"

namespace texmap {

/// A function of a place (x, y) in the unit square about the origin, as a polynomial of the first degree.
template <class Real>
struct Linear {
  Real middle, along_x, along_y;

  /// @param x, y  in [-1/2, 1/2]
  [[nodiscard]] Real operator()(const Real& x, const Real& y) const { return middle + (x * along_x + y * along_y); }
};

/// The same of the second degree in x and in y, which agrees with the function at nine places.
///
/// The places are Chebyshev's, where the polynomial strays least from a smooth function between them.
/// Source: Trefethen, Approximation Theory and Approximation Practice (2013), chapters 2 and 4.
template <class Real>
struct Biquadratic {
  std::array<std::array<Real, 3>, 3> at;  ///< coefficients: at[j][i] goes with x^i y^j

  static constexpr double step = 0.43301270189221932;  ///< sqrt(3) / 4: a coordinate of the places is -step, 0 or step

  /// An error at the nine places grows by at most this, in the corners of the square: (5 / 3)^2.
  static constexpr double worst_growth = 2.78;

  Biquadratic() = default;
  /// @param nine  what at_nine_places gave
  /// @param part  called with one of them, gives the number that the polynomial is for
  template <class Nine, class Part>
  Biquadratic(const Nine& nine, const Part& part) {
    std::array<std::array<Real, 3>, 3> in_x;
    for (std::size_t j = 0; j < 3; ++j) in_x[j] = parabola(part(nine[j][0]), part(nine[j][1]), part(nine[j][2]));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<Real, 3> in_y = parabola(in_x[0][i], in_x[1][i], in_x[2][i]);
      for (std::size_t j = 0; j < 3; ++j) at[j][i] = in_y[j];
    }
  }

  /// @param x, y  in [-1/2, 1/2]
  /// The constant, much larger than the rest, is added last.
  [[nodiscard]] Real operator()(const Real& x, const Real& y) const {
    const auto along_x = [&](std::size_t j) { return at[j][0] + x * (at[j][1] + x * at[j][2]); };
    return at[0][0] + (x * (at[0][1] + x * at[0][2]) + y * (along_x(1) + y * along_x(2)));
  }

  /// The polynomial of the first degree that is nearest to this one, but for its mixed terms.
  [[nodiscard]] Linear<Real> linear() const { return {at[0][0] + (at[0][2] + at[2][0]) * Real(0.125), at[0][1], at[1][0]}; }

 private:
  /// The coefficients of the parabola through three values, `step` apart.
  [[nodiscard]] static std::array<Real, 3> parabola(const Real& before, const Real& middle, const Real& behind) {
    const Real to = middle - before;
    const Real from = behind - middle;
    return {middle, (to + from) * Real(0.5 / step), (from - to) * Real(0.5 / (step * step))};
  }
};

/// What `function` gives at the nine places of a Biquadratic: [j][i] for x = (i - 1) step and y = (j - 1) step.
template <class Real, class Function>
[[nodiscard]] auto at_nine_places(const Function& function) {
  std::array<std::array<decltype(function(Real(0), Real(0))), 3>, 3> nine;
  const auto place = [](std::size_t k) { return Real((static_cast<double>(k) - 1) * Biquadratic<Real>::step); };
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) nine[j][i] = function(place(i), place(j));
  }
  return nine;
}

}  // namespace texmap
