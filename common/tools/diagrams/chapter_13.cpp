// The diagrams of chapter 13: the measured trade.
#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> diagrams_of_13() { return {}; }

}  // namespace texmap::diagrams
