// Four floats at once: what a single ray compares with several boxes or triangles.
#pragma once
#include <algorithm>
#include <functional>

#include "number/number.hpp"

#if defined(__SSE2__) && defined(__GNUC__) && !defined(TEXMAP_NO_VECTOR_TYPES)
#define TEXMAP_SSE2
#include <emmintrin.h>
#endif

namespace texmap {

#ifdef TEXMAP_SSE2
/// Four floats with the operators of one; each is rounded like a single float.
// NOLINTNEXTLINE(modernize-use-using): GCC 12 ignores the attributes of an alias
typedef __m128 FourFloats;

[[nodiscard]] inline FourFloats four_times(float x) { return _mm_set1_ps(x); }
[[nodiscard]] inline FourFloats four_at(const float* first) { return _mm_loadu_ps(first); }
inline void store(FourFloats x, float* first) { _mm_storeu_ps(first, x); }
/// The larger and the smaller of each two; a NaN in `a` gives `b`.
[[nodiscard]] inline FourFloats max(FourFloats a, FourFloats b) { return _mm_max_ps(a, b); }
[[nodiscard]] inline FourFloats min(FourFloats a, FourFloats b) { return _mm_min_ps(a, b); }
[[nodiscard]] inline FourFloats abs(FourFloats a) { return _mm_andnot_ps(_mm_set1_ps(-0.0F), a); }
/// Bit i tells whether number i of `a` is less than that of `b`.
[[nodiscard]] inline unsigned bits_less(FourFloats a, FourFloats b) {
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(a, b)));
}
#else
using FourFloats = std::array<float, 4>;

template <class Function>
[[nodiscard]] FourFloats of_each(const Function& of, const FourFloats& a, const FourFloats& b) {
  return {of(a[0], b[0]), of(a[1], b[1]), of(a[2], b[2]), of(a[3], b[3])};
}
inline FourFloats operator+(FourFloats a, FourFloats b) { return of_each(std::plus<>(), a, b); }
inline FourFloats operator-(FourFloats a, FourFloats b) { return of_each(std::minus<>(), a, b); }
inline FourFloats operator*(FourFloats a, FourFloats b) {
  return of_each(std::multiplies<>(), a, b);
}
[[nodiscard]] inline FourFloats four_times(float x) { return {x, x, x, x}; }
[[nodiscard]] inline FourFloats four_at(const float* x) { return {x[0], x[1], x[2], x[3]}; }
inline void store(FourFloats x, float* first) { std::copy(x.begin(), x.end(), first); }
[[nodiscard]] inline FourFloats max(FourFloats a, FourFloats b) {
  return of_each(max<float>, a, b);
}
[[nodiscard]] inline FourFloats min(FourFloats a, FourFloats b) {
  return of_each(min<float>, a, b);
}
[[nodiscard]] inline FourFloats abs(FourFloats a) {
  return {abs(a[0]), abs(a[1]), abs(a[2]), abs(a[3])};
}
[[nodiscard]] inline unsigned bits_less(FourFloats a, FourFloats b) {
  const auto bit = [&](std::size_t i) { return a[i] < b[i] ? 1U << i : 0U; };
  return bit(0) | bit(1) | bit(2) | bit(3);
}
#endif

}  // namespace texmap
