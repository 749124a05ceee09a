// The difference between two texts, line by line.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texmap::page {

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

/// Texts that differ in more lines than these are shown as one text removed and one added: the
/// table of difference_of would grow with their product.
inline constexpr std::size_t most_differing_lines = 2000;

/// The lines of both texts in order, keeping as many as possible: a longest common subsequence by
/// dynamic programming, between the first and the last line that differ.
[[nodiscard]] inline std::vector<ChangedLine> difference_of(std::string_view before_text,
                                                            std::string_view after_text) {
  const std::vector<std::string> before = lines_of(before_text);
  const std::vector<std::string> after = lines_of(after_text);
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t first = 0;
  while (first < shorter && before[first] == after[first]) ++first;
  std::size_t same_end = 0;
  while (same_end < shorter - first &&
         before[before.size() - 1 - same_end] == after[after.size() - 1 - same_end])
    ++same_end;
  const std::size_t end_before = before.size() - same_end;
  const std::size_t end_after = after.size() - same_end;
  const std::size_t rows = end_before - first;
  const std::size_t columns = end_after - first;

  // common[i][j] is the length of the longest common subsequence of the lines from i and from j on.
  std::vector<std::vector<int>> common(rows + 1, std::vector<int>(1, 0));
  const bool small = std::max(rows, columns) <= most_differing_lines;
  if (small) {
    common.assign(rows + 1, std::vector<int>(columns + 1, 0));
    for (std::size_t i = rows; i-- > 0;) {
      for (std::size_t j = columns; j-- > 0;) {
        common[i][j] = before[first + i] == after[first + j]
                           ? common[i + 1][j + 1] + 1
                           : std::max(common[i + 1][j], common[i][j + 1]);
      }
    }
  }

  std::vector<ChangedLine> changes;
  changes.reserve(before.size() + columns);
  for (std::size_t i = 0; i < first; ++i) changes.push_back({Change::kept, before[i]});
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < rows || j < columns) {
    if (small && i < rows && j < columns && before[first + i] == after[first + j]) {
      changes.push_back({Change::kept, before[first + i]});
      ++i;
      ++j;
    } else if (j == columns || (i < rows && (!small || common[i + 1][j] >= common[i][j + 1]))) {
      changes.push_back({Change::removed, before[first + i]});
      ++i;
    } else {
      changes.push_back({Change::added, after[first + j]});
      ++j;
    }
  }
  for (std::size_t k = end_before; k < before.size(); ++k)
    changes.push_back({Change::kept, before[k]});
  return changes;
}

}  // namespace texmap::page
