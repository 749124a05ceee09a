// Packs: several numbers that are computed at once and used like one.
#pragma once
#include <array>
#include <limits>
#include <type_traits>

#include "number/kinds/batch.hpp"
#include "number/kinds/pack_u32.hpp"

namespace texmap {

/// As many floats or doubles as a vector register holds; each lane is rounded like a single number.
/// Bound: atan2 2.4 ulp; exp and log1p 2 ulp of the C library's. atan2(0, 0) is NaN.
///
/// @tparam Arch  the machine instructions it is made of. Packs of several widths are different
///               types, so the linker cannot confuse their functions.
template <class T, class Arch = simd::default_arch>
class Pack {
 public:
  using Batch = simd::batch<T, Arch>;
  using Mask = simd::batch_bool<T, Arch>;

  Pack() = default;
  Pack(const Batch& values)
      : values_(values) {}  // NOLINT(google-explicit-constructor): a pack is its values
  /// The same number in every lane.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit Pack(Number number) : values_(static_cast<T>(number)) {}

  [[nodiscard]] T get(std::size_t i) const { return values_.get(i); }
  [[nodiscard]] const Batch& batch() const { return values_; }

  friend Pack operator+(const Pack& a, const Pack& b) { return a.values_ + b.values_; }
  friend Pack operator-(const Pack& a, const Pack& b) { return a.values_ - b.values_; }
  friend Pack operator*(const Pack& a, const Pack& b) { return a.values_ * b.values_; }
  friend Pack operator/(const Pack& a, const Pack& b) { return simd::divide(a.values_, b.values_); }
  friend Pack operator-(const Pack& a) { return -a.values_; }

  friend Mask operator<(const Pack& a, const Pack& b) { return a.values_ < b.values_; }
  friend Mask operator<=(const Pack& a, const Pack& b) { return a.values_ <= b.values_; }
  friend Mask operator>(const Pack& a, const Pack& b) { return a.values_ > b.values_; }
  friend Mask operator>=(const Pack& a, const Pack& b) { return a.values_ >= b.values_; }
  friend Mask operator==(const Pack& a, const Pack& b) { return a.values_ == b.values_; }

  friend Pack select(const Mask& mask, const Pack& yes, const Pack& no) {
    return simd::select(mask, yes.values_, no.values_);
  }
#if defined(__x86_64__)  // its instructions give `b` for a NaN in `a`; others give the NaN
  friend Pack max(const Pack& a, const Pack& b) { return simd::max(a.values_, b.values_); }
  friend Pack min(const Pack& a, const Pack& b) { return simd::min(a.values_, b.values_); }
#endif
  friend Pack abs(const Pack& a) { return simd::abs(a.values_); }
  friend Pack sqrt(const Pack& a) { return simd::sqrt(a.values_); }
  friend Pack floor(const Pack& a) {
    if constexpr (rounds) return simd::floor(a.values_);
    // Without an instruction xsimd rounds by way of integers. Numbers this large are whole.
    const Mask small = simd::abs(a.values_) < Batch(T(1) / std::numeric_limits<T>::epsilon());
    return simd::select(small, simd::floor(simd::select(small, a.values_, Batch(T(0)))), a.values_);
  }
  // Cephes' atan.c and atanf.c, as in xsimd, but with one division: the octant decides what is
  // divided, and atan(t) = pi / 4 + atan((t - 1) / (t + 1)) reduces t to tan(pi / 8).
  friend Pack atan2(const Pack& y, const Pack& x) {
    const Batch wide_y = simd::abs(y.values_);
    const Batch wide_x = simd::abs(x.values_);
    const Mask steep = wide_y > wide_x;
    const Batch wider = simd::select(steep, wide_y, wide_x);
    // The scale keeps sums from overflowing and keeps subnormal numbers out of the comparison.
    const Batch scale = simd::select(wider > Batch(T(1)), Batch(T(0.5)), Batch(T(0x1p60)));
    const Batch narrow = simd::select(steep, wide_x, wide_y) * scale;
    const Batch wide = wider * scale;
    const Mask diagonal = narrow > wide * Batch(T(0.41421356237309504880L));
    const Batch t = simd::divide(simd::select(diagonal, narrow - wide, narrow),
                                 simd::select(diagonal, narrow + wide, wide));
    const Batch angle = t + t * arc_tangent_rest(t * t);

    // pi / 4 in two parts; the lower one is written out, since long double may have no more digits.
    constexpr T high = static_cast<T>(pi_digits / 4);
    constexpr T low = std::is_same_v<T, float> ? T(-2.18556941e-8L) : T(3.06161699786838302e-17L);
    const auto twice_if_steep = [&](T eighth) {
      return simd::select(diagonal, Batch(eighth),
                          simd::select(steep, Batch(T(2) * eighth), Batch(T(0))));
    };
    const Batch in_quarter =
        twice_if_steep(high) + (simd::select(steep, -angle, angle) + twice_if_steep(low));
    const Batch in_half =
        simd::select(x.values_ > Batch(T(0)), in_quarter, Batch(T(4) * high) - in_quarter);
    return in_half | simd::bitofsign(y.values_);
  }
  friend Pack exp(const Pack& a) {
    // xsimd converts every argument to an integer. Beyond 1000 the result is 0 or infinity.
    const Mask tame = simd::abs(a.values_) < Batch(T(1000));
    const Batch beyond = simd::select(a.values_ < Batch(T(0)), Batch(T(0)),
                                      a.values_ * std::numeric_limits<T>::infinity());
    return simd::select(tame, simd::exp(simd::select(tame, a.values_, Batch(T(0)))), beyond);
  }
  friend Pack log1p(const Pack& a) { return simd::log1p(a.values_); }

