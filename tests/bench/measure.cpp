// Everything that is measured, and how a group is timed.
#include <algorithm>

#include "bench.hpp"

namespace texmap::bench {

std::vector<Group> all_groups() {
  return {chapters_group(), threads_group(), meshes_group(),  budgets_group(), ledger_group(),
          uv_group(),       texture_group(), spheres_group(), colors_group(),  encoding_group()};
}

const Row& Group::base_of(const Row& row) const {
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const Row& other) { return other.set == row.set; });
}

void measure(Group& group, const Effort& effort, const Report& report) {
  std::vector<Row*> timed;
  std::vector<Work> works;
  for (Row& row : group.rows) {
    if (!row.prepare) continue;
    timed.push_back(&row);
    works.push_back(row.prepare());
  }
  const int rounds = rounds_within(1000 * group.seconds * effort.part, works, effort.least, 2000);
  const std::vector<WorkTime> times = work_times(works, rounds, report);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    Row& row = *timed[i];
    row.time = times[i].wall / row.items * (group.unit == "ns" ? 1e6 : 1);
    if (row.find_note) row.note = row.find_note();
  }
  for (Row& row : group.rows) {
    const double quotient = row.time / group.base_of(row).time;
    row.ratio = group.ratio == Ratio::speed ? 1 / quotient : quotient;
  }
}

}  // namespace texmap::bench
