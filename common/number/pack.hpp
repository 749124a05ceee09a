// Packs: several numbers that are worked on at once, and behave like one. Built on xsimd; docs/packages.md says why.
#pragma once
#if __has_include(<xsimd/xsimd.hpp>)  // without it there are no packs, and everything else works
#define TEXMAP_HAVE_PACKS
#include <array>
#include <limits>
#include <type_traits>
#include <xsimd/xsimd.hpp>

#include "number.hpp"

namespace texmap {

/// As many floats or doubles as the machine's registers hold: 4 and 2 with SSE2, 8 and 4 with AVX2, 16 and 8 with AVX-512.
///
/// Arithmetic works lane by lane and rounds as single numbers do, so a picture drawn with packs of double equals one drawn with
/// double wherever the functions below round alike. Comparisons give a mask with one truth per lane.
/// Bounds, measured in tests/number/test_pack.cpp: atan2 4 ulp, exp and log1p 2 ulp of the C library's; exp gives 0 where the
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
  friend Pack atan2(const Pack& y, const Pack& x) { return xsimd::atan2(y.values_, x.values_); }
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
