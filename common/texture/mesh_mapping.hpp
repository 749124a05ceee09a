// Texture coordinates that are stored in the corners of a mesh.
#pragma once
#include <array>
#include <vector>

#include "number/table.hpp"
#include "scene/mesh.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// A mapping for meshes: the (u, v) of the corners, mixed by their weights at the hit point.
/// At a corner it is exactly the corner's. Coordinates may lie outside 0 to 1: see wrapped.hpp.
/// Bound: 3 unit roundoffs of the largest coordinate, 4 in float, plus the error of the weights.
/// Source: the triangle article; barycentric coordinates: Moebius (1827).
struct MeshMapping {
  std::vector<std::array<Uv<double>, 3>> corners;  ///< of each triangle, in the mesh's order

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const MeshHit<Real>& hit) const {
    if (corners.empty()) return {};
    const auto mixed = [&](double Uv<double>::*coordinate) {
      const auto at = look_up(
          [&](int triangle, int) {
            const auto& uv = corners[static_cast<std::size_t>(triangle)];
            return std::array{uv[0].*coordinate, uv[1].*coordinate, uv[2].*coordinate};
          },
          hit.triangle, Real(0));
      return at[0] * hit.a + at[1] * hit.b + at[2] * hit.c;
    };
    return {mixed(&Uv<double>::u), mixed(&Uv<double>::v)};
  }
};

/// A mesh and the (u, v) of its corners.
struct TexturedMesh {
  Mesh mesh;
  MeshMapping mapping;
};

}  // namespace texmap
