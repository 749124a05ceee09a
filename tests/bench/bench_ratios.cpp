// bench_ratios: measures what things take, as ratios, and writes it down. ./course bench runs it.
#include <algorithm>

#include "bench.hpp"
#include "engine/draw/progress.hpp"
#include "engine/files/system.hpp"
#include "engine/run/command_line.hpp"

using namespace texmap;
using namespace texmap::bench;

namespace {

/// The groups that were named; all if no name was given.
std::vector<Group> chosen(const std::vector<std::string>& names) {
  std::vector<Group> groups = all_groups();
  if (names.empty()) return groups;
  std::string known;
  for (const Group& group : groups) known += (known.empty() ? "" : "|") + group.name;
  std::vector<Group> some;
  for (const std::string& name : names) {
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&](const Group& group) { return group.name == name; });
    if (found == groups.end())
      throw UsageError("--only takes " + known + ", and was given '" + name + "'");
    some.push_back(*found);
  }
  return some;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("bench_ratios", "measures how long the parts of the course take, as ratios");
  line.statuses(
      "0 measured; 1 it could not be, or pictures that must be equal are not; 2 the command line "
      "is wrong");
  std::vector<std::string> only;
  bool quick = false, list = false, writes = false;
  line.flag("--quick", quick, "fewer rounds: less than half a minute in all");
  line.texts("--only", "GROUP", only, "measure this group; may be given several times");
  line.flag("--list", list, "list the groups and their rows without measuring");
  line.flag("--write", writes, "write docs/measurements.md");
  return run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (writes && !only.empty()) throw UsageError("--write needs all groups: leave out --only");
    const Effort effort = quick ? Effort{0.06, 3} : Effort{};
    const Machine machine = measuring_machine();
    std::vector<Group> groups = chosen(only);
    for (Group& group : groups) {
      if (list) {
        for (const Row& row : group.rows)
          print(group.name + " | " + row.line + " | " + row.column + "\n");
        continue;
      }
      Progress progress(true, [&group] { return ", " + group.name; });
      measure(group, effort, [&](int done, int runs) { progress.report(done, runs); });
      print(section_of(group));
      if (writes && group.name == "tracing")
        write_text_atomically(TEXMAP_PROJECT_DIR "/docs/tracing.svg", svg_of(plot_of(group)));
    }
    if (!writes || list) return;
    const std::filesystem::path page = TEXMAP_PROJECT_DIR "/docs/measurements.md";
    write_text_atomically(page, page_of(machine, effort, groups));
    print("wrote " + page.string() + "\n");
  });
}
