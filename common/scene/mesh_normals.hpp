// Normals that are stored in the corners of a mesh.
#pragma once
#include "number/compiler.hpp"
#include "scene/mesh.hpp"
#include "scene/shading_normal.hpp"

namespace texmap {

/// The normals of a mesh's corners: `points` are unit vectors, or 0 for none, and `triangles` has
/// those of each triangle of the mesh. Without triangles a mesh is shaded by its own normals.
struct MeshNormals : Mesh {
  /// The unit normal to shade with: the mix of the corners' by their weights at the hit point,
  /// turned to the side that the ray comes from. Where corners have none: the surface's own.
  template <class Real>
  [[nodiscard]] TEXMAP_NOINLINE Vec3<Real> operator()(const MeshHit<Real>& hit) const {
    if (triangles.empty() || !any(hit.met)) return hit.normal;
    const auto [a, b, c] = corners_of(*this, hit.triangle);
    const Vec3<Real> sum = a * hit.a + b * hit.b + c * hit.c;
    const Real size = dot(sum, sum);
    const Mask<Real> usual = size > Real(0) && size < infinity<Real>();
    const Vec3<Real> unit = select(usual, normalize(sum), hit.normal);
    return select(dot(unit, hit.normal) < Real(0), -unit, unit);
  }
};

/// sample_light for a mesh with normals in its corners.
template <class Real, class Objects>
[[nodiscard]] LightSample<Real> sample_light(const PointLight& light, const Objects& objects,
                                             const MeshHit<Real>& hit, const MeshNormals& normals) {
  const LightSample<Real> plain = sample_light(light, objects, hit);
  return normals.triangles.empty() ? plain : shaded(plain, hit, normals(hit));
}

}  // namespace texmap
