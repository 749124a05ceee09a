// A surface of triangles and the point where a ray first meets it.
#pragma once
#include <array>
#include <vector>

#include "scene/edge_function.hpp"
#include "scene/hit.hpp"

namespace texmap {

/// A box with edges along the axes. A box without triangles of its own holds two other boxes: the
/// next one in Mesh::boxes and `second`, which lies further along an axis.
struct MeshBox {
  Point center;
  Point half;      ///< half its extent in x, y and z
  int first, end;  ///< its own triangles, in Mesh::order
  int second;
  int axis;  ///< 0 for x, 1 for y, 2 for z
};
/// The most boxes inside each other.
inline constexpr std::size_t most_nested_boxes = 64;

/// Triangles that share corners. Seen from outside, corners run counterclockwise.
struct Mesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;  ///< each with the indices of its corners
  std::vector<MeshBox> boxes;                 ///< empty: every ray tries all triangles
  std::vector<int> order;                     ///< the triangles in the order of the boxes

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

/// True where a ray may meet a triangle in a box before `limit`. Rounding never makes it false:
/// the box is larger by 24 unit roundoffs; docs/numerics.md counts them.
template <class Real>
[[nodiscard]] Mask<Real> may_meet(const RaySpace<Real>& space, const MeshBox& box,
                                  const Real& limit) {
  const Vec3<Real>& d = space.direction;
  const Vec3<Real> center = number_cast<Real>(box.center);
  const Vec3<Real> world_half = number_cast<Real>(box.half);
  const Vec3<Real> half = space.renamed(world_half);
  const Vec3<Real> p = space.renamed(center - space.origin);
  const Real far = abs(d.z);
  const Real size = largest(center) + largest(world_half) + largest(space.origin);
  const Real margin = Real(24) * unit_roundoff<Real>() * size;
  const Real depth = half.z + margin;
  return abs(p.x * d.z - p.z * d.x) <= half.x * far + half.z * abs(d.x) + margin * far &&
         abs(p.y * d.z - p.z * d.y) <= half.y * far + half.z * abs(d.y) + margin * far &&
         select(d.z < Real(0), -p.z, p.z) >= -depth &&
         select(d.z < Real(0), -p.z, p.z) - depth <= limit * far;
}

/// Calls visit(number, crossing) for the triangles of a mesh that a ray crosses before `limit`, in
/// any order; `visit` may change the limit.
template <class Real, class Visit>
void for_each_crossing(const Mesh& mesh, const Ray<Real>& ray, const Real& limit,
                       const Visit& visit) {
  const RaySpace<Real> space(ray);
  const auto visit_triangle = [&](int number) {
    const auto seen = [&](int corner) {
      return seen_along(space, number_cast<Real>(mesh.corner(number, corner)));
    };
    const Crossing<Real> found = crossing(space, seen(0), seen(1), seen(2));
    if (any(found.met)) visit(number, found);
  };
  if (mesh.boxes.empty()) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) visit_triangle(static_cast<int>(i));
    return;
  }
  // Boxes to try; the last one first.
  std::array<int, most_nested_boxes + 1> boxes{};
  for (std::size_t count = 1; count > 0;) {
    const int place = boxes[--count];
    const MeshBox& box = mesh.boxes[static_cast<std::size_t>(place)];
    if (!any(may_meet(space, box, limit))) continue;
    for (int k = box.first; k < box.end; ++k)
      visit_triangle(mesh.order[static_cast<std::size_t>(k)]);
    if (box.first < box.end) continue;
    const Vec3<Real>& d = ray.direction;
    const bool backward = any((box.axis == 0 ? d.x : box.axis == 1 ? d.y : d.z) < Real(0));
    boxes[count++] = backward ? place + 1 : box.second;
    boxes[count++] = backward ? box.second : place + 1;
  }
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
/// the smallest number. The ray does not meet it again from `outside`, nor from `inside`.
/// Domain: coordinates 0 or of 1e-6 to 1e6, directions of 0.1 to 1e6; at most 2^24 triangles.
template <class Real>
[[nodiscard]] MeshHit<Real> first_hit(const Mesh& mesh, const Ray<Real>& ray) {
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
  const Vec3<Real> lift = hit.normal * (Real(32) * unit_roundoff<Real>() * size);
  hit.outside = hit.point + lift;
  hit.inside = hit.point - lift;
  return hit;
}

/// The triangles of a mesh that can shadow a hit point: all but its own, in each lane.
template <class Real>
struct OtherTriangles {
  const Mesh& mesh;
  Real own;
};
template <class Real>
[[nodiscard]] OtherTriangles<Real> others(const Mesh& mesh, const MeshHit<Real>& hit) {
  return {mesh, hit.triangle};
}

/// True where one of these triangles lies between the ray's origin and `distance` along it.
template <class Real>
[[nodiscard]] Mask<Real> is_occluded(const OtherTriangles<Real>& others, const Ray<Real>& ray,
                                     const Real& distance, int /*leaving*/ = -1) {
  Mask<Real> hidden = mask_of<Real>(false);
  for_each_crossing(others.mesh, ray, distance, [&](int number, const Crossing<Real>& found) {
    hidden = hidden || (found.met && !(others.own == Real(number)) && found.distance > Real(0) &&
                        found.distance < distance);
  });
  return hidden;
}

}  // namespace texmap
