// Everything that is measured, and how a group is timed.
#include "measure.hpp"

#include <algorithm>

namespace texmap::bench {

std::vector<Group> all_groups() {
  return {chapters_group(), threads_group(), meshes_group(),  budgets_group(),
          ledger_group(),   uv_group(),      texture_group(), spheres_group(),
          samplers_group(), colors_group(),  encoding_group()};
}

std::size_t base_of(const Group& group, std::size_t row) {
  const auto in_its_set = [&](const Row& other) { return other.set == group.rows[row].set; };
  return static_cast<std::size_t>(std::find_if(group.rows.begin(), group.rows.end(), in_its_set) -
                                  group.rows.begin());
}

std::vector<Timing> measure(const Group& group, const Effort& effort,
                            const std::function<void(double)>& report) {
  std::vector<std::size_t> timed;
  std::vector<Work> works;
  for (std::size_t i = 0; i < group.rows.size(); ++i) {
    if (!group.rows[i].prepare) continue;
    timed.push_back(i);
    works.push_back(group.rows[i].prepare());
  }

  const int rounds = rounds_within(1000 * group.seconds * effort.part, works, effort.least, 2000);
  const std::vector<WorkTime> times = work_times(works, rounds, [&](int done, int runs) {
    if (report) report(static_cast<double>(done) / runs);
  });

  std::vector<Timing> timings(group.rows.size());
  for (std::size_t i = 0; i < timed.size(); ++i) {
    const double milliseconds = times[i].wall / group.rows[timed[i]].items;
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
