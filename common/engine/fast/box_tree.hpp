// A tree of boxes around the triangles of a mesh: a ray then tries few of them.
#pragma once
#include <array>
#include <vector>

#include "scene/mesh.hpp"

namespace texmap {

/// Rounding moves corners, rays and boxes by less than this part of their largest coordinate.
inline constexpr double box_margin = 0x1.8p-20;

/// What a box holds: eight boxes, or a leaf of triangles.
struct InBox {
  int place;      ///< in BoxedMesh::boxes, or in BoxedMesh::leaves
  int triangles;  ///< of the leaf, 1 to 4; 0: eight boxes
};
/// Eight boxes with edges along the axes, each larger than what it holds by `box_margin` of its
/// largest coordinate.
struct alignas(32) MeshBoxes {
  std::array<float, 48> sides;  ///< eight low ones of x, then y, z, then the high ones; NaN: no box
  std::array<InBox, 8> inside;
};
/// Up to four triangles.
struct alignas(32) MeshLeaf {
  std::array<std::array<float, 12>, 3> corners;  ///< of each corner, rounded: four x, y, z
  std::array<int, 4> triangles;                  ///< numbers in Mesh::triangles
};

/// A mesh with boxes around its triangles. Rays meet the same triangles at the same places as
/// without them, to the last bit: boxes only leave out triangles that a ray cannot meet.
struct BoxedMesh : Mesh {
  std::vector<MeshBoxes> boxes;  ///< empty: every ray tries all triangles
  std::vector<MeshLeaf> leaves;  ///< the triangles again, as the boxes hold them
};

/// The mesh with its boxes; of equal triangles they hold two. Usual meshes take below 100 bytes a
/// triangle with them.
/// Domain: at most 2^21 triangles. Source: surface area heuristic with bins, Wald (2007).
[[nodiscard]] BoxedMesh with_boxes(Mesh mesh);

/// The same as for the mesh without boxes; defined in box_search.hpp.
template <class Real, class Visit>
void for_each_crossing(const BoxedMesh& mesh, const Ray<Real>& ray, const Real& limit,
                       const Visit& visit, const Real& own = Real(-1));

}  // namespace texmap
