// What was measured, as text.
#include "report.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "ways.hpp"

namespace texmap::bench {
namespace {

/// A number in a few digits: 0.123, 1.23, 12.3, 123.
std::string short_number(double value) {
  std::array<char, 40> text{};
  const int decimals = value >= 99.95 ? 0 : value >= 9.995 ? 1 : value >= 0.9995 ? 2 : 3;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string two_decimals(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

/// A paragraph in lines of up to 128 characters, each with its end.
std::string wrapped(const std::string& paragraph) {
  std::istringstream words(paragraph);
  std::string text;
  std::size_t used = 0;
  for (std::string word; words >> word;) {
    // Bytes that go on with a character of UTF-8 take no column.
    const auto columns = static_cast<std::size_t>(
        std::count_if(word.begin(), word.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    const bool fits = used > 0 && used + 1 + columns <= 128;
    if (used > 0) text += fits ? ' ' : '\n';
    used = fits ? used + 1 + columns : columns;
    text += word;
  }
  return text + "\n";
}

std::string ratio_text(Ratio kind, double ratio) { return kind == Ratio::cost ? two_decimals(ratio) : short_number(ratio); }

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const auto colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string compiler_name() {
#if defined(__clang__)
  return "clang++ " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

std::string today() {
  const std::chrono::year_month_day date = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()));
  return text.data();
}

/// The values of a member, each once, in the order in which they come first.
template <class Member>
std::vector<std::string> each_once(const std::vector<Row>& rows, Member member) {
  std::vector<std::string> values;
  for (const Row& row : rows) {
    if (std::find(values.begin(), values.end(), row.*member) == values.end()) values.push_back(row.*member);
  }
  return values;
}

/// The columns of a group's table: plain numbers first, then packs, the wider the later; others as they come.
std::vector<std::string> columns_of(const Group& group) {
  std::vector<std::string> columns = each_once(group.rows, &Row::column);
  const auto rank = [](const std::string& name) {
    const std::array plain = {in_double, in_float, in_extended};
    std::size_t place = 0;
    for (const Way& way : plain) {
      if (name == way.name) return place;
      ++place;
    }
    for (const auto& packs : {in_double_packs, in_float_packs}) {
      for (const Way& way : packs) {
        if (name == way.name) return place;
        ++place;
      }
    }
    return place;
  };
  std::stable_sort(columns.begin(), columns.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return columns;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string what_ratios_say(Ratio kind) {
  return kind == Ratio::speed ? "how many times as fast as the base" : "how many times as long as the base takes";
}

/// A group's table in Markdown.
std::string markdown_of(const Measured& measured) {
  const Group& group = measured.group;
  const std::vector<std::string> columns = columns_of(group);
  std::string text = "| " + group.unit;
  for (const std::string& column : columns) text += " | " + column;
  if (!group.note.empty()) text += " | " + group.note;
  text += " |\n|";
  for (std::size_t i = 0; i < columns.size() + (group.note.empty() ? 1 : 2); ++i) text += "---|";
  text += "\n";
  for (const std::string& line : each_once(group.rows, &Row::line)) {
    text += "| " + line;
    std::string note;
    for (const std::string& column : columns) {
      text += " | ";
      for (std::size_t i = 0; i < group.rows.size(); ++i) {
        if (group.rows[i].line != line || group.rows[i].column != column) continue;
        note = measured.timings[i].note;
        const Timing& timing = measured.timings[i];
        if (std::isnan(timing.time)) {
          text += "–";
        } else if (timing.base == i) {
          text += short_number(timing.time) + " (base)";
        } else {
          text += short_number(timing.time) + " (" + ratio_text(group.ratio, timing.ratio) + "×)";
        }
      }
    }
    if (!group.note.empty()) text += " | " + note;
    text += " |\n";
  }
  return text;
}

/// A text as a JSON string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    std::array<char, 8> escape{};
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(c));
      result += escape.data();
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

Circumstances circumstances(const Effort& effort) {
  Circumstances result{processor_name(), compiler_name(), {}, today(), effort};
  for (const Way& way : in_double_packs) {
    if (is_here(way)) result.instructions.emplace_back(way.name.substr(way.name.find(' ') + 1));
  }
  return result;
}

std::string table_of(const Measured& measured) {
  const Group& group = measured.group;
  std::size_t widest = 0;
  for (const Row& row : group.rows) widest = std::max(widest, row.line.size());
  std::string text = group.name + ": " + group.title + ". " + (group.unit == "ns" ? "Nanoseconds" : "Milliseconds") + ", and " +
                     what_ratios_say(group.ratio) + ".\n";
  for (std::size_t i = 0; i < group.rows.size(); ++i) {
    const Row& row = group.rows[i];
    const Timing& timing = measured.timings[i];
    std::string line = "  " + row.line;
    line.resize(widest + 4, ' ');
    line += row.column;
    line.resize(widest + 28, ' ');
    if (std::isnan(timing.time)) {
      text += line + "not on this machine\n";
      continue;
    }
    std::string time = short_number(timing.time);
    time.insert(0, time.size() < 8 ? 8 - time.size() : 0, ' ');
    std::string ratio = timing.base == i ? "base" : ratio_text(group.ratio, timing.ratio) + "x";
    ratio.insert(0, ratio.size() < 9 ? 9 - ratio.size() : 0, ' ');
    text += line + time + ratio + (timing.note.empty() ? "" : "   " + timing.note) + "\n";
  }
  return text + "\n";
}

std::string json_of(const Circumstances& circumstances, const std::vector<Measured>& all) {
  std::string instructions;
  for (const std::string& name : circumstances.instructions) instructions += (instructions.empty() ? "" : ", ") + quoted(name);
  std::string text = "{\n\"machine\": {\"processor\": " + quoted(circumstances.processor) +
                     ", \"compiler\": " + quoted(circumstances.compiler) + ", \"instructions\": [" + instructions + "]},\n" +
                     "\"date\": " + quoted(circumstances.date) +
                     ",\n\"least_rounds\": " + std::to_string(circumstances.effort.least) + ",\n\"groups\": [";
  for (std::size_t g = 0; g < all.size(); ++g) {
    const Group& group = all[g].group;
    text += std::string(g == 0 ? "" : ",") + "\n{\"name\": " + quoted(group.name) + ", \"unit\": " + quoted(group.unit) +
            ", \"ratio\": " + (group.ratio == Ratio::speed ? "\"times as fast\"" : "\"times as long\"") + ", \"rows\": [";
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
      const Timing& timing = all[g].timings[i];
      text += std::string(i == 0 ? "" : ",") + "\n  {\"name\": " + quoted(group.rows[i].name()) +
              ", \"time\": " + json_number(timing.time) + ", \"ratio\": " + json_number(timing.ratio) +
              ", \"base\": " + quoted(group.rows[timing.base].name()) + ", \"note\": " + quoted(timing.note) + "}";
    }
    text += "\n]}";
  }
  return text + "\n]\n}\n";
}

std::string page_of(const Circumstances& circumstances, const std::vector<Measured>& all) {
  std::string text =
      "# Measurements\n\n" +
      wrapped(
          "How long things take, as ratios. This page is generated: `./course bench --write` measures everything "
          "again, on the machine that it runs on, and writes this page and the ledgers in the pages of the "
          "chapters; a test holds its tables against the list of what is measured (`./course bench --list`). "
          "`./course bench` alone shows the same tables and changes nothing here.") +
      "\n| | |\n|---|---|\n";
  text += "| processor | " + circumstances.processor + " |\n";
  text += "| compiler | " + circumstances.compiler + ", `cmake --preset release` |\n";
  text += "| instructions of packs | " + joined(circumstances.instructions) + " |\n";
  text += "| date | " + circumstances.date + " |\n";
  text += "| rounds | at least " + std::to_string(circumstances.effort.least) + " |\n";
  text +=
      "\n" + wrapped(
                 "Works that are compared are timed by turns, and the shortest time of each counts: what disturbs a machine "
                 "can only add to a time, and works that take turns are disturbed alike "
                 "(`common/measure/interleaved.hpp`). So the ratios, in brackets, hold better than the times, and they too "
                 "change from run to run by some hundredths, on a busy machine by a tenth. All on one thread. \"–\": not on "
                 "this machine.");
  for (const Measured& measured : all) {
    const Group& group = measured.group;
    text += "\n## " + group.name + ": " + group.title + "\n\n" +
            wrapped(group.text + (group.unit == "ns" ? " Nanoseconds for one" : " Milliseconds") + "; in brackets " +
                    what_ratios_say(group.ratio) + ".") +
            "\n" + markdown_of(measured);
  }
  return text;
}

std::string ledger_block(const Measured& ledger, const std::string& chapter) {
  const std::vector<std::string> columns = columns_of(ledger.group);
  std::string text = "\n| what the scene does not require, and how many times as long the picture takes with it |";
  std::string rule = "|---|";
  for (const std::string& column : columns) {
    text += " " + column + " |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const std::string& line : each_once(ledger.group.rows, &Row::line)) {
    if (line.rfind(chapter + ": ", 0) != 0) continue;
    std::string cells;
    bool is_base = false;
    for (const std::string& column : columns) {
      for (std::size_t i = 0; i < ledger.group.rows.size(); ++i) {
        if (ledger.group.rows[i].line != line || ledger.group.rows[i].column != column) continue;
        const Timing& timing = ledger.timings[i];
        is_base = is_base || timing.base == i;
        cells += " " + (std::isnan(timing.ratio) ? "–" : two_decimals(timing.ratio)) + " |";
      }
    }
    if (!is_base) text += "| " + line.substr(chapter.size() + 2) + " |" + cells + "\n";
  }
  return text + "\n";
}

std::string with_ledger_block(const std::string& page, const std::string& block) {
  const auto begin = page.find(ledger_begin);
  const auto end = page.find(ledger_end);
  if (begin == std::string::npos || end == std::string::npos || end < begin ||
      page.find(ledger_begin, begin + 1) != std::string::npos || page.find(ledger_end, end + 1) != std::string::npos) {
    throw std::runtime_error("the page lacks the marks of its ledger: " + std::string(ledger_begin) + " and " +
                             std::string(ledger_end));
  }
  return page.substr(0, begin + ledger_begin.size()) + "\n" + block + page.substr(end);
}

}  // namespace texmap::bench
