// Which of several works is faster, on a machine that is never quiet.
//
// Other programs make a machine slower for seconds at a time. Works that are timed alternately are
// slowed by the same seconds, so the ratio of two shortest times is right where two times measured
// one after the other are not. A disturbance can only add to a time: the shortest is the nearest to
// the truth.
#include "engine/measure/interleaved.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace texmap {

TimeLimit::TimeLimit(double milliseconds, int least_rounds, std::function<double()> elapsed)
    : milliseconds_(milliseconds), least_rounds_(least_rounds), elapsed_(std::move(elapsed)) {
  if (!elapsed_) elapsed_ = [watch = Stopwatch()] { return watch.milliseconds(); };
}

std::vector<double> shortest_times(const std::vector<Work>& works, int rounds,
                                   const std::function<void(int, int)>& report,
                                   const std::function<bool(int)>& enough) {
  std::vector<double> shortest(works.size(), std::numeric_limits<double>::infinity());
  const int runs = static_cast<int>(works.size()) * (rounds + 1);
  int done = 0;
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) {
      const Stopwatch watch;
      works[i]();
      if (round > 0) shortest[i] = std::min(shortest[i], watch.milliseconds());
      if (report) report(++done, runs);
    }
    if (round > 0 && enough && enough(round)) break;
  }
  return shortest;
}

int rounds_within(double milliseconds, const std::vector<Work>& works, int least, int most) {
  const std::vector<double> times = shortest_times(works, 1);
  const double round = std::accumulate(times.begin(), times.end(), 1e-3);
  return std::max(least, static_cast<int>(std::min<double>(milliseconds / round, most)));
}

}  // namespace texmap
