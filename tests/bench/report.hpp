// What was measured, as text: a table for the terminal, JSON, docs/measurements.md and the blocks
// in the chapters' pages.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "bench.hpp"
#include "engine/measure/machine.hpp"
#include "measure.hpp"

namespace texmap::bench {

/// A group and its timings, one for each row.
struct Measured {
  Group group;
  std::vector<Timing> timings;
};

/// On what, and when, and how.
struct Circumstances {
  Machine machine;
  std::string date;  ///< year-month-day, UTC
  Effort effort;
};

/// Those of this program, now.
[[nodiscard]] Circumstances circumstances(const Effort& effort);

/// A table to be read on a terminal.
[[nodiscard]] std::string table_of(const Measured& measured);

/// Everything, as JSON; what was not run is null.
[[nodiscard]] std::string json_of(const Circumstances& circumstances,
                                  const std::vector<Measured>& all);

/// docs/measurements.md.
[[nodiscard]] std::string page_of(const Circumstances& circumstances,
                                  const std::vector<Measured>& all);

}  // namespace texmap::bench
