// A surface of triangles and the point where a ray first meets it.
#pragma once
#include <array>
#include <concepts>
#include <vector>

#include "number/table.hpp"
#include "scene/edge_function.hpp"
#include "scene/hit.hpp"

namespace texmap {

/// Triangles that share corners. Seen from outside, corners run counterclockwise.
struct Mesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;  ///< each with the indices of its corners

  /// A corner of a triangle, both counted from 0.
  [[nodiscard]] const Point& corner(int triangle, int number) const {
    const int index =
        triangles[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(number)];
    return points[static_cast<std::size_t>(index)];
  }
};

/// Where a ray meets a mesh first. Its normal faces the ray, also on the inner side.
template <class Real>
struct MeshHit : Hit<Real> {
  Mask<Real> met = mask_of<Real>(false);  ///< false: the ray meets no triangle
  Real distance = Real(1);                ///< in lengths of the ray's direction
  Real triangle = Real(0);                ///< its number in Mesh::triangles
  Real a = Real(1), b{}, c{};             ///< the weights of its corners, 0 to 1
};

/// Calls visit(number, crossing) if a ray crosses this triangle; not if it is `own` in all lanes.
///
/// @param seen  called with a point's number, gives it as seen_along does
template <class Real, class Seen, class Visit>
void visit_crossing(const Mesh& mesh, int number, const RaySpace<Real>& space, const Real& own,
                    const Seen& seen, const Visit& visit) {
  if (!any(!(own == Real(number)))) return;
  const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(number)];
  const Crossing<Real> found = crossing(space, seen(a), seen(b), seen(c));
  if (any(found.met)) visit(number, found);
}

/// Calls visit(number, crossing) for the triangles of a mesh that a ray crosses, but for its own.
/// `visit` may lower the limit: kinds of meshes with a faster search leave out what lies beyond.
template <class Real, class Visit>
void for_each_crossing(const Mesh& mesh, const Ray<Real>& ray, const Real& /*limit*/,
                       const Visit& visit, const Real& own = Real(-1)) {
  const RaySpace<Real> space(ray);
  const auto seen = [&](int point) {
    return seen_along(space, number_cast<Real>(mesh.points[static_cast<std::size_t>(point)]));
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    visit_crossing(mesh, static_cast<int>(i), space, own, seen, visit);
}

/// The three corners of the triangle with a number.
template <class Real>
[[nodiscard]] std::array<Vec3<Real>, 3> corners_of(const Mesh& mesh, const Real& triangle) {
  const auto corner = [&](int number) {
    const auto p = look_up(
        [&mesh](int in_triangle, int at) {
          const Point& point = mesh.corner(in_triangle, at);
          return std::array{point.x, point.y, point.z};
        },
        triangle, Real(number));
    return Vec3<Real>{p[0], p[1], p[2]};
  };
  return {corner(0), corner(1), corner(2)};
}

/// The first triangle that a ray meets ahead of its origin; of several at one distance, that with
/// the smallest number. The ray does not meet it again from `outside`.
/// Domain: coordinates 0 or of 1e-6 to 1e6, directions of 0.1 to 1e6; at most 2^24 triangles.
template <std::derived_from<Mesh> AnyMesh, class Real>
[[nodiscard]] MeshHit<Real> first_hit(const AnyMesh& mesh, const Ray<Real>& ray) {
  MeshHit<Real> hit;
  Real nearest = infinity<Real>();
  for_each_crossing(mesh, ray, nearest, [&](int number, const Crossing<Real>& found) {
    const Real index = Real(number);
    const Mask<Real> ahead = found.met && found.distance > Real(0);
    const Mask<Real> first =
        ahead && (found.distance < nearest || (found.distance == nearest && index < hit.triangle));
    nearest = select(first, found.distance, nearest);
    hit.triangle = select(first, index, hit.triangle);
    hit.a = select(first, found.a, hit.a);
    hit.b = select(first, found.b, hit.b);
    hit.c = select(first, found.c, hit.c);
  });
  hit.met = nearest < infinity<Real>();
  if (!any(hit.met)) return hit;

  hit.distance = select(hit.met, nearest, Real(1));
  const auto [a, b, c] = corners_of(mesh, hit.triangle);
  const Vec3<Real> across = cross(b - a, c - a);
  // Rounding may lose the whole area of a needle; its normal then points back along the ray.
  const Vec3<Real> side = select(largest(across) > Real(0), across, -ray.direction);
  const Vec3<Real> normal = normalize(side * (Real(1) / largest(side)));
  hit.normal = select(dot(normal, ray.direction) > Real(0), -normal, normal);
  hit.point = a * hit.a + b * hit.b + c * hit.c;
  const Real size = max(largest(a), max(largest(b), largest(c))) + largest(ray.origin);
  hit.outside = hit.point + hit.normal * (Real(32) * unit_roundoff<Real>() * size);
  return hit;
}

/// The triangles of a mesh that can shadow a hit point: all but its own, in each lane.
template <class AnyMesh, class Real>
struct OtherTriangles {
  const AnyMesh& mesh;
  Real own;
  Mask<Real> lit;  ///< false: the ray met nothing, so there is no shadow to look for
};
template <class AnyMesh, class Real>
[[nodiscard]] OtherTriangles<AnyMesh, Real> others(const AnyMesh& mesh, const MeshHit<Real>& hit) {
  return {mesh, hit.triangle, hit.met};
}

/// True where one of these triangles lies between the ray's origin and `distance` along it.
template <class AnyMesh, class Real>
[[nodiscard]] Mask<Real> is_occluded(const OtherTriangles<AnyMesh, Real>& others,
                                     const Ray<Real>& ray, const Real& distance,
                                     int /*leaving*/ = -1) {
  Mask<Real> hidden = mask_of<Real>(false);
  Real limit = select(others.lit, distance, -infinity<Real>());
  const auto visit = [&](int number, const Crossing<Real>& found) {
    hidden = hidden || (found.met && !(others.own == Real(number)) && found.distance > Real(0) &&
                        found.distance < limit);
    limit = select(hidden, -infinity<Real>(), limit);  // the first triangle in the way decides
  };
  for_each_crossing(others.mesh, ray, limit, visit, others.own);
  return hidden;
}

}  // namespace texmap
