// The diagrams of chapter 04: conventions.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_04() { return {}; }

}  // namespace texmap::diagrams
