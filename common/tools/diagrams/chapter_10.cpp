// The diagrams of chapter 10: projections.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_10() { return {}; }

}  // namespace texmap::diagrams
