// Packs: several numbers that are computed at once and used like one.
#pragma once
#include <array>
#include <type_traits>

#include "number/kinds/batch.hpp"
#include "number/kinds/elementary.hpp"
#include "number/kinds/pack_u32.hpp"

namespace texmap {

/// The truth of a comparison in each lane.
template <class T, class Arch>
class PackMask {
 public:
  using Batch = simd::BatchBool<T>;

  PackMask() = default;
  PackMask(const Batch& truths)
      : truths_(truths) {}  // NOLINT(google-explicit-constructor): a mask is its truths
  [[nodiscard]] const Batch& batch() const { return truths_; }

  friend PackMask operator&&(const PackMask& a, const PackMask& b) {
    return a.truths_ && b.truths_;
  }
  friend PackMask operator||(const PackMask& a, const PackMask& b) {
    return a.truths_ || b.truths_;
  }
  friend PackMask operator!(const PackMask& a) { return !a.truths_; }
  friend bool any(const PackMask& a) { return simd::any<T>(a.truths_); }

 private:
  Batch truths_;
};

/// As many floats or doubles as a vector register holds; each lane is rounded like a single number.
///
/// @tparam Arch  the machine instructions it is made of. Packs of several widths are different
///               types, so the linker cannot confuse their functions.
template <class T, class Arch = simd::default_arch>
class Pack {
 public:
  using Batch = simd::Batch<T>;
  using Mask = PackMask<T, Arch>;

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
  friend Pack operator/(const Pack& a, const Pack& b) {
    return simd::divide<T>(a.values_, b.values_);
  }
  friend Pack operator-(const Pack& a) { return simd::negate<T>(a.values_); }

  friend Mask operator<(const Pack& a, const Pack& b) { return a.values_ < b.values_; }
  friend Mask operator<=(const Pack& a, const Pack& b) { return a.values_ <= b.values_; }
  friend Mask operator>(const Pack& a, const Pack& b) { return a.values_ > b.values_; }
  friend Mask operator>=(const Pack& a, const Pack& b) { return a.values_ >= b.values_; }
  friend Mask operator==(const Pack& a, const Pack& b) { return a.values_ == b.values_; }

  friend Pack select(const Mask& mask, const Pack& yes, const Pack& no) {
    return simd::select<T>(mask.batch(), yes.values_, no.values_);
  }
#ifdef TEXMAP_X86_PACKS
  friend Pack max(const Pack& a, const Pack& b) { return simd::max(a.values_, b.values_); }
  friend Pack min(const Pack& a, const Pack& b) { return simd::min(a.values_, b.values_); }
#endif
  friend Pack abs(const Pack& a) { return simd::abs<T>(a.values_); }
  friend Pack copysign(const Pack& size, const Pack& sign) {
    return simd::with_sign<T>(simd::abs<T>(size.values_), sign.values_);
  }
  friend Pack sqrt(const Pack& a) { return simd::sqrt<T>(a.values_); }
  friend Pack floor(const Pack& a) { return simd::floor<T>(a.values_); }
  friend Pack exp(const Pack& a) { return elementary::exp(a); }
  friend Pack log1p(const Pack& a) { return elementary::log1p(a); }
  friend Pack atan2(const Pack& y, const Pack& x) { return elementary::atan2(y, x); }
  template <class Function>
  friend Pack map_bits(const Pack& a, const Function& of) {
#ifdef TEXMAP_VECTOR_TYPES
    using Bits = typename VectorOf<elementary::BitsOf<T>, Batch::size>::Type;
    return std::bit_cast<Batch>(of(std::bit_cast<Bits>(a.values_)));
#else
    return from_lanes<Pack>([&](std::size_t i) { return elementary::map_bits(a.get(i), of); });
#endif
  }

 private:
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

/// No vector has this: each lane is the C library's, which is exact.
template <class Real>
requires(lanes<Real> > 1) [[nodiscard]] Real ldexp(const Real& x, int exponent) {
  return from_lanes<Real>([&](std::size_t i) { return std::ldexp(lane(x, i), exponent); });
}

}  // namespace texmap
