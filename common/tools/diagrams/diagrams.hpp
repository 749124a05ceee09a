// The computed diagrams of the pages, a function for each chapter's. docs/diagrams/ holds what they
// draw.
#pragma once
#include <vector>

#include "drawing.hpp"

namespace texmap::diagrams {

[[nodiscard]] std::vector<Drawing> diagrams_of_07();
[[nodiscard]] std::vector<Drawing> diagrams_of_10();
[[nodiscard]] std::vector<Drawing> diagrams_of_13();

}  // namespace texmap::diagrams
