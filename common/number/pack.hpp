// Packs: several numbers that are worked on at once, and behave like one. Built on xsimd; docs/packages.md says why.
#pragma once
#if __has_include(<xsimd/xsimd.hpp>)  // without it there are no packs, and everything else works
#define TEXMAP_HAVE_PACKS
#include <array>
#include <limits>
#include <numbers>
#include <type_traits>
#include <xsimd/xsimd.hpp>

#include "number.hpp"

namespace texmap {

/// As many floats or doubles as the machine's registers hold: 4 and 2 with SSE2, 8 and 4 with AVX2, 16 and 8 with AVX-512.
///
/// Arithmetic works lane by lane and rounds as single numbers do, so a picture drawn with packs of double equals one drawn with
/// double wherever the functions below round alike. Comparisons give a mask with one truth per lane.
/// Bounds, measured in tests/number/test_pack.cpp: atan2 2 ulp, exp and log1p 2 ulp of the C library's; exp gives 0 where the
/// result is near or below the smallest normal number. atan2(0, 0) is NaN.
///
/// @tparam Arch  the instructions it is made of. They are part of the type's name: a program holds packs of several widths,
/// each
///               in files compiled for it, and functions for one must never be taken for functions for another
template <class T, class Arch = xsimd::default_arch>
class Pack {
 public:
  using Batch = xsimd::batch<T, Arch>;
  using Mask = xsimd::batch_bool<T, Arch>;

  Pack() = default;
  Pack(const Batch& values) : values_(values) {}  // NOLINT(google-explicit-constructor): a pack is its values
  /// The same number in every lane.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit Pack(Number number) : values_(static_cast<T>(number)) {}

  [[nodiscard]] T get(std::size_t i) const { return values_.get(i); }
  [[nodiscard]] const Batch& batch() const { return values_; }

  friend Pack operator+(const Pack& a, const Pack& b) { return a.values_ + b.values_; }
  friend Pack operator-(const Pack& a, const Pack& b) { return a.values_ - b.values_; }
  friend Pack operator*(const Pack& a, const Pack& b) { return a.values_ * b.values_; }
  friend Pack operator/(const Pack& a, const Pack& b) { return a.values_ / b.values_; }
  friend Pack operator-(const Pack& a) { return -a.values_; }

  friend Mask operator<(const Pack& a, const Pack& b) { return a.values_ < b.values_; }
  friend Mask operator<=(const Pack& a, const Pack& b) { return a.values_ <= b.values_; }
  friend Mask operator>(const Pack& a, const Pack& b) { return a.values_ > b.values_; }
  friend Mask operator>=(const Pack& a, const Pack& b) { return a.values_ >= b.values_; }
  friend Mask operator==(const Pack& a, const Pack& b) { return a.values_ == b.values_; }

