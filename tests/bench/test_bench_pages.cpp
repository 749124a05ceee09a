// The pages of measurements name what is measured, all of it and nothing else; no clock is looked
// at.
#include <doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "engine/app/command_line.hpp"
#include "report.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"
#ifdef TEXMAP_HAVE_JSON
#include <nlohmann/json.hpp>
#endif

using namespace texmap;
using namespace texmap::bench;

namespace {

const std::filesystem::path project = TEXMAP_TESTS_DIR "/..";
const std::string program = "'" TEXMAP_PROGRAM "'";

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE_MESSAGE(file, path << " is missing; ./course bench --write writes it");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The cells of a line of a Markdown table.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = 1; at < line.size();) {
    const std::size_t bar = line.find('|', at);
    if (bar == std::string::npos) break;
    std::string cell = line.substr(at, bar - at);
    cell.erase(0, cell.find_first_not_of(' ') == std::string::npos ? cell.size()
                                                                   : cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
    cells.push_back(cell);
    at = bar + 1;
  }
  return cells;
}

/// All rows that a page has a cell for, as `bench_ratios --list` has them.
std::set<std::string> rows_on_page(const std::string& page) {
  std::set<std::string> rows;
  std::string group;
  std::vector<std::string> columns;
  for (const std::string& line : lines_of(page)) {
    if (line.rfind("## ", 0) == 0) {
      group = line.substr(3, line.find(':') - 3);
      columns.clear();
    }
    if (line.rfind('|', 0) != 0 || line.rfind("|--", 0) == 0 || group.empty()) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    CHECK(cells.size() == columns.size());
    for (std::size_t i = 1; i < cells.size() && i < columns.size(); ++i) {
      // Cells of times and the sign for a machine without; notes have neither.
      const bool is_time = cells[i] == "–" || cells[i].find("×)") != std::string::npos ||
                           cells[i].find("(base)") != std::string::npos;
      if (is_time) rows.insert(group + " | " + cells[0] + " | " + columns[i]);
    }
  }
  return rows;
}

std::set<std::string> rows_of(const std::vector<Group>& groups) {
  std::set<std::string> rows;
  for (const Group& group : groups) {
    for (const Row& row : group.rows)
      rows.insert(group.name + " | " + row.line + " | " + row.column);
  }
  return rows;
}

void check_equal(const std::set<std::string>& measured, const std::set<std::string>& named) {
  for (const std::string& row : measured)
    CHECK_MESSAGE(named.count(row) == 1, "measured, and not on the page: " << row);
  for (const std::string& row : named)
    CHECK_MESSAGE(measured.count(row) == 1, "on the page, and not measured: " << row);
}

/// Timings as if everything had taken the same time.
std::vector<Measured> unmeasured() {
  std::vector<Measured> all;
  for (const Group& group : all_groups()) {
    all.push_back({group, std::vector<Timing>(group.rows.size())});
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
      all.back().timings[i] = {.time = 1, .ratio = 1, .note = "", .base = base_of(group, i)};
    }
  }
  return all;
}

}  // namespace

TEST_CASE("no row is there twice, and each has something to be compared with") {
  for (const Group& group : all_groups()) {
    CAPTURE(group.name);
    CHECK(rows_of({group}).size() == group.rows.size());
    CHECK_FALSE(group.rows.empty());
    for (const Row& row : group.rows) {
      CHECK(row.items > 0);
      const Row& base =
          group.rows[base_of(group, static_cast<std::size_t>(&row - group.rows.data()))];
      CHECK((!row.prepare || base.prepare));
      CHECK(row.line.find('|') == std::string::npos);
    }
  }
}

TEST_CASE("docs/measurements.md has a cell for each row that is measured, and no other") {
  check_equal(rows_of(all_groups()), rows_on_page(contents(project / "docs/measurements.md")));
}

TEST_CASE("a page that is written now has all rows, and a row that is taken away is missed") {
  std::vector<Measured> all = unmeasured();
  const Circumstances where = circumstances({});
  const std::set<std::string> measured = rows_of(all_groups());
  check_equal(measured, rows_on_page(page_of(where, all)));
  all.front().group.rows.pop_back();
  all.front().timings.pop_back();
  CHECK(rows_on_page(page_of(where, all)).size() == measured.size() - 1);
}

TEST_CASE(
    "bench_ratios lists its rows, and refuses what it does not know with status 2 and its usage") {
  const test::Outcome list = test::run(program + " --list");
  CHECK(list.status == 0);
  std::set<std::string> listed;
  for (const std::string& line : lines_of(list.out)) listed.insert(line);
  check_equal(rows_of(all_groups()), listed);
  for (const char* words : {" --fast", " --only nothing", " --write --only uv",
                            " --only uv --beside true", " uv", " --only ''"}) {
    CAPTURE(words);
    const test::Outcome refused = test::run(program + words);
    CHECK(refused.status == 2);
    CHECK(refused.err.find("usage: bench_ratios") != std::string::npos);
  }
  CHECK(test::run(program + " --help").out.find("--beside COMMAND") != std::string::npos);
}

TEST_CASE("a measured group is shown and written as JSON, with all its rows") {
  const test::TemporaryFolder folder;
  const test::Outcome outcome =
      test::run(program + " --quick --only samplers --json '" + (folder / "figures.json") + "'");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const std::string text = contents(folder / "figures.json");
  for (const Group& group : all_groups()) {
    if (group.name != "samplers") continue;
    for (const Row& row : group.rows) {
      CHECK(text.find("\"name\": \"" + row.name() + "\"") != std::string::npos);
      CHECK(outcome.out.find(row.line) != std::string::npos);
    }
#ifdef TEXMAP_HAVE_JSON
    const nlohmann::json figures = nlohmann::json::parse(text);
    CHECK(figures.at("machine").at("processor").is_string());
    CHECK(figures.at("machine").at("instructions").is_array());
    CHECK(figures.at("date").get<std::string>().size() == 10);
    REQUIRE(figures.at("groups").size() == 1);
    const auto& rows = figures.at("groups")[0].at("rows");
    REQUIRE(rows.size() == group.rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(rows[i].at("name") == group.rows[i].name());
      CHECK(rows[i].at("base") == group.rows[0].name());
      CHECK(rows[i].at("time").is_number() == static_cast<bool>(group.rows[i].prepare));
      CHECK(rows[i].at("ratio").is_number() == static_cast<bool>(group.rows[i].prepare));
    }
#endif
  }
}

TEST_CASE("what must be escaped in JSON is escaped") {
  const Group group{.name = "a\"b\\c\n",
                    .title = "",
                    .text = "",
                    .unit = "ms",
                    .ratio = Ratio::cost,
                    .seconds = 1,
                    .note = "",
                    .rows = {}};
  CHECK(json_of({}, {{group, {}}}).find("\"a\\\"b\\\\c\\u000a\"") != std::string::npos);
}
