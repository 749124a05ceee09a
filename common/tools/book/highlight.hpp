// Code in colors: C++, and differences.
#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texmap::book {

/// Where a block of code is from.
struct Place {
  std::string html{};             ///< to stand above it; empty: from nowhere
  std::set<std::string> known{};  ///< the lines, without blanks around them, that readers know
  /// Rows of the live picture's loupe, and what is on the lines that calculate them.
  std::vector<std::pair<std::string, std::string>> rows{};
};

/// A block of code as HTML. Known lines are dim; those of rows say of which.
///
/// @param language  as behind the fence: cpp, diff; others stay plain
[[nodiscard]] std::string highlighted_block(const std::string& code, const std::string& language,
                                            const Place& place = {});

/// A whole file, its lines numbered; those that links lead to are named, such as L7.
[[nodiscard]] std::string highlighted_file(const std::string& code, bool is_cpp,
                                           const std::set<std::size_t>& named);

/// A line without blanks around it.
[[nodiscard]] std::string trimmed(const std::string& line);

}  // namespace texmap::book
