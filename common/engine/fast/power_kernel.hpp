// Phong's power by two polynomials.
#pragma once
#include "engine/fast/polynomial.hpp"

namespace texmap {

/// cos^s for one exponent s, as 2^x with x = s log2(cos): 0 below 2^-16, a 250th of a level.
/// docs/numerics.md says how the arguments of both polynomials are reduced.
///
/// @tparam Terms  of the logarithm: 3 or 6
template <int Terms>
class PowerKernel {
  using LogarithmFit = fits::Logarithm<Terms>;
  using ExponentialFit = fits::Exponential<Terms == 3 ? 2 : 3>;

 public:
  /// What rounding adds, in epsilons, for every s: docs/numerics.md has the sum.
  static constexpr double rounding =
      16.1 + (LogarithmFit::rounding + 1) / 2.718 + ExponentialFit::rounding;

  /// Largest error in levels of 255, for every s. An error of the logarithm counts 1 / 2.718.
  template <class T>
  static constexpr double worst_levels =
      255 * (LogarithmFit::worst / 2.718 + ExponentialFit::worst + 0x1p-16 +
             rounding * static_cast<double>(std::numeric_limits<T>::epsilon()));

  /// @param exponent  s, 0 to 1e30
  explicit PowerKernel(double exponent) : exponent_(exponent) {
    for (; exponent_ < 16 && roots_ < 20; exponent_ *= 2) ++roots_;
  }

  /// @param versine  1 - cos, 0 or more; near 0 it has digits that the cosine has lost
  /// @return         0 to 1; exactly 1 for versine 0, and 0 from versine 1 on
  /// From one float to the next it rises by at most 8 epsilon.
  template <class Real>
  [[nodiscard]] Real operator()(const Real& versine) const {
    Real shortfall = clamp(versine, Real(0), Real(1));
    if (roots_ > 0) {
      Real cosine = Real(1) - shortfall;
      for (int i = 0; i < roots_; ++i) cosine = sqrt(cosine);
      shortfall = Real(1) - cosine;
    }
    const Real near = min(shortfall, Real(0.5));
    const Real x = Real(exponent_) * (near * polynomial<LogarithmFit>(near));
    const Real y = max(x, Real(-16)) * Real(1. / 16);
    const Real root = Real(1) + y * polynomial<ExponentialFit>(y);
    const Real power = square(square(square(square(root))));
    return select(x > Real(-16) && versine < Real(1), power, Real(0));
  }

 private:
  double exponent_;
  int roots_ = 0;
};

}  // namespace texmap
