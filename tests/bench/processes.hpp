// Whole programs, timed by turns: the chapters' own beside any other.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "report.hpp"

namespace texmap::bench {

/// Times commands of the shell by turns with the programs of chapters 01 to 07, each with its own settings but on one thread.
///
/// Each is timed twice at once: by the clock on the wall, and by the processor's time, user and system, of all its processes.
/// @param commands  lines for the shell, 1 or more; the first is the base of both ratios. What they print is thrown away
/// @param report    called with the part that is done, 0 to 1; may be empty
/// Errors: std::runtime_error when a command cannot be run or its exit status is not 0.
[[nodiscard]] Measured measure_beside(const std::vector<std::string>& commands, const Effort& effort,
                                      const std::function<void(double)>& report = {});

}  // namespace texmap::bench
