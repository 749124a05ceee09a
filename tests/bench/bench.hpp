// What is measured: groups of works, each with a name, and what it is compared with.
#pragma once
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "engine/compare/interleaved.hpp"
#include "engine/compare/machine.hpp"
#include "engine/compare/plot.hpp"

namespace texmap::bench {

/// A work that is timed, its place in its group's table, and what it came to.
struct Row {
  std::string line;    ///< what is done
  std::string column;  ///< with which number, and with which instructions
  std::string set;     ///< the first row of a set is the base of the ratios of all its rows
  double items = 1;    ///< how many of the unit's items one run of the work makes, above 0
  /// Makes the work, and all that it needs; empty where this machine or this build cannot run it.
  /// Errors: std::runtime_error, where what is to be compared does not come out equal.
  std::function<Work()> prepare = {};
  std::function<std::string()> find_note = {};  ///< what else comes out; the same in a whole line

  double time = std::numeric_limits<double>::quiet_NaN();   ///< in the group's unit; NaN: not run
  double ratio = std::numeric_limits<double>::quiet_NaN();  ///< to the base; NaN as well
  std::string note = {};                                    ///< what find_note found
};

/// What the ratio of a row to the base of its set says.
enum class Ratio {
  speed,  ///< how many times as fast: the base's time divided by the row's
  cost,   ///< how many times as long: the row's time divided by the base's
};

/// Rows about one subject: one table.
struct Group {
  std::string name;       ///< one word, for the option --only
  std::string title;      ///< for a heading
  std::string text = {};  ///< what is measured, and compared with what: a paragraph in lines
  std::string plot = {};  ///< Markdown of its picture below the table, if there is one
  std::string unit;       ///< "ns" for items, "ms" for pictures
  Ratio ratio = Ratio::speed;
  double seconds = 8;     ///< to spend on it
  std::string note = {};  ///< heading of the rows' notes; empty if they have none
  std::vector<Row> rows = {};

  /// What a row is compared with: the first of its set.
  [[nodiscard]] const Row& base_of(const Row& row) const;
};

/// The group of this name in groups.txt, without its rows.
[[nodiscard]] Group described(const std::string& name);

/// Everything that is measured, in the order of the page. The rows are the same on every machine.
[[nodiscard]] std::vector<Group> all_groups();

[[nodiscard]] Group chapters_group();
[[nodiscard]] Group threads_group();
[[nodiscard]] Group meshes_group();
[[nodiscard]] Group tracing_group();
[[nodiscard]] Group budgets_group();
[[nodiscard]] Group ledger_group();
[[nodiscard]] Group uv_group();

struct Effort {
  double part = 1;  ///< of the seconds that a group asks for
  int least = 7;    ///< rounds, however long they take
};

/// Called with (runs done, runs in all); may be empty.
using Report = std::function<void(int, int)>;

/// Times all rows of a group alternately: fills in their times, ratios and notes.
/// Errors: those of the rows' prepare.
void measure(Group& group, const Effort& effort, const Report& report = {});

/// A group as a section of the page, in Markdown; what was not run is "–".
[[nodiscard]] std::string section_of(const Group& group);
/// The times of a group as its table writes them, against the number that begins each line.
[[nodiscard]] Plot plot_of(const Group& group);
[[nodiscard]] Machine measuring_machine();
/// docs/measurements.md.
[[nodiscard]] std::string page_of(const Machine& machine, const Effort& effort,
                                  const std::vector<Group>& all);

}  // namespace texmap::bench
