// What was measured, as text.
#include "report.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

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

std::string today() {
  const std::chrono::year_month_day date =
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  return text("%04d-%02u-%02u", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
              static_cast<unsigned>(date.day()));
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
  std::vector<std::string_view> order = {in_double.name, in_float.name, in_extended.name};
  for (const auto& packs : {in_double_packs, in_float_packs}) {
    for (const Variant& variant : packs) order.push_back(variant.name);
  }
  const auto rank = [&order](const std::string& name) {
    return std::find(order.begin(), order.end(), name) - order.begin();
  };
  std::stable_sort(columns.begin(), columns.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return columns;
}

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

std::string what_ratios_say(Ratio kind) {
  return kind == Ratio::speed ? "how many times as fast as the base"
                              : "how many times as long as the base takes";
}

/// A group's table in Markdown.
std::string markdown_of(const Measured& measured) {
  const Group& group = measured.group;
  const std::vector<std::string> columns = columns_of(group);
  std::string table = "| " + group.unit;
  for (const std::string& column : columns) table += " | " + column;
  if (!group.note.empty()) table += " | " + group.note;
  table += " |\n|";
  for (std::size_t i = 0; i < columns.size() + (group.note.empty() ? 1 : 2); ++i) table += "---|";
  table += "\n";
  for (const std::string& line : each_once(group.rows, &Row::line)) {
    table += "| " + line;
    std::string note;
    for (const std::string& column : columns) {
      table += " | ";
      for (std::size_t i = 0; i < group.rows.size(); ++i) {
        if (group.rows[i].line != line || group.rows[i].column != column) continue;
        note = measured.timings[i].note;
        const Timing& timing = measured.timings[i];
        if (std::isnan(timing.time)) {
          table += "–";
        } else if (timing.base == i) {
          table += short_number(timing.time) + " (base)";
        } else {
          table += short_number(timing.time) + " (" + ratio_text(group.ratio, timing.ratio) + "×)";
        }
      }
    }
    if (!group.note.empty()) table += " | " + note;
    table += " |\n";
  }
  return table;
}

}  // namespace

Circumstances circumstances(const Effort& effort) {
  std::vector<std::string> instructions;
  for (const Variant& variant : in_double_packs) {
    if (is_here(variant))
      instructions.emplace_back(variant.name.substr(variant.name.find(' ') + 1));
  }
  return {this_machine("", instructions), today(), effort};
}

std::string table_of(const Measured& measured) {
  const Group& group = measured.group;
  int widest = 0;
  for (const Row& row : group.rows) widest = std::max(widest, static_cast<int>(row.line.size()));
  std::string table = group.name + ": " + group.title + ". " +
                      (group.unit == "ns" ? "Nanoseconds" : "Milliseconds") + ", and " +
                      what_ratios_say(group.ratio) + ".\n";
  for (std::size_t i = 0; i < group.rows.size(); ++i) {
    const Row& row = group.rows[i];
    const Timing& timing = measured.timings[i];
    table += text("  %-*s%-24s", widest + 2, row.line.c_str(), row.column.c_str());
    if (std::isnan(timing.time)) {
      table += "not on this machine\n";
      continue;
    }
    const std::string ratio =
        timing.base == i ? "base" : ratio_text(group.ratio, timing.ratio) + "x";
    table += text("%8s%9s", short_number(timing.time).c_str(), ratio.c_str()) +
             (timing.note.empty() ? "" : "   " + timing.note) + "\n";
  }
  return table + "\n";
}

std::string json_of(const Circumstances& circumstances, const std::vector<Measured>& all) {
  const auto group_json = [](const Measured& measured) {
    const Group& group = measured.group;
    std::vector<Json> rows;
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
      const Timing& timing = measured.timings[i];
      rows.push_back(Json::object({{"name", group.rows[i].name()},
                                   {"time", timing.time},
                                   {"ratio", timing.ratio},
                                   {"base", group.rows[timing.base].name()},
                                   {"note", timing.note}}));
    }
    return Json::object({{"name", group.name},
                         {"unit", group.unit},
                         {"ratio", group.ratio == Ratio::speed ? "times as fast" : "times as long"},
                         {"rows", Json::list(rows, true)}});
  };
  return Json::object({{"machine", circumstances.machine.json()},
                       {"date", circumstances.date},
                       {"least_rounds", circumstances.effort.least},
                       {"groups", Json::list_of(all, group_json)}},
                      true)
             .text +
         "\n";
}

std::string page_of(const Circumstances& circumstances, const std::vector<Measured>& all) {
  std::string page =
      "# Measurements\n\n" +
      wrapped(
          "How long things take, as ratios. `./course bench --write` measures everything again "
          "and writes this page; a test holds its tables against the list of what is measured "
          "(`./course bench --list`).") +
      "\n| | |\n|---|---|\n";
  const Machine& machine = circumstances.machine;
  page += text("| processor | %s, %d of them; load before: %.1f |\n", machine.processor.c_str(),
               machine.processors, machine.load);
  page += "| compiler | " + machine.compiler + ", `cmake --preset release` |\n";
  page += "| instructions of packs | " + joined(machine.instructions) + " |\n";
  page += "| date | " + circumstances.date + " |\n";
  page += "| rounds | at least " + std::to_string(circumstances.effort.least) + " |\n";
  page += "\n" +
          wrapped(
              "Works that are compared are timed alternately, and the shortest time of each counts "
              "(`common/engine/measure/interleaved.cpp`). A cell has a time, in the unit at the "
              "table's corner, and in brackets how many times as fast as the base that is. Ratios "
              "change from run to run by some hundredths, on a busy machine by a tenth. All on one "
              "thread, unless a table says otherwise. \"–\": not on this machine.");
  for (const Measured& measured : all) {
    const Group& group = measured.group;
    page += "\n## " + group.name + ": " + group.title + "\n\n" +
            wrapped(group.text + (group.ratio == Ratio::cost
                                      ? " In brackets: how many times as long as the base takes."
                                      : "")) +
            "\n" + markdown_of(measured);
  }
  return page;
}

}  // namespace texmap::bench
