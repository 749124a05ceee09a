// The diagrams of chapter 06: highlight.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_06() { return {}; }

}  // namespace texmap::diagrams
