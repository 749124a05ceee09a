// The loops over pixels and samples that compilers inline whole.
#pragma once
#include <type_traits>

#include "number/compiler.hpp"
#include "number/number.hpp"

namespace texmap {

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(TEXMAP_INSTRUMENTED) && __has_include(<gnu/libc-version.h>)
/// A function compiled twice, once for AVX2: glibc's loader takes what the machine has.
#define TEXMAP_TWO_WIDTHS __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define TEXMAP_TWO_WIDTHS
#endif

#ifdef TEXMAP_WIDE_PACKS
inline constexpr bool has_wider_packs = true;
#else
inline constexpr bool has_wider_packs = false;
#endif

/// True for the numbers that pictures are drawn with for their speed: float, double, the widest
/// packs. Other loops would take most of the time that a chapter compiles.
template <class Real>
inline constexpr bool is_drawn_fast =
    lanes<Real> == 1 ? std::is_same_v<Real, float> || std::is_same_v<Real, double>
                     : !has_wider_packs || lanes<Real> * sizeof(Scalar<Real>) > 32;

/// Calls `work`, with all that it calls inlined for the numbers that are drawn fast.
template <class Real, class Work>
void inline_whole(const Work& work) {
  if constexpr (is_drawn_fast<Real>) {
    [&]() TEXMAP_FLATTEN { work(); }();
  } else {
    work();
  }
}

}  // namespace texmap
