// Polynomials of degree one and two that approximate smooth functions on a unit square.
#pragma once
#include <array>
#include <cstddef>

#include "number/number.hpp"

namespace texmap {

/// A function on the unit square about the origin as a polynomial of degree 1.
template <class Real>
struct Linear {
  Real middle, along_x, along_y;

  /// @param x, y  in [-1/2, 1/2]
  [[nodiscard]] Real operator()(const Real& x, const Real& y) const {
    return middle + (x * along_x + y * along_y);
  }
};

/// The same of degree 2 in x and in y, which interpolates the function at nine Chebyshev points.
/// Source: Trefethen, Approximation Theory and Approximation Practice (2013), chapters 2 and 4.
template <class Real>
struct Biquadratic {
  std::array<std::array<Real, 3>, 3> at;  ///< coefficients: at[j][i] goes with x^i y^j

  static constexpr double step = 0.43301270189221932;  ///< sqrt(3) / 4: points at -step, 0, step

  /// Errors at the nine points grow by at most (5 / 3)^2, at the corners of the square.
  static constexpr double worst_growth = 2.78;

  Biquadratic() = default;
  /// @param nine  what at_nine_places returned
  /// @param part  called with one of them, returns the number to interpolate
  template <class Nine, class Part>
  Biquadratic(const Nine& nine, const Part& part) {
    std::array<std::array<Real, 3>, 3> in_x;
    for (std::size_t j = 0; j < 3; ++j)
      in_x[j] = parabola(part(nine[j][0]), part(nine[j][1]), part(nine[j][2]));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<Real, 3> in_y = parabola(in_x[0][i], in_x[1][i], in_x[2][i]);
      for (std::size_t j = 0; j < 3; ++j) at[j][i] = in_y[j];
    }
  }

  /// The value at x and y in [-1/2, 1/2]. The constant, the largest term, is added last.
  [[nodiscard]] Real operator()(const Real& x, const Real& y) const {
    const auto along_x = [&](std::size_t j) { return at[j][0] + x * (at[j][1] + x * at[j][2]); };
    return at[0][0] + (x * (at[0][1] + x * at[0][2]) + y * (along_x(1) + y * along_x(2)));
  }

  /// The nearest polynomial of degree 1, mixed terms left out.
  [[nodiscard]] Linear<Real> linear() const {
    return {at[0][0] + (at[0][2] + at[2][0]) * Real(0.125), at[0][1], at[1][0]};
  }

 private:
  /// The coefficients of the parabola through three values, `step` apart.
  [[nodiscard]] static std::array<Real, 3> parabola(const Real& before, const Real& middle,
                                                    const Real& behind) {
    const Real to = middle - before;
    const Real from = behind - middle;
    return {middle, (to + from) * Real(0.5 / step), (from - to) * Real(0.5 / (step * step))};
  }
};

/// `function` at the nine points of a Biquadratic: [j][i] is at x = (i - 1) step, y = (j - 1) step.
template <class Real, class Function>
[[nodiscard]] auto at_nine_places(const Function& function) {
  std::array<std::array<decltype(function(Real(0), Real(0))), 3>, 3> nine;
  const auto place = [](std::size_t k) {
    return Real((static_cast<double>(k) - 1) * Biquadratic<Real>::step);
  };
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) nine[j][i] = function(place(i), place(j));
  }
  return nine;
}

}  // namespace texmap
