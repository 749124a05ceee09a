// The pages of measurements name what is measured, all of it and nothing else; no clock is looked
// at.
#include <doctest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "bench.hpp"
#include "support/running.hpp"

using namespace texmap;
using namespace texmap::bench;

namespace {

const std::string program = "'" TEXMAP_PROGRAM "'";

/// The lines of a page from its first section on, with a sign in place of each time, and without
/// the notes that are measured.
std::vector<std::string> unmeasured(const std::string& page) {
  const std::string sections = page.substr(std::min(page.find("## "), page.size()));
  const std::string without =
      std::regex_replace(sections, std::regex("[0-9]+ in [0-9]+ pixels"), "");
  const std::regex time("[0-9.]+ \\(([0-9.]+×|base)\\)|–");
  std::istringstream in(std::regex_replace(without, time, "#"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("no row is there twice, and each has something to be compared with") {
  for (const Group& group : all_groups()) {
    CAPTURE(group.name);
    std::set<std::string> cells;
    for (const Row& row : group.rows) {
      CHECK(cells.insert(row.line + " | " + row.column).second);
      CHECK(row.items > 0);
      CHECK((!row.prepare || group.base_of(row).prepare));
      CHECK(row.line.find('|') == std::string::npos);
    }
    CHECK(cells.empty() == (group.name == "memory"));  // tests/sizes/curve.py measures it
  }
}

TEST_CASE("docs/measurements.md has what is measured, and nothing else") {
  std::vector<Group> all = all_groups();
  const auto on_page = unmeasured(test::text_in(TEXMAP_TESTS_DIR "/../docs/measurements.md"));
  const auto written = unmeasured(page_of({}, {}, all));
  REQUIRE(on_page.size() == written.size());
  for (std::size_t i = 0; i < on_page.size(); ++i) CHECK(on_page[i] == written[i]);
  all.front().rows.pop_back();  // which must be noticed
  CHECK(unmeasured(page_of({}, {}, all)) != on_page);
}

TEST_CASE("docs/tracing.svg is the plot of the times in the table of tracing") {
  const std::string page = test::text_in(TEXMAP_TESTS_DIR "/../docs/measurements.md");
  Group group = tracing_group();
  std::istringstream table(page.substr(page.find("\n| ms |", page.find("## tracing:")) + 1));
  std::map<std::string, std::map<std::string, std::string>> cells;
  std::vector<std::string> heads;
  for (std::string line; std::getline(table, line) && !line.empty();) {
    std::vector<std::string> parts;
    std::istringstream between(line);
    for (std::string part; std::getline(between, part, '|');)
      parts.push_back(part.empty() ? part : part.substr(1, part.size() - 2));
    if (heads.empty()) heads = parts;
    for (std::size_t i = 0; i < parts.size(); ++i) cells[parts[1]][heads.at(i)] = parts[i];
  }
  for (Row& row : group.rows) row.time = std::stod(cells.at(row.line).at(row.column));
  const std::string plot = test::text_in(TEXMAP_TESTS_DIR "/../docs/tracing.svg");
  CHECK(svg_of(plot_of(group)) == plot);
  group.rows.back().time *= 1.1;  // which must be noticed
  CHECK(svg_of(plot_of(group)) != plot);
}

TEST_CASE("bench_ratios measures, lists, and refuses what it does not know") {
  const test::Outcome measured = test::run(program + " --quick --only uv");
  CHECK(measured.status == 0);
  CHECK(measured.err.empty());
  CHECK(test::has(measured.out, "(base)"));
  CHECK(unmeasured(measured.out) == unmeasured(section_of(uv_group())));
  CHECK(test::run(program + " --list").out.starts_with("chapters | 01 | double\n"));
  for (const char* words :
       {" --fast", " --only nothing", " --write --only uv", " uv", " --only ''"}) {
    CAPTURE(words);
    const test::Outcome refused = test::run(program + words);
    CHECK(refused.status == 2);
    CHECK(test::has(refused.err, "usage: bench_ratios"));
  }
}