 private:
#if defined(__SSE4_1__)
  static constexpr bool rounds = true;  // SSE4.1 has an instruction for floor
#else
  static constexpr bool rounds = false;
#endif

  // atan(t) / t - 1 as a function of t^2, for |t| up to tan(pi / 8). Source: Cephes, S. L. Moshier.
  static Batch arc_tangent_rest(const Batch& z) {
    const auto polynomial = [&z](auto highest, auto... rest) {
      Batch sum(static_cast<T>(highest));
      ((sum = sum * z + Batch(static_cast<T>(rest))), ...);
      return sum;
    };
    if constexpr (std::is_same_v<T, float>) {
      return z *
             polynomial(8.05374449538e-2, -1.38776856032e-1, 1.99777106478e-1, -3.33329491539e-1);
    } else {
      return z *
             polynomial(-8.750608600031904122785e-1, -1.615753718733365076637e1,
                        -7.500855792314704667340e1, -1.228866684490136173410e2,
                        -6.485021904942025371773e1) /
             polynomial(1.0, 2.485846490142306297962e1, 1.650270098316988542046e2,
                        4.328810604912902668951e2, 4.853903996359136964868e2,
                        1.945506571482613964425e2);
    }
  }

  Batch values_;
};

template <class T, class Arch>
struct NumberTraits<Pack<T, Arch>> {
  using Scalar = T;
  using Mask = typename Pack<T, Arch>::Mask;
  static constexpr std::size_t lanes = Pack<T, Arch>::Batch::size;
  using UInt = PackU32<lanes>;

  [[nodiscard]] static std::array<T, lanes> all_lanes(const Pack<T, Arch>& x) {
    std::array<T, lanes> values;
    x.batch().store_unaligned(values.data());
    return values;
  }
  template <class Value>
  [[nodiscard]] static Pack<T, Arch> from_lanes(Value value) {
    alignas(64) std::array<T, lanes> values;
    for (std::size_t i = 0; i < lanes; ++i) values[i] = value(i);
    return Pack<T, Arch>::Batch::load_aligned(values.data());
  }
};

// No vector has these: each lane is the C library's.
template <class Real>
requires(lanes<Real> > 1) [[nodiscard]] Real sin(const Real& x) {
  return from_lanes<Real>([&](std::size_t i) { return std::sin(lane(x, i)); });
}
template <class Real>
requires(lanes<Real> > 1) [[nodiscard]] Real cos(const Real& x) {
  return from_lanes<Real>([&](std::size_t i) { return std::cos(lane(x, i)); });
}
template <class Real>
requires(lanes<Real> > 1) [[nodiscard]] Real pow(const Real& x, const Real& exponent) {
  return from_lanes<Real>([&](std::size_t i) { return std::pow(lane(x, i), lane(exponent, i)); });
}
template <class Real>
requires(lanes<Real> > 1) [[nodiscard]] Real ldexp(const Real& x, int exponent) {
  return from_lanes<Real>([&](std::size_t i) { return std::ldexp(lane(x, i), exponent); });
}

}  // namespace texmap
