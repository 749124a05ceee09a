// The diagrams of the pages, a function for each chapter's. docs/diagrams/ holds what they draw.
#pragma once
#include <vector>

#include "drawing.hpp"

namespace texmap::diagrams {

[[nodiscard]] std::vector<Drawing> diagrams_of_02();
[[nodiscard]] std::vector<Drawing> diagrams_of_04();
[[nodiscard]] std::vector<Drawing> diagrams_of_06();
[[nodiscard]] std::vector<Drawing> diagrams_of_07();
[[nodiscard]] std::vector<Drawing> diagrams_of_10();
[[nodiscard]] std::vector<Drawing> diagrams_of_11();
[[nodiscard]] std::vector<Drawing> diagrams_of_12();
[[nodiscard]] std::vector<Drawing> diagrams_of_13();
[[nodiscard]] std::vector<Drawing> diagrams_of_14();

/// All of them.
[[nodiscard]] std::vector<Drawing> all_diagrams();

}  // namespace texmap::diagrams
