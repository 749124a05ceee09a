// The difference between two texts, line by line.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace texmap::steps {

/// What became of a line.
enum class Change { kept, removed, added };

struct ChangedLine {
  Change change;
  std::string text;
};

[[nodiscard]] inline std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// The lines of both texts in order, keeping as many as possible: a longest common subsequence by
/// dynamic programming. Its table of (lines + 1)^2 numbers is small for lessons of 80 lines.
[[nodiscard]] inline std::vector<ChangedLine> difference_of(std::string_view before_text,
                                                            std::string_view after_text) {
  const std::vector<std::string> before = lines_of(before_text);
  const std::vector<std::string> after = lines_of(after_text);
  // common[i][j] is the length of the longest common subsequence of the lines from i and from j on.
  std::vector<std::vector<int>> common(before.size() + 1, std::vector<int>(after.size() + 1, 0));
  for (std::size_t i = before.size(); i-- > 0;) {
    for (std::size_t j = after.size(); j-- > 0;) {
      common[i][j] = before[i] == after[j] ? common[i + 1][j + 1] + 1
                                           : std::max(common[i + 1][j], common[i][j + 1]);
    }
  }
  std::vector<ChangedLine> changes;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < before.size() || j < after.size()) {
    if (i < before.size() && j < after.size() && before[i] == after[j]) {
      changes.push_back({Change::kept, before[i]});
      ++i;
      ++j;
    } else if (j == after.size() || (i < before.size() && common[i + 1][j] >= common[i][j + 1])) {
      changes.push_back({Change::removed, before[i++]});
    } else {
      changes.push_back({Change::added, after[j++]});
    }
  }
  return changes;
}

}  // namespace texmap::steps