  friend Pack select(const Mask& mask, const Pack& yes, const Pack& no) { return xsimd::select(mask, yes.values_, no.values_); }
#if defined(__x86_64__)  // whose instructions give `b` for a NaN in `a`, as number.hpp promises; others give the NaN
  friend Pack larger(const Pack& a, const Pack& b) { return xsimd::max(a.values_, b.values_); }
  friend Pack smaller(const Pack& a, const Pack& b) { return xsimd::min(a.values_, b.values_); }
#endif
  friend Pack abs(const Pack& a) { return xsimd::abs(a.values_); }
  friend Pack sqrt(const Pack& a) { return xsimd::sqrt(a.values_); }
  friend Pack floor(const Pack& a) {
    if constexpr (rounds) return xsimd::floor(a.values_);
    // xsimd goes through an integer where the machine has no instruction. Numbers this large are whole; NaN stays NaN.
    const Mask small = xsimd::abs(a.values_) < Batch(T(1) / std::numeric_limits<T>::epsilon());
    return xsimd::select(small, xsimd::floor(xsimd::select(small, a.values_, Batch(T(0)))), a.values_);
  }
  // As xsimd's, which is Cephes' atan.c and atanf.c, with half of its divisions: they are most of the time. Whatever the
  // octant, the quotient comes from one division of what it is to be, down to tan(pi / 8) by atan(t) = pi / 4 + atan((t - 1) /
  // (t + 1)).
  friend Pack atan2(const Pack& y, const Pack& x) {
    const Batch wide_y = xsimd::abs(y.values_);
    const Batch wide_x = xsimd::abs(x.values_);
    const Mask steep = wide_y > wide_x;
    const Batch wider = xsimd::select(steep, wide_y, wide_x);
    // So that no sum overflows, and none of the smallest numbers, which have few digits, is compared with a rounded one.
    const Batch scale = xsimd::select(wider > Batch(T(1)), Batch(T(0.5)), Batch(T(0x1p60)));
    const Batch narrow = xsimd::select(steep, wide_x, wide_y) * scale;
    const Batch wide = wider * scale;
    const Mask diagonal = narrow > wide * Batch(T(0.41421356237309504880L));
    const Batch t = xsimd::select(diagonal, narrow - wide, narrow) / xsimd::select(diagonal, narrow + wide, wide);
    const Batch angle = t + t * arc_tangent_rest(t * t);

    constexpr long double quarter = std::numbers::pi_v<long double> / 4;
    constexpr T high = static_cast<T>(quarter);
    constexpr T low = static_cast<T>(quarter - static_cast<long double>(high));
    const auto twice_if_steep = [&](T eighth) {
      return xsimd::select(diagonal, Batch(eighth), xsimd::select(steep, Batch(T(2) * eighth), Batch(T(0))));
    };
    const Batch in_quarter = twice_if_steep(high) + (xsimd::select(steep, -angle, angle) + twice_if_steep(low));
    const Batch in_half = xsimd::select(x.values_ > Batch(T(0)), in_quarter, Batch(T(4) * high) - in_quarter);
    return in_half | xsimd::bitofsign(y.values_);
  }
  friend Pack exp(const Pack& a) {
    // xsimd makes an integer of every argument. Beyond 1000 the result is 0 or infinity in any case; NaN stays NaN.
    const Mask tame = xsimd::abs(a.values_) < Batch(T(1000));
    const Batch beyond = xsimd::select(a.values_ < Batch(T(0)), Batch(T(0)), a.values_ * std::numeric_limits<T>::infinity());
    return xsimd::select(tame, xsimd::exp(xsimd::select(tame, a.values_, Batch(T(0)))), beyond);
  }
  friend Pack log1p(const Pack& a) { return xsimd::log1p(a.values_); }

 private:
#if defined(__SSE4_1__)
  static constexpr bool rounds = true;  // the instructions that the file is compiled for have one for floor
#else
  static constexpr bool rounds = false;
#endif

  // atan(t) / t - 1 for |t| up to tan(pi / 8), of the square of t. Source: Cephes, by S. L. Moshier.
  static Batch arc_tangent_rest(const Batch& z) {
    const auto polynomial = [&z](auto highest, auto... rest) {
      Batch sum(static_cast<T>(highest));
      ((sum = sum * z + Batch(static_cast<T>(rest))), ...);
      return sum;
    };
    if constexpr (std::is_same_v<T, float>) {
      return z * polynomial(8.05374449538e-2, -1.38776856032e-1, 1.99777106478e-1, -3.33329491539e-1);
    } else {
      return z *
             polynomial(-8.750608600031904122785e-1, -1.615753718733365076637e1, -7.500855792314704667340e1,
                        -1.228866684490136173410e2, -6.485021904942025371773e1) /
             polynomial(1.0, 2.485846490142306297962e1, 1.650270098316988542046e2, 4.328810604912902668951e2,
                        4.853903996359136964868e2, 1.945506571482613964425e2);
    }
  }

  Batch values_;
};

using xsimd::any;

template <class T, class Arch>
struct NumberTraits<Pack<T, Arch>> {
  using Scalar = T;
  using Mask = typename Pack<T, Arch>::Mask;
  static constexpr std::size_t lanes = Pack<T, Arch>::Batch::size;

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

}  // namespace texmap
#endif
