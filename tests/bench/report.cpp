// Everything that is measured, how a group is timed, and what came of it as text:
// docs/measurements.md and its sections.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "bench.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap::bench {
namespace {

/// A number in a few digits: 0.123, 1.23, 12.3, 123.
std::string short_number(double value) {
  return text("%.*f", value >= 99.95 ? 0 : value >= 9.995 ? 1 : value >= 0.9995 ? 2 : 3, value);
}

/// The values of a member, each once, in the order in which they come first.
template <class Member>
std::vector<std::string> each_once(const std::vector<Row>& rows, Member member) {
  std::vector<std::string> values;
  for (const Row& row : rows) {
    if (std::find(values.begin(), values.end(), row.*member) == values.end())
      values.push_back(row.*member);
  }
  return values;
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string cell_of(const Group& group, const Row& row) {
  if (std::isnan(row.time)) return "–";
  const bool is_base = &group.base_of(row) == &row;
  const std::string ratio =
      group.ratio == Ratio::cost ? text("%.2f", row.ratio) : short_number(row.ratio);
  return short_number(row.time) + " (" + (is_base ? "base" : ratio + "×") + ")";
}

}  // namespace

Group described(const std::string& name) {
  const std::vector<std::uint8_t> file = read_file(path_of(TEXMAP_BENCH_GROUPS), 1U << 20);
  std::istringstream lines(std::string(file.begin(), file.end()));
  std::string line;
  while (!line.starts_with(name + " | ") && std::getline(lines, line)) continue;
  std::vector<std::string> cells;
  for (std::size_t begin = 0, end = 0; end < line.size(); begin = end + 3) {
    end = std::min(line.find(" | ", begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
  }
  cells.resize(5);
  Group group{.name = name, .title = cells[1], .unit = cells[2], .note = cells[4]};
  group.seconds = std::stod(cells[3]);
  while (std::getline(lines, line) && !line.empty()) {
    if (line.starts_with("![") || line.starts_with("|"))
      group.plot += (group.plot.empty() ? "" : "\n") + line;
    else
      group.text += (group.text.empty() ? "" : "\n") + line;
  }
  return group;
}

std::vector<Group> all_groups() {
  return {chapters_group(), threads_group(), meshes_group(), tracing_group(),
          budgets_group(),  ledger_group(),  uv_group(),     described("memory")};
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
  if (works.empty()) return;
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

std::string section_of(const Group& group) {
  const std::vector<std::string> columns = each_once(group.rows, &Row::column);
  std::vector<std::string> cells = {group.unit};
  cells.insert(cells.end(), columns.begin(), columns.end());
  if (!group.note.empty()) cells.push_back(group.note);
  std::string section = "## " + group.name + ": " + group.title + "\n\n" + group.text + "\n";
  if (group.ratio == Ratio::cost)
    section += "In brackets: how many times as long as the base takes.\n";
  if (!columns.empty()) {
    section.append("\n").append(line_of(cells)).append("|");
    for (std::size_t i = 0; i < cells.size(); ++i) section += "---|";
    section += "\n";
  }
  for (const std::string& line : each_once(group.rows, &Row::line)) {
    cells.assign(columns.size() + 1, "");
    cells[0] = line;
    std::string note;
    for (const Row& row : group.rows) {
      if (row.line != line) continue;
      note = row.note;
      const auto column = std::find(columns.begin(), columns.end(), row.column) - columns.begin();
      cells[static_cast<std::size_t>(column) + 1] = cell_of(group, row);
    }
    if (!group.note.empty()) cells.push_back(note);
    section += line_of(cells);
  }
  if (!group.plot.empty()) section += "\n" + group.plot + "\n";
  return section + "\n";
}

Plot plot_of(const Group& group) {
  Plot plot{group.title, "triangles", group.unit};
  for (const std::string& column : each_once(group.rows, &Row::column)) {
    PlotSeries series{column, 2 * static_cast<int>(plot.series.size()) + 1, {}, true};
    for (const Row& row : group.rows) {
      if (row.column == column && !std::isnan(row.time))
        series.points.push_back({std::stod(row.line), std::stod(short_number(row.time)), ""});
    }
    if (!series.points.empty()) plot.series.push_back(series);
  }
  return plot;
}

Machine measuring_machine() {
  std::vector<std::string> instructions;
  for (const Instructions each : all_instructions) {
    if (has_packs_of(each)) instructions.emplace_back(name_of(each));
  }
  return this_machine("", instructions);
}

std::string page_of(const Machine& machine, const Effort& effort, const std::vector<Group>& all) {
  std::string instructions;
  for (const std::string& each : machine.instructions)
    instructions += (instructions.empty() ? "" : ", ") + each;
  const std::chrono::year_month_day date =
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  std::string page =
      "# Measurements\n\n"
      "How long things take, as ratios. `./course bench --write` measures everything again and\n"
      "writes this page; a test holds its tables against the list of what is measured\n"
      "(`./course bench --list`).\n\n"
      "| | |\n|---|---|\n" +
      line_of({"processor", text("%s, %d of them; load before: %.1f", machine.processor.c_str(),
                                 machine.processors, machine.load)}) +
      line_of({"compiler", machine.compiler + ", `cmake --preset release`"}) +
      line_of({"instructions of packs", instructions}) +
      line_of(
          {"date", text("%04d-%02u-%02u", static_cast<int>(date.year()),
                        static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()))}) +
      line_of({"rounds", text("at least %d", effort.least)}) +
      "\nWorks that are compared are timed alternately, and the shortest time of each counts\n"
      "(`common/engine/compare/interleaved.cpp`). A cell has a time, in the unit at the table's\n"
      "corner, and in brackets how many times as fast as the base that is. Ratios change from\n"
      "run to run by some hundredths, on a busy machine by a tenth. All on one thread, but\n"
      "for the group `threads`. \"–\": not on this machine.\n\n";
  for (const Group& group : all) page += section_of(group);
  page.pop_back();  // the last empty line
  return page;
}

}  // namespace texmap::bench
