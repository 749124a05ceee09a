// bench_ratios: measures what things take, as ratios, and writes it down. ./course bench runs it.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "bench.hpp"
#include "engine/app/command_line.hpp"
#include "engine/app/run_chapter.hpp"
#include "engine/render/progress.hpp"
#include "engine/system/system.hpp"

using namespace texmap;
using namespace texmap::bench;

namespace {

const std::filesystem::path project = TEXMAP_PROJECT_DIR;

void write(const std::filesystem::path& path, const std::string& text) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) throw std::runtime_error("cannot write " + path.string());
  print("wrote " + path.string() + "\n");
}

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
  std::vector<std::string> beside;
  std::string json = (project / "build/bench/measurements.json").string();
  bool quick = false;
  bool list = false;
  bool writes = false;
  line.flag("--quick", quick, "fewer rounds: less than half a minute in all");
  line.texts("--only", "GROUP", only, "measure this group; may be given several times");
  line.flag("--list", list, "list the groups and their rows without measuring");
  line.flag("--write", writes, "write docs/measurements.md");
  line.text("--json", "FILE", json, "write the figures to this file, as JSON");
  line.texts("--beside", "COMMAND", beside,
             "measure only this shell command and the chapters' programs, in alternation; may be "
             "given several times");
  return run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (writes && !(only.empty() && beside.empty()))
      throw UsageError("--write needs all groups: leave out --only and --beside");
    if (!beside.empty() && !only.empty())
      throw UsageError("--beside measures its own group: leave out --only");
    const Effort effort = quick ? Effort{0.06, 3} : Effort{};
    const Circumstances where = circumstances(effort);
    std::vector<Group> groups;
    if (beside.empty()) groups = chosen(only);
    if (list) {
      for (const Group& group : groups) {
        for (const Row& row : group.rows)
          print(group.name + " | " + row.line + " | " + row.column + "\n");
      }
      return;
    }
    const auto shown = [](const std::string& name, const auto& work) {
      Progress progress(true, [&name] { return ", " + name; });
      work([&](int done, int runs) { progress.report(done, runs); });
    };
    if (!beside.empty()) {
      shown("beside", [&](const Report& report) {
        groups.push_back(measure_beside(beside, effort, report));
      });
      print(table_of(groups.back()));
    }
    for (Group& group : groups) {
      if (!beside.empty()) break;
      shown(group.name, [&](const Report& report) { measure(group, effort, report); });
      print(table_of(group));
    }
    write(json, json_of(where, groups));
    if (writes) write(project / "docs/measurements.md", page_of(where, groups));
  });
}
