// Times the rows of a group.
#include "measure.hpp"

#include <algorithm>
#include <string>

namespace texmap::bench {

std::vector<Timing> measure(const Group& group, const Effort& effort, const std::function<void(double)>& report) {
  std::vector<std::string> sets;
  for (const Row& row : group.rows) {
    if (std::find(sets.begin(), sets.end(), row.set) == sets.end()) sets.push_back(row.set);
  }
  std::vector<Timing> timings(group.rows.size());
  for (std::size_t i = 0; i < timings.size(); ++i) timings[i].note = group.rows[i].note;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::vector<std::size_t> members;
    std::vector<std::size_t> timed;
    std::vector<Work> works;
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
      if (group.rows[i].set != sets[set]) continue;
      members.push_back(i);
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
      if (report) report((static_cast<double>(set) + static_cast<double>(done) / turns) / static_cast<double>(sets.size()));
    });

    for (std::size_t i = 0; i < timed.size(); ++i) {
      const double nanoseconds = shortest[i] * 1e6 / group.rows[timed[i]].items;
      if (group.rows[timed[i]].find_note) timings[timed[i]].note = group.rows[timed[i]].find_note();
      timings[timed[i]].time = group.unit == "ns" ? nanoseconds : nanoseconds / 1e6;
    }
    const std::size_t base = members.front();
    for (const std::size_t i : members) {
      const double quotient = timings[i].time / timings[base].time;
      timings[i].ratio = group.ratio == Ratio::speed ? 1 / quotient : quotient;
      timings[i].base = base;
    }
  }
  return timings;
}

}  // namespace texmap::bench
