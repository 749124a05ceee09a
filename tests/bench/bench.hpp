// What is measured: groups of works, each with a name, and what it is compared with.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/measure/interleaved.hpp"

namespace texmap::bench {

/// A work that is timed, and its place in its group's table.
struct Row {
  std::string line;    ///< what is done
  std::string column;  ///< with which number, and with which instructions
  std::string set;     ///< the first row of a set is the base of the ratios of all its rows
  double items = 1;    ///< how many of the unit's items one run of the work makes, above 0
  /// Makes the work, and all that it needs; empty where this machine or this build cannot run it.
  /// Errors: std::runtime_error, where what is to be compared does not come out equal.
  std::function<Work()> prepare;
  std::string note =
      {};  ///< what else is to be said about the line; the same in all rows of a line
  std::function<std::string()> find_note =
      {};  ///< finds the note where it is a result, too; asked after the row was timed

  [[nodiscard]] std::string name() const { return line + ", " + column; }
};

/// What the ratio of a row to the base of its set says.
enum class Ratio {
  speed,  ///< how many times as fast: the base's time divided by the row's
  cost,   ///< how many times as long: the row's time divided by the base's
};

/// Rows about one subject: one table.
struct Group {
  std::string name;   ///< one word, for the option --only
  std::string title;  ///< for a heading
  std::string
      text;  ///< what is measured, and with what it is compared: one paragraph, without line ends
  std::string unit;  ///< "ns" for items, "ms" for pictures
  Ratio ratio = Ratio::speed;
  double seconds = 8;     ///< to spend on it
  std::string note = {};  ///< heading of the rows' notes; empty if they have none
  std::vector<Row> rows = {};
};

/// Everything that is measured, in the order of the page. The rows are the same on every machine.
[[nodiscard]] std::vector<Group> all_groups();

// The groups, each declared here and made in a file of its own subject.
[[nodiscard]] Group chapters_group();
[[nodiscard]] Group threads_group();
[[nodiscard]] Group meshes_group();
[[nodiscard]] Group budgets_group();
[[nodiscard]] Group ledger_group();
[[nodiscard]] Group uv_group();
[[nodiscard]] Group texture_group();
[[nodiscard]] Group spheres_group();
[[nodiscard]] Group samplers_group();
[[nodiscard]] Group colors_group();
[[nodiscard]] Group encoding_group();

}  // namespace texmap::bench
