// Two numbers in [0, 1): what samplers give and directions are made of.
#pragma once

namespace texmap {

/// A point of the unit square, both coordinates in [0, 1).
template <class Real>
struct Sample2 {
  Real u, v;
};

}  // namespace texmap
