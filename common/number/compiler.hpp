// What is asked of compilers about a function, where they know how.
#pragma once

#if defined(__GNUC__)
/// Keeps a function a piece of code of its own: where it is rarely called, or called from many places.
#define TEXMAP_NOINLINE [[gnu::noinline]]
#else
#define TEXMAP_NOINLINE
#endif

#if defined(__GNUC__) && !defined(TEXMAP_NO_FLATTEN)
/// Makes a function one piece of code with all that it calls. Loops over pixels or samples are a twentieth faster for it, or a
/// fifth, since what no one asks for falls away. Compilers that watch each step need minutes and gigabytes for it, and are not
/// asked (TEXMAP_NO_FLATTEN), nor are tests, which have time.
#define TEXMAP_FLATTEN __attribute__((flatten))
#else
#define TEXMAP_FLATTEN
#endif
