// The diagrams of chapter 07: sampling.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_07() { return {}; }

}  // namespace texmap::diagrams
