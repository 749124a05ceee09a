// The diagrams of chapter 11: bumps.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_11() { return {}; }

}  // namespace texmap::diagrams
