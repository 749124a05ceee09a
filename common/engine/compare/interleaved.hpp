// Which of several works is faster, on a machine that is never quiet.
#pragma once
#include <functional>
#include <limits>
#include <string>
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

/// Times with a smaller ratio are treated as equal.
inline constexpr double same_time = 1.05;
/// A time with a larger spread was taken on a busy machine.
inline constexpr double quiet_spread = 1.1;

/// Says that every ratio would be wrong; nothing if two times of the work that all others are
/// measured by, alone and among others, are within a quarter, or so short that they depend on what
/// the caches hold.
[[nodiscard]] std::string disagreement(const WorkTime& alone, const WorkTime& among);

}  // namespace texmap
