// How a picture is rendered: number, instructions, threads, samples.
#pragma once
#include <functional>

#include "engine/render/instructions.hpp"

namespace texmap {

/// The numbers that a picture can be drawn with.
enum class NumberKind {
  float_,       ///< 24 significant bits
  double_,      ///< 53
  extended,     ///< long double: 64 on x86
  float_pack,   ///< several floats at once
  double_pack,  ///< several doubles at once
  interval,     ///< two doubles around the true number: draws the certainty map
};

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

/// The fastest number that draws the same picture as double in every chapter (tests/packs).
inline constexpr NumberKind default_number = NumberKind::double_pack;

/// How a picture is rendered; only `samples` changes what it shows.
struct RenderSettings {
  int samples = 1;                                         ///< rays per pixel, at least 1
  int threads = 0;                                         ///< 0: all cores
  Instructions instructions = widest_instructions();       ///< the widest to use
  std::function<void(int done, int total)> progress = {};  ///< after each row, from any thread
  std::function<void(double error)> error_so_far = {};     ///< the same with a Film's error
  std::function<void(long uncertain, long pixels)> certainty = {};  ///< after a certainty map
};

}  // namespace texmap
