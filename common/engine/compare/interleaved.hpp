// Which of several works is faster, on a machine that is never quiet.
#pragma once
#include <functional>
#include <limits>
#include <vector>

namespace texmap {

/// Something to be timed: does its work once, from beginning to end.
using Work = std::function<void()>;

/// How long a work took, over all rounds; milliseconds.
struct WorkTime {
  double processor = std::numeric_limits<double>::infinity();  ///< this thread's: the shortest
  double wall = std::numeric_limits<double>::infinity();       ///< by the clock: the shortest
  double spread = 1;  ///< median / shortest of the processor's times: near 1 on a quiet machine
};

/// What several works took, all timed alternately.
///
/// @param rounds  how often each is timed, after one run that fills the caches; 1 or more
/// @param report  called with (runs done, runs in all) after each run; may be empty
/// @param enough  asked with the rounds timed so far after each; true skips the rest; may be empty
/// @return  one for each work, in their order
[[nodiscard]] std::vector<WorkTime> work_times(const std::vector<Work>& works, int rounds,
                                               const std::function<void(int, int)>& report = {},
                                               const std::function<bool(int)>& enough = {});

/// How many rounds of these works fit into a time, found by timing one; `least` or more, `most` or
/// fewer.
[[nodiscard]] int rounds_within(double milliseconds, const std::vector<Work>& works, int least,
                                int most);

}  // namespace texmap
