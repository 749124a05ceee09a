// A tree of boxes around the triangles of a mesh: a ray then tries few of them.
#pragma once
#include <array>
#include <bit>
#include <vector>

#include "engine/fast/mesh_boxes.hpp"
#include "scene/mesh.hpp"

namespace texmap {

/// A mesh with boxes around its triangles. Rays meet the same triangles at the same places as
/// without them, to the last bit: boxes only leave out triangles that a ray cannot meet.
struct BoxedMesh : Mesh {
  std::vector<MeshBoxes> boxes;  ///< empty: every ray tries all triangles
  std::vector<MeshLeaf> leaves;  ///< the triangles again, as the boxes hold them
};

/// The mesh with its boxes. They and the mesh take below 100 bytes per triangle.
/// Domain: at most 2^21 triangles. Source: surface area heuristic with bins, Wald (2007).
[[nodiscard]] BoxedMesh with_boxes(Mesh mesh);

/// for_each_crossing by the tree: the nearest boxes first, for a ray that leaves a triangle of its
/// own in any order, as each triangle in its way casts the same shadow.
template <class Real, class Visit>
void cross_boxes(const BoxedMesh& mesh, const Ray<Real>& ray, const Real& limit, const Visit& visit,
                 const Real& own) {
  using Number = typename BoxRay<Real>::Number;
  struct Waiting {
    Number depth;
    InBox inside;
  };
  const RaySpace<Real> space(ray);
  const BoxRay<Real> box_ray(space, ray.direction);
  const bool nearest_first = any(own < Real(0));
  Number end = box_ray.depth_of(limit);
  std::array<Waiting, 7 * most_nested_boxes + 8> waiting;  // the last one is tried first
  waiting[0] = {Number(0), {0, 0}};
  for (std::size_t count = 1; count > 0;) {
    const Waiting& next = waiting[--count];
    if (!any(next.depth < end)) continue;
    const InBox inside = next.inside;
    if (inside.triangles > 0) {
      const MeshLeaf& leaf = mesh.leaves[static_cast<std::size_t>(inside.place)];
      unsigned may = box_ray.may_meet(leaf) & ((1U << inside.triangles) - 1);
      for (; may != 0; may &= may - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(may));
        visit_crossing(mesh, leaf.triangles[i], space, own, visit);
      }
      end = box_ray.depth_of(limit);
      continue;
    }
    const MeshBoxes& boxes = mesh.boxes[static_cast<std::size_t>(inside.place)];
    std::array<Number, 8> depths;
    unsigned entered = box_ray.enter(boxes, end, depths);
    for (const std::size_t kept = count; entered != 0; entered &= entered - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(entered));
      std::size_t to = count++;
      for (; nearest_first && to > kept && any(waiting[to - 1].depth < depths[i]); --to)
        waiting[to] = waiting[to - 1];
      waiting[to] = {depths[i], boxes.inside[i]};
    }
  }
}

/// The same as for the mesh without boxes.
template <class Real, class Visit>
void for_each_crossing(const BoxedMesh& mesh, const Ray<Real>& ray, const Real& limit,
                       const Visit& visit, const Real& own = Real(-1)) {
  if (!mesh.boxes.empty()) return cross_boxes(mesh, ray, limit, visit, own);
  const Mesh& list = mesh;
  for_each_crossing(list, ray, limit, visit, own);
}

}  // namespace texmap
