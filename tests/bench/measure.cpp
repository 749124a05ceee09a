// Times the rows of a group.
#include "measure.hpp"

#include <algorithm>

namespace texmap::bench {

std::size_t base_of(const Group& group, std::size_t row) {
  const auto in_its_set = [&](const Row& other) { return other.set == group.rows[row].set; };
  return static_cast<std::size_t>(std::find_if(group.rows.begin(), group.rows.end(), in_its_set) - group.rows.begin());
}

std::vector<Timing> measure(const Group& group, const Effort& effort, const std::function<void(double)>& report) {
  std::vector<std::size_t> timed;
  std::vector<Work> works;
  for (std::size_t i = 0; i < group.rows.size(); ++i) {
    if (!group.rows[i].prepare) continue;
    timed.push_back(i);
    works.push_back(group.rows[i].prepare());
  }

  // One round tells how many fit into the time.
  double turn = 0;
  for (const double milliseconds : shortest_times(works, 1)) turn += milliseconds;
  const double wanted = 1000 * group.seconds * effort.part;
  const int rounds = std::max(effort.least, static_cast<int>(std::min(wanted / std::max(turn, 1e-3), 2000.0)));
  const std::vector<double> shortest = shortest_times(works, rounds, [&](int done, int turns) {
    if (report) report(static_cast<double>(done) / turns);
  });

  std::vector<Timing> timings(group.rows.size());
  for (std::size_t i = 0; i < timed.size(); ++i) {
    const double milliseconds = shortest[i] / group.rows[timed[i]].items;
    timings[timed[i]].time = group.unit == "ns" ? milliseconds * 1e6 : milliseconds;
  }
  for (std::size_t i = 0; i < timings.size(); ++i) {
    const Row& row = group.rows[i];
    Timing& timing = timings[i];
    timing.note = row.find_note && row.prepare ? row.find_note() : row.note;
    timing.base = base_of(group, i);
    const double quotient = timing.time / timings[timing.base].time;
    timing.ratio = group.ratio == Ratio::speed ? 1 / quotient : quotient;
  }
  return timings;
}

}  // namespace texmap::bench
