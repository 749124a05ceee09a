// A number that knows how it changes: its value and two derivatives.
#pragma once
#include "number/compensated.hpp"
#include "number/table.hpp"

namespace texmap {

/// A value and its derivatives by two parameters x and y: by the column and the row of a pixel, or
/// by two steps along a surface. Code that is a template over its number then computes both.
/// Values are those of `Real`, to the last bit; intervals are wider. Masks look at values alone.
/// Bound: slopes of a mapping within 16 unit roundoffs of its steepest one.
/// Source: Clifford (1873); Wengert, "A Simple Automatic Derivative Evaluation Program" (1964).
template <class Real>
struct Dual {
  Real value{};
  Real dx{};  ///< how much `value` changes for a step of 1 in x
  Real dy{};

  Dual() = default;
  /// A constant: its derivatives are 0.
  template <class Number>
  requires std::is_constructible_v<Real, const Number&>
  explicit(!std::is_convertible_v<Number, Real>) Dual(const Number& number)
      : value(static_cast<Real>(number)), dx(0), dy(0) {}
  Dual(const Real& number, const Real& by_x, const Real& by_y)
      : value(number), dx(by_x), dy(by_y) {}

  friend Dual operator-(const Dual& a) { return {-a.value, -a.dx, -a.dy}; }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.dx + b.dx, a.dy + b.dy};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.dx - b.dx, a.dy - b.dy};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.dx * b.value + a.value * b.dx, a.dy * b.value + a.value * b.dy};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const Real quotient = a.value / b.value;
    const Real inverse = Real(1) / b.value;
    return {quotient, (a.dx - quotient * b.dx) * inverse, (a.dy - quotient * b.dy) * inverse};
  }

  friend auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend auto operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend auto operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend auto operator==(const Dual& a, const Dual& b) { return a.value == b.value; }

  /// `yes` where the mask is true, else `no`: value and derivatives.
  friend Dual select(const Mask<Real>& mask, const Dual& yes, const Dual& no) {
    return {select(mask, yes.value, no.value), select(mask, yes.dx, no.dx),
            select(mask, yes.dy, no.dy)};
  }
};

template <class Real>
struct NumberTraits<Dual<Real>> : NumberTraits<Real> {
  template <class Value>
  [[nodiscard]] static Dual<Real> from_lanes(Value value) {
    return Dual<Real>(texmap::from_lanes<Real>(value));
  }
};

/// f(x) from its value and its derivative at x: the chain rule.
template <class Real>
[[nodiscard]] Dual<Real> chain(const Real& value, const Real& derivative, const Dual<Real>& x) {
  return {value, derivative * x.dx, derivative * x.dy};
}

template <class Real>
[[nodiscard]] Dual<Real> abs(const Dual<Real>& x) {
  return chain(abs(x.value), select(x.value < Real(0), Real(-1), Real(1)), x);
}
template <class Real>
[[nodiscard]] Dual<Real> floor(const Dual<Real>& x) {
  return Dual<Real>(floor(x.value));
}
/// At 0 the derivatives are infinite or NaN.
template <class Real>
[[nodiscard]] Dual<Real> sqrt(const Dual<Real>& x) {
  const Real root = sqrt(x.value);
  return chain(root, Real(0.5) / root, x);
}
template <class Real>
[[nodiscard]] Dual<Real> exp(const Dual<Real>& x) {
  const Real value = exp(x.value);
  return chain(value, value, x);
}
template <class Real>
[[nodiscard]] Dual<Real> log1p(const Dual<Real>& x) {
  return chain(log1p(x.value), Real(1) / (Real(1) + x.value), x);
}
template <class Real>
[[nodiscard]] Dual<Real> sin(const Dual<Real>& x) {
  return chain(sin(x.value), cos(x.value), x);
}
template <class Real>
[[nodiscard]] Dual<Real> cos(const Dual<Real>& x) {
  return chain(cos(x.value), -sin(x.value), x);
}
template <class Real>
[[nodiscard]] Dual<Real> power(const Dual<Real>& x, Scalar<Real> exponent) {
  return chain(power(x.value, exponent),
               Real(exponent) * power(x.value, exponent - Scalar<Real>(1)), x);
}
/// Textbook: (x y' - y x') / (x^2 + y^2). Here divided by the larger first: no square underflows.
template <class Real>
[[nodiscard]] Dual<Real> atan2(const Dual<Real>& y, const Dual<Real>& x) {
  const Real scale = Real(1) / max(abs(x.value), abs(y.value));
  const Real along_x = x.value * scale;
  const Real along_y = y.value * scale;
  const Real factor = scale / (along_x * along_x + along_y * along_y);
  return {atan2(y.value, x.value), (along_x * y.dx - along_y * x.dx) * factor,
          (along_x * y.dy - along_y * x.dy) * factor};
}

/// The value clamped. The derivatives are kept up to 4 unit roundoffs beyond the limits, where
/// clamp only guards against rounding, and are 0 farther out.
template <class Real>
[[nodiscard]] Dual<Real> clamp(const Dual<Real>& x, const Dual<Real>& low, const Dual<Real>& high) {
  const Real value = clamp(x.value, low.value, high.value);
  const Mask<Real> inside =  // the first two comparisons are certain for most intervals
      (x.value >= low.value && x.value <= high.value) ||
      abs(x.value - value) <= Real(4) * unit_roundoff<Real>() * max(abs(value), Real(1));
  return {value, select(inside, x.dx, Real(0)), select(inside, x.dy, Real(0))};
}

/// The scale of the value, a constant.
template <class Real>
[[nodiscard]] Dual<Real> power_of_two_scale(const Dual<Real>& size) {
  return Dual<Real>(power_of_two_scale(size.value));
}

template <class Real>
[[nodiscard]] Scalar<Real> lane(const Dual<Real>& x, std::size_t i) {
  return lane(x.value, i);
}
template <class Real>
[[nodiscard]] auto all_lanes(const Dual<Real>& x) {
  return all_lanes(x.value);
}
/// What a table holds does not change from pixel to pixel: constants.
template <class Real, class Table>
[[nodiscard]] std::array<Dual<Real>, 3> look_up(const Table& table, const Dual<Real>& column,
                                                const Dual<Real>& row) {
  const std::array<Real, 3> entry = look_up(table, column.value, row.value);
  return {Dual<Real>(entry[0]), Dual<Real>(entry[1]), Dual<Real>(entry[2])};
}

}  // namespace texmap
