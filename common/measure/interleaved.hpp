// Which of several ways is faster, on a machine that is never quiet.
#pragma once
#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "stopwatch.hpp"

namespace texmap {

/// Something to be timed: does its work once, from beginning to end.
using Work = std::function<void()>;

/// A clock in milliseconds that starts at 0 now.
[[nodiscard]] inline std::function<double()> from_now_on() {
  return [watch = Stopwatch()] { return watch.milliseconds(); };
}

/// When timing has gone on for long enough: on a busy machine a round may take ten times as long.
class Patience {
 public:
  /// @param milliseconds  after these no further round begins,
  /// @param least_rounds  unless there were fewer than these
  /// @param elapsed       the clock, milliseconds; starts now, unless told otherwise
  explicit Patience(double milliseconds, int least_rounds = 1, std::function<double()> elapsed = from_now_on())
      : milliseconds_(milliseconds), least_rounds_(least_rounds), elapsed_(std::move(elapsed)) {}

  /// True if so many rounds are enough.
  [[nodiscard]] bool operator()(int rounds) const { return rounds >= least_rounds_ && elapsed_() >= milliseconds_; }

 private:
  double milliseconds_;
  int least_rounds_;
  std::function<double()> elapsed_;
};

/// The shortest time that each of several works took, all timed by turns.
///
/// Other programs make a machine slower for seconds at a time. Works that take turns meet the same seconds, so that the ratio
/// of two shortest times holds where two times measured one after the other do not; and what disturbs can only add to a time,
/// so that the shortest is the nearest to the truth.
///
/// @param works   each is run once before the clock is looked at, to fill the caches and to touch its memory
/// @param rounds  how often each is timed, 1 or more
/// @param report  called with (turns done, turns in all) after each turn; may be empty
/// @param enough  asked with the rounds timed so far after each; true skips the rest; may be empty
/// @return  milliseconds, one for each work, in their order
[[nodiscard]] inline std::vector<double> shortest_times(const std::vector<Work>& works, int rounds,
                                                        const std::function<void(int, int)>& report = {},
                                                        const std::function<bool(int)>& enough = {}) {
  std::vector<double> shortest(works.size(), std::numeric_limits<double>::infinity());
  const int turns = static_cast<int>(works.size()) * (rounds + 1);
  int done = 0;
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) {
      const Stopwatch watch;
      works[i]();
      if (round > 0) shortest[i] = std::min(shortest[i], watch.milliseconds());
      if (report) report(++done, turns);
    }
    if (round > 0 && enough && enough(round)) break;
  }
  return shortest;
}

}  // namespace texmap
