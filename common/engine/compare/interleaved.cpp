// Which of several works is faster, on a machine that is never quiet.
//
// Other programs make a machine slower for seconds at a time. Works that are timed alternately are
// slowed by the same seconds, so the ratio of two shortest times is right where two times measured
// one after the other are not. A disturbance can only add to a time: the shortest is the nearest to
// the truth, and how far the others lie above it says how disturbed they were.
#include "engine/compare/interleaved.hpp"

#include <algorithm>

#include "engine/files/stopwatch.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap {

std::vector<WorkTime> work_times(const std::vector<Work>& works, int rounds,
                                 const std::function<void(int, int)>& report,
                                 const std::function<bool(int)>& enough) {
  std::vector<WorkTime> times(works.size());
  std::vector<std::vector<double>> of_rounds(works.size());
  const int runs = static_cast<int>(works.size()) * (rounds + 1);
  int done = 0;
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) {
      const Stopwatch clock;
      const double before = thread_milliseconds();
      works[i]();
      const double processor = thread_milliseconds() - before;
      if (round > 0) {
        of_rounds[i].push_back(processor);
        times[i].wall = std::min(times[i].wall, clock.milliseconds());
      }
      if (report) report(++done, runs);
    }
    if (round > 0 && enough && enough(round)) break;
  }
  for (std::size_t i = 0; i < works.size(); ++i) {
    std::sort(of_rounds[i].begin(), of_rounds[i].end());
    times[i].processor = of_rounds[i].front();
    const double median = of_rounds[i][of_rounds[i].size() / 2];
    if (times[i].processor > 0) times[i].spread = median / times[i].processor;
  }
  return times;
}

int rounds_within(double milliseconds, const std::vector<Work>& works, int least, int most) {
  double round = 1e-3;
  for (const WorkTime& time : work_times(works, 1)) round += time.wall;
  return std::max(least, static_cast<int>(std::min<double>(milliseconds / round, most)));
}

std::string disagreement(const WorkTime& alone, const WorkTime& among) {
  const auto [shorter, longer] = std::minmax(alone.processor, among.processor);
  if (longer < 1 || longer <= 1.25 * shorter) return "";
  return text(
      "plain double took %.1f ms for a picture before packs were timed, and %.1f ms among "
      "them. Every ratio would be wrong, so none is shown. Either this machine changed its "
      "speed meanwhile: run again when nothing else runs. Or packs leave the processor in a "
      "state that slows plain numbers: with --instructions baseline both times are then equal",
      alone.processor, among.processor);
}

}  // namespace texmap
