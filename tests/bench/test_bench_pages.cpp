// The pages of measurements name what is measured, all of it and nothing else; no clock is looked
// at.
#include <doctest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "bench.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"
#ifdef TEXMAP_HAVE_JSON
#include <nlohmann/json.hpp>
#endif

using namespace texmap;
using namespace texmap::bench;

namespace {

const std::string program = "'" TEXMAP_PROGRAM "'";

std::string contents(const std::string& path) {
  const std::vector<std::uint8_t> bytes = test::bytes_of(path);
  return {bytes.begin(), bytes.end()};
}

/// The parts of a text between separators.
std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

/// All rows that a page has a cell for, as `bench_ratios --list` has them.
std::set<std::string> rows_on_page(const std::string& page) {
  std::set<std::string> rows;
  std::string group;
  std::vector<std::string> columns;
  for (const std::string& line : parts_of(page, '\n')) {
    if (line.starts_with("## ")) {
      group = line.substr(3, line.find(':') - 3);
      columns.clear();
    }
    if (!line.starts_with("| ") || group.empty()) continue;
    const std::vector<std::string> cells = parts_of(line, '|');  // the first is empty
    if (columns.empty()) columns = cells;
    CHECK(cells.size() == columns.size());
    for (std::size_t i = 2; i < cells.size(); ++i) {
      // Cells of times and the sign for a machine without; heads and notes have neither.
      const std::string& cell = cells[i];
      const bool is_time = cell == " – " || cell.find("×)") != std::string::npos ||
                           cell.find("(base)") != std::string::npos;
      const std::string name = group + " |" + cells[1] + "|" + columns.at(i);
      if (is_time) rows.insert(name.substr(0, name.size() - 1));
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

}  // namespace

TEST_CASE("no row is there twice, and each has something to be compared with") {
  for (const Group& group : all_groups()) {
    CAPTURE(group.name);
    CHECK(rows_of({group}).size() == group.rows.size());
    CHECK_FALSE(group.rows.empty());
    for (const Row& row : group.rows) {
      CHECK(row.items > 0);
      CHECK((!row.prepare || group.base_of(row).prepare));
      CHECK(row.line.find('|') == std::string::npos);
    }
  }
}

TEST_CASE("docs/measurements.md has a cell for each row that is measured, and no other") {
  check_equal(rows_of(all_groups()),
              rows_on_page(contents(TEXMAP_TESTS_DIR "/../docs/measurements.md")));
}

TEST_CASE("a page that is written now has all rows, and a row that is taken away is missed") {
  std::vector<Group> all = all_groups();
  for (Group& group : all) {
    for (Row& row : group.rows) row.time = row.ratio = 1;
  }
  const Circumstances where = circumstances({});
  const std::set<std::string> measured = rows_of(all);
  check_equal(measured, rows_on_page(page_of(where, all)));
  all.front().rows.pop_back();
  CHECK(rows_on_page(page_of(where, all)).size() == measured.size() - 1);
}

TEST_CASE(
    "bench_ratios lists its rows, and refuses what it does not know with status 2 and its usage") {
  const test::Outcome list = test::run(program + " --list");
  CHECK(list.status == 0);
  const std::vector<std::string> lines = parts_of(list.out, '\n');
  check_equal(rows_of(all_groups()), {lines.begin(), lines.end()});
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
  const Group group = samplers_group();
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
