// Times the rows of a group.
#pragma once
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench.hpp"

namespace texmap::bench {

/// How long and how often.
struct Effort {
  double part = 1;  ///< of the seconds that a group asks for
  int least = 7;    ///< rounds, however long they take
};

/// What one row came to.
struct Timing {
  double time = std::numeric_limits<
      double>::quiet_NaN();  ///< in the group's unit; NaN where this machine cannot run it
  double ratio = std::numeric_limits<
      double>::quiet_NaN();  ///< to the base, as the group has it; NaN if either was not run
  std::string note = {};     ///< the row's, or what it found
  std::size_t base = 0;      ///< the place of the set's first row among the group's rows
};

/// The place of the row that a row is compared with: the first of its set.
[[nodiscard]] std::size_t base_of(const Group& group, std::size_t row);

/// Times all rows of a group alternately.
///
/// @param report  called with the part that is done, 0 to 1; may be empty
/// @return  one timing for each row, in their order
/// Errors: those of the rows' prepare.
[[nodiscard]] std::vector<Timing> measure(const Group& group, const Effort& effort,
                                          const std::function<void(double)>& report = {});

}  // namespace texmap::bench
