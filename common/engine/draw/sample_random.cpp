// The random numbers of single samples: compiled once, for programs for learning.
#include "engine/draw/sample_random.hpp"

namespace texmap {

template TEXMAP_TWO_WIDTHS TEXMAP_FLATTEN const Point2<double>& RandomBlock<double>::make(int, int);

}  // namespace texmap
