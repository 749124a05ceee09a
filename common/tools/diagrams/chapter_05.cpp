// The diagrams of chapter 05: rotation.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_05() { return {}; }

}  // namespace texmap::diagrams
