// What was measured, as text: a table for the terminal, JSON, docs/measurements.md.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "engine/measure/json.hpp"
#include "engine/measure/text.hpp"
#include "variants.hpp"

namespace texmap::bench {
namespace {

/// A number in a few digits: 0.123, 1.23, 12.3, 123.
std::string short_number(double value) {
  return text("%.*f", value >= 99.95 ? 0 : value >= 9.995 ? 1 : value >= 0.9995 ? 2 : 3, value);
}

/// A paragraph in lines of up to 128 characters, each with its end.
std::string wrapped(const std::string& paragraph) {
  std::istringstream words(paragraph);
  std::string lines;
  std::size_t used = 0;
  for (std::string word; words >> word;) {
    // Bytes that go on with a character of UTF-8 take no column.
    const auto columns =
        static_cast<std::size_t>(std::count_if(word.begin(), word.end(), [](char c) {
          return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
        }));
    const bool fits = used > 0 && used + 1 + columns <= 128;
    if (used > 0) lines += fits ? ' ' : '\n';
    used = fits ? used + 1 + columns : columns;
    lines += word;
  }
  return lines + "\n";
}

std::string ratio_text(Ratio kind, double ratio) {
  return kind == Ratio::cost ? text("%.2f", ratio) : short_number(ratio);
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

/// The columns of a group's table: plain numbers first, then packs, the wider the later; others as
/// they come.
std::vector<std::string> columns_of(const Group& group) {
  std::vector<std::string> columns = each_once(group.rows, &Row::column);
  const std::vector<Variant> order = variants_of("dfeDF");
  const auto rank = [&order](const std::string& name) {
    return std::find_if(order.begin(), order.end(),
                        [&](const Variant& v) { return v.name == name; });
  };
  std::stable_sort(columns.begin(), columns.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return columns;
}

/// A line of a table in Markdown.
std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

/// A group's table in Markdown.
std::string markdown_of(const Group& group) {
  const std::vector<std::string> columns = columns_of(group);
  std::vector<std::string> cells = {group.unit};
  cells.insert(cells.end(), columns.begin(), columns.end());
  if (!group.note.empty()) cells.push_back(group.note);
  std::string table = line_of(cells) + "|";
  for (std::size_t i = 0; i < cells.size(); ++i) table += "---|";
  table += "\n";
  for (const std::string& line : each_once(group.rows, &Row::line)) {
    cells.assign(columns.size() + 1, "");
    cells[0] = line;
    std::string note;
    for (const Row& row : group.rows) {
      if (row.line != line) continue;
      note = row.note;
      const auto column = std::find(columns.begin(), columns.end(), row.column) - columns.begin();
      const std::string ratio =
          &group.base_of(row) == &row ? "base" : ratio_text(group.ratio, row.ratio) + "×";
      cells[static_cast<std::size_t>(column) + 1] =
          std::isnan(row.time) ? "–" : short_number(row.time) + " (" + ratio + ")";
    }
    if (!group.note.empty()) cells.push_back(note);
    table += line_of(cells);
  }
  return table;
}

}  // namespace

Circumstances circumstances(const Effort& effort) {
  std::vector<std::string> instructions;
  for (const Variant& variant : variants_of("D")) {
    if (variant.is_here()) instructions.emplace_back(name_of(variant.instructions));
  }
  const std::chrono::year_month_day date =
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  return {this_machine("", instructions),
          text("%04d-%02u-%02u", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
               static_cast<unsigned>(date.day())),
          effort};
}

std::string table_of(const Group& group) {
  int widest = 0;
  for (const Row& row : group.rows) widest = std::max(widest, static_cast<int>(row.line.size()));
  std::string table = group.name + ": " + group.title + ". " +
                      (group.unit == "ns" ? "Nanoseconds" : "Milliseconds") + ", and " +
                      (group.ratio == Ratio::speed ? "how many times as fast as the base"
                                                   : "how many times as long as the base takes") +
                      ".\n";
  for (const Row& row : group.rows) {
    table += text("  %-*s%-24s", widest + 2, row.line.c_str(), row.column.c_str());
    if (std::isnan(row.time)) {
      table += "not on this machine\n";
      continue;
    }
    const std::string ratio =
        &group.base_of(row) == &row ? "base" : ratio_text(group.ratio, row.ratio) + "x";
    table += text("%8s%9s", short_number(row.time).c_str(), ratio.c_str()) +
             (row.note.empty() ? "" : "   " + row.note) + "\n";
  }
  return table + "\n";
}

std::string json_of(const Circumstances& circumstances, const std::vector<Group>& all) {
  const auto group_json = [](const Group& group) {
    const auto row_json = [&group](const Row& row) {
      return Json::object({{"name", row.name()},
                           {"time", row.time},
                           {"ratio", row.ratio},
                           {"base", group.base_of(row).name()},
                           {"note", row.note}});
    };
    return Json::object({{"name", group.name},
                         {"unit", group.unit},
                         {"ratio", group.ratio == Ratio::speed ? "times as fast" : "times as long"},
                         {"rows", Json::list_of(group.rows, row_json)}});
  };
  return Json::object({{"machine", circumstances.machine.json()},
                       {"date", circumstances.date},
                       {"least_rounds", circumstances.effort.least},
                       {"groups", Json::list_of(all, group_json)}},
                      true)
             .text +
         "\n";
}

std::string page_of(const Circumstances& circumstances, const std::vector<Group>& all) {
  const Machine& machine = circumstances.machine;
  std::string instructions;
  for (const std::string& each : machine.instructions)
    instructions += (instructions.empty() ? "" : ", ") + each;
  std::string page =
      "# Measurements\n\n" +
      wrapped(
          "How long things take, as ratios. `./course bench --write` measures everything again "
          "and writes this page; a test holds its tables against the list of what is measured "
          "(`./course bench --list`).") +
      "\n| | |\n|---|---|\n" +
      line_of({"processor", text("%s, %d of them; load before: %.1f", machine.processor.c_str(),
                                 machine.processors, machine.load)}) +
      line_of({"compiler", machine.compiler + ", `cmake --preset release`"}) +
      line_of({"instructions of packs", instructions}) + line_of({"date", circumstances.date}) +
      line_of({"rounds", text("at least %d", circumstances.effort.least)}) + "\n" +
      wrapped(
          "Works that are compared are timed alternately, and the shortest time of each counts "
          "(`common/engine/measure/interleaved.cpp`). A cell has a time, in the unit at the "
          "table's corner, and in brackets how many times as fast as the base that is. Ratios "
          "change from run to run by some hundredths, on a busy machine by a tenth. All on one "
          "thread, unless a table says otherwise. \"–\": not on this machine.");
  for (const Group& group : all) {
    page += "\n## " + group.name + ": " + group.title + "\n\n" +
            wrapped(group.text + (group.ratio == Ratio::cost
                                      ? " In brackets: how many times as long as the base takes."
                                      : "")) +
            "\n" + markdown_of(group);
  }
  return page;
}

}  // namespace texmap::bench
