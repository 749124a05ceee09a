// Function attributes of the compilers that have them.
#pragma once

#if defined(__GNUC__)
/// Keeps a function out of line: long functions that are rarely called, or called in many places.
#define TEXMAP_NOINLINE [[gnu::noinline]]
#else
#define TEXMAP_NOINLINE
#endif

#if defined(__GNUC__) && !defined(TEXMAP_NO_FLATTEN)
/// Inlines everything that a function calls; docs/numerics.md says when it is left out.
#define TEXMAP_FLATTEN __attribute__((flatten))
#else
#define TEXMAP_FLATTEN
#endif

// Tables are computed at compile time. Those of a page are computed when it starts: they would be a
// third of what it loads.
#if defined(__EMSCRIPTEN__)
#define TEXMAP_TABLE_CONSTEXPR
#define TEXMAP_TABLE_CONSTINIT
#else
#define TEXMAP_TABLE_CONSTEXPR constexpr
#define TEXMAP_TABLE_CONSTINIT constinit
#endif
