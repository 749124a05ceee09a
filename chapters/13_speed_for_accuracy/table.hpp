// The table: all that was tried, as text to read and as JSON for other programs.
#pragma once
#include "engine/measure/machine.hpp"
#include "fronts.hpp"
#include "noise.hpp"

namespace texmap::chapter_13 {

/// Times with a smaller ratio are treated as equal.
inline constexpr double same_time = 1.05;
/// A time with a larger spread was taken on a busy machine.
inline constexpr double quiet_spread = 1.1;

/// All that was measured in one run.
struct Measurements {
  Machine machine;
  int width = 0, height = 0;              ///< of the pictures of places and curves, pixels
  std::vector<Trial> places;              ///< the first is plain double
  std::vector<Trial> curves;              ///< the first is plain double
  std::vector<Trial> texel_formats = {};  ///< the first is plain double's bytes
  Variant exact = {};  ///< the fastest that changes nothing: the samplers draw with it
  std::vector<Noise> noise = {};
  Fronts fronts = {};
  std::vector<Rounds> rounds = {};  ///< of the six timings, in the order above
};

/// The machine as it is now, how this chapter was compiled, and the packs up to `widest`.
[[nodiscard]] Machine measuring_machine(Instructions widest);

/// The right half of a row: what does not depend on the clock.
[[nodiscard]] std::string errors_text(const Trial& trial);
/// The left part of a row: what does not depend on the clock.
[[nodiscard]] std::string errors_text(const FilterCost& filter);
/// The same of a way under a sky, with all its samples.
[[nodiscard]] std::string errors_text(const Fronts& fronts, const std::string& sky,
                                      const std::string& way);
/// A variant's texels and curve as two columns.
[[nodiscard]] std::string columns_of_light(const Variant& variant);
/// What to know of the times if rounds were skipped; empty if none were.
[[nodiscard]] std::string skipped_text(const Measurements& all);
/// The same if times spread by more than on a quiet machine.
[[nodiscard]] std::string busy_text(const Measurements& all);

[[nodiscard]] std::string table_of(const Measurements& all);
/// The same as JSON: an object with a list for each part of the table.
[[nodiscard]] std::string json_of(const Measurements& all);

}  // namespace texmap::chapter_13
