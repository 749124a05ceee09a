// A pair of numbers in [0, 1): a sample.
#pragma once

namespace texmap {

/// A point of the unit square, both coordinates in [0, 1).
template <class Real>
struct Point2 {
  Real u, v;
};

}  // namespace texmap
