// The diagrams of chapter 09: filters.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_09() { return {}; }

}  // namespace texmap::diagrams
