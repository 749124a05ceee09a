// Times whole programs alternately: the chapters' and commands of the user's.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "report.hpp"

namespace texmap::bench {

/// Times commands of the shell alternately with the programs of chapters 01 to 07, on one thread:
/// wall clock and, in the same run, processor time of all their processes.
///
/// @param commands  1 or more, the first the base of both ratios; what they print is thrown away
/// @param report    called with the part that is done, 0 to 1; may be empty
/// Errors: std::runtime_error when a command cannot be run or its exit status is not 0.
[[nodiscard]] Measured measure_beside(const std::vector<std::string>& commands,
                                      const Effort& effort,
                                      const std::function<void(double)>& report = {});

}  // namespace texmap::bench
