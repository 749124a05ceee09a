// How a picture is rendered: number, instructions, threads, samples.
#pragma once
#include <functional>

#include "math/color.hpp"

namespace texmap {

/// The numbers to draw with. A new one stands behind `extended`, as its word does in
/// number_names.hpp and chosen.cpp; run_in_number draws with it.
enum class NumberKind {
  float_,       ///< 24 significant bits
  double_,      ///< 53
  extended,     ///< long double: 64 on x86
  float_pack,   ///< several floats at once
  double_pack,  ///< several doubles at once
  interval,     ///< two doubles around the true number: draws the certainty map
};

/// Instruction sets for packs. Wider ones are compiled in files of their own, so that one program
/// runs on every machine.
enum class Instructions {
  baseline,  ///< on every machine of this kind: SSE2 on x86-64, 16 bytes at once
  avx2,      ///< 32 bytes at once
  avx512,    ///< 64 bytes at once
};

/// True if this machine and its operating system support them.
[[nodiscard]] bool machine_has(Instructions instructions);

/// The widest that this machine has.
[[nodiscard]] Instructions widest_instructions();

/// What a picture shows of the surfaces of a scene.
enum class Shown {
  color,   ///< the lesson's picture
  normal,  ///< the unit normal n as (n + 1) / 2: x in red, y in green, z in blue
  uv,      ///< u in red, v in green; gray where a paint has no (u, v)
  object,  ///< each object in one color
};

/// False in programs for learning: they have double alone, so that they compile in a second.
#ifdef TEXMAP_LEARN
constexpr bool all_numbers = false;
#else
constexpr bool all_numbers = true;
#endif
/// False in a page's module: it has float and double alone, and packs where it has vectors, so
/// that it is half as large.
#ifdef TEXMAP_PAGE
constexpr bool wide_numbers = false;
#else
constexpr bool wide_numbers = true;
#endif
#ifdef TEXMAP_HAVE_XSIMD
constexpr bool pack_numbers = true;
#else
constexpr bool pack_numbers = wide_numbers;
#endif

/// How a picture is rendered; only `samples` changes what it shows.
struct RenderSettings {
  int samples = 1;                                    ///< rays per pixel, at least 1
  int threads = 0;                                    ///< 0: all cores
  Instructions instructions = widest_instructions();  ///< the widest to use
  std::function<void(int done, int total)> progress =
      {};  ///< of rows, or of blocks of rows; from any thread
  std::function<void(double error)> error_so_far = {};  ///< the same with a Film's error
  /// Gets the light of each complete row, from any thread; the Film then keeps none of it.
  std::function<void(int row, const Rgb* light)> take_row = {};
  std::function<void(long uncertain, long pixels)> certainty = {};  ///< after a certainty map
};

}  // namespace texmap
