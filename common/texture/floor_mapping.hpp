// A picture laid on the floor, again and again.
#pragma once
#include "math/vec3.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// Texture coordinates of a point of the floor: one copy of the picture is `size` x `size`.
/// At the origin (1/2, 0); u grows with x, v against z, so that it reads from above, looking to -z.
/// Bound: 3 unit roundoffs, 4 in float, which rounds `size`.
struct FloorMapping {
  double size = 1;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& point) const {
    const Real copies = Real(1) / Real(size);
    return {point.x * copies + Real(0.5), -point.z * copies};
  }
};

}  // namespace texmap
