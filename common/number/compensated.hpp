// Exact sums and products: a result together with its rounding error.
#pragma once
#include <array>
#include <bit>

#include "number/number.hpp"

namespace texmap {

/// A number in two parts: `high + low` with |low| at most half a unit in the last place of `high`.
template <class Real>
struct TwoParts {
  Real high, low;
};

/// a + b without an error: `high` is the rounded sum, `low` its rounding error.
/// Domain: no overflow. Source: Knuth, The Art of Computer Programming, volume 2, section 4.2.2.
template <class Real>
[[nodiscard]] TwoParts<Real> two_sum(const Real& a, const Real& b) {
  const Real sum = a + b;
  const Real b_kept = sum - a;
  const Real a_kept = sum - b_kept;
  return {sum, (a - a_kept) + (b - b_kept)};
}

/// `x` as a sum of two numbers with half the digits each, so that their products are exact.
/// Domain: |x| below the largest number / 2^(digits / 2 + 2).
/// Source: Veltkamp; Dekker, "A Floating-Point Technique for Extending the Available Precision".
template <class Real>
[[nodiscard]] TwoParts<Real> split(const Real& x) {
  constexpr int digits = std::numeric_limits<Scalar<Real>>::digits;
  const Real factor = Real(ldexp(Scalar<Real>(1), (digits + 1) / 2) + Scalar<Real>(1));
  const Real shifted = factor * x;
  const Real high = shifted - (shifted - x);
  return {high, x - high};
}

/// a b without an error: `high` is the rounded product, `low` its rounding error.
/// Domain: that of `split`; |a b| above the smallest normal number times 2^digits. Source: Dekker.
template <class Real>
[[nodiscard]] TwoParts<Real> two_product(const Real& a, const Real& b) {
  const Real product = a * b;
  const TwoParts<Real> p = split(a), q = split(b);
  return {product, ((p.high * q.high - product) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

/// a b - c d, however much of the two products cancels. Domain: as two_product.
/// Bound: 2 unit roundoffs of the result. Source: Kahan; Jeannerod, Louvet and Muller (2013).
template <class Real>
[[nodiscard]] Real difference_of_products(const Real& a, const Real& b, const Real& c,
                                          const Real& d) {
  const TwoParts<Real> ab = two_product(a, b);
  const TwoParts<Real> cd = two_product(c, d);
  const TwoParts<Real> difference = two_sum(ab.high, -cd.high);
  return difference.high + (difference.low + (ab.low - cd.low));
}

/// A sum with the error of one rounding, unless more than half of the digits cancel.
/// Source: Ogita, Rump and Oishi, "Accurate Sum and Dot Product" (2005).
template <class Real>
class CompensatedSum {
 public:
  void add(const Real& x) {
    const TwoParts<Real> next = two_sum(sum_, x);
    sum_ = next.high;
    rest_ = rest_ + next.low;
  }
  void add_product(const Real& a, const Real& b) {
    const TwoParts<Real> product = two_product(a, b);
    add(product.high);
    rest_ = rest_ + product.low;
  }
  [[nodiscard]] Real value() const { return sum_ + rest_; }

 private:
  Real sum_ = Real(0);
  Real rest_ = Real(0);
};

/// 2^step and 2^-step for step = 1, 2, 4, ... up to half of the largest exponent of `Number`.
template <class Number>
struct PowersOfTwo {
  static constexpr std::size_t count =
      std::bit_width(static_cast<unsigned>(std::numeric_limits<Number>::max_exponent)) - 1;
  static_assert(std::numeric_limits<Number>::max_exponent > 0,
                "a number needs std::numeric_limits, as number/kinds/double_pair.hpp has them");
  std::array<Number, count> up, down;

  PowersOfTwo() {
    for (std::size_t i = 0; i < count; ++i) {
      up[i] = ldexp(Number(1), 1 << i);
      down[i] = ldexp(Number(1), -(1 << i));
    }
  }
};

/// The power of two that scales a normal `size` > 0 into [1, 2); for a subnormal one the largest
/// that there is, 1 for zero, NaN and infinities.
template <class Real>
[[nodiscard]] Real power_of_two_scale(const Real& size) {
  using Limits = std::numeric_limits<Scalar<Real>>;
  static const PowersOfTwo<Scalar<Real>> powers;
  const Mask<Real> ordinary = size > Real(0) && size <= Real(Limits::max());
  Real rest = select(ordinary, size, Real(1));
  Real scale = Real(1);
  for (std::size_t i = powers.count; i-- > 0;) {
    const Real up = Real(powers.up[i]);
    const Real down = Real(powers.down[i]);
    const Mask<Real> large = rest >= up;
    rest = select(large, rest * down, rest);
    scale = select(large, scale * down, scale);
    const Mask<Real> small = rest < Real(2) * down;
    rest = select(small, rest * up, rest);
    scale = select(small, scale * up, scale);
  }
  return scale;
}

}  // namespace texmap
