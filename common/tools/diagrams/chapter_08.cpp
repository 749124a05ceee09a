// The diagrams of chapter 08: triangles.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_08() { return {}; }

}  // namespace texmap::diagrams
