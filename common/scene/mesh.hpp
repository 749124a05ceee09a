// A surface of triangles and the point where a ray first meets it.
#pragma once
#include <array>
#include <type_traits>
#include <vector>

#include "scene/edge_function.hpp"
#include "scene/hit.hpp"

namespace texmap {

/// Eight boxes with edges along the axes, each larger than what it holds by `box_margin` of its
/// largest coordinate. A box holds a few triangles or eight other boxes.
struct MeshBoxes {
  std::array<std::array<float, 8>, 3> low, high;  ///< of each axis; NaN: no box
  std::array<int, 8> first;  ///< its first triangle in Mesh::order, or its place in Mesh::boxes
  std::array<int, 8> count;  ///< of its own triangles; -1: it holds eight boxes
};
/// The most boxes inside each other.
inline constexpr std::size_t most_nested_boxes = 24;
/// Rounding moves corners, rays and boxes by less than this part of their largest coordinate.
inline constexpr double box_margin = 0x1.8p-20;

/// Triangles that share corners. Seen from outside, corners run counterclockwise.
struct Mesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;  ///< each with the indices of its corners
  std::vector<MeshBoxes> boxes;               ///< empty: every ray tries all triangles
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

/// A ray as boxes see it; distances are depths along its longest axis. Single numbers try eight
/// boxes at once in float, packs and others one box with all lanes.
template <class Real>
struct BoxRay {
  using Number = std::conditional_t<std::is_floating_point_v<Real>, float, Real>;

  const RaySpace<Real>& space;
  Real length;             ///< the depth of its direction
  Vec3<Number> low, high;  ///< its origin, less and more a margin
  Vec3<Number> slope;      ///< the depth of a step along each axis, at most 2^60

  BoxRay(const RaySpace<Real>& of, const Vec3<Real>& d) : space(of), length(abs(of.direction.z)) {
    const Vec3<Number> origin = number_cast<Number>(of.origin);
    const Number margin = Number(box_margin) * largest(origin);
    low = origin - Vec3<Number>{margin, margin, margin};
    high = origin + Vec3<Number>{margin, margin, margin};
    const Real least = length * Real(0x1p-60);
    const auto slope_of = [&](const Real& part) {
      return number_cast<Number>(length / select(abs(part) > least, part, least));
    };
    slope = {slope_of(d.x), slope_of(d.y), slope_of(d.z)};
  }

  /// A distance as a depth, a little beyond.
  [[nodiscard]] Number depth_of(const Real& distance) const {
    return number_cast<Number>(distance * length) * Number(1 + 0x1p-19);
  }
  /// The depths of eight boxes, less their margins; infinite where the ray meets nothing in them.
  /// docs/numerics.md proves that rounding never hides a triangle.
  [[nodiscard]] std::array<Number, 8> depths_of(const MeshBoxes& boxes) const {
    std::array<Number, 8> near, far, depth, end;
    near.fill(-infinity<Number>());
    far.fill(infinity<Number>());
    depth.fill(infinity<Number>());
    end.fill(infinity<Number>());
    const auto cut = [&](std::size_t axis, const Number& from, const Number& to, const Number& by,
                         const Mask<Real>& longest) {
      for (std::size_t i = 0; i < 8; ++i) {
        const Number one = (Number(boxes.low[axis][i]) - to) * by;
        const Number other = (Number(boxes.high[axis][i]) - from) * by;
        const Number first = min(one, other);
        const Number last = max(one, other);
        near[i] = max(near[i], first);
        far[i] = min(far[i], last);
        depth[i] = select(longest, first, depth[i]);
        end[i] = select(longest, last, end[i]);
        if (axis < 2) continue;
        const Number beyond = far[i] + abs(far[i]) * Number(0x1p-19);
        const Number missed_by = max(near[i] - beyond, -end[i]);
        depth[i] = max(missed_by * infinity<Number>(), depth[i]);
      }
    };
    cut(0, low.x, high.x, slope.x, space.x_is_longest);
    cut(1, low.y, high.y, slope.y, space.y_is_longest);
    cut(2, low.z, high.z, slope.z, !(space.x_is_longest || space.y_is_longest));
    return depth;
  }
};

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
  const BoxRay<Real> box_ray(space, ray.direction);
  using Number = typename BoxRay<Real>::Number;
  struct Entered {
    Number depth;
    int first, count;
  };
  std::array<Entered, 7 * most_nested_boxes + 8> to_try;  // the last one first: the nearest
  to_try[0] = {Number(0), 0, -1};
  for (std::size_t count = 1; count > 0;) {
    const Entered box = to_try[--count];
    const Number end = box_ray.depth_of(limit);
    if (!any(box.depth < end)) continue;
    for (int k = box.first; k < box.first + box.count; ++k)
      visit_triangle(mesh.order[static_cast<std::size_t>(k)]);
    if (box.count >= 0) continue;

    const MeshBoxes& inside = mesh.boxes[static_cast<std::size_t>(box.first)];
    const std::array<Number, 8> depths = box_ray.depths_of(inside);
    const std::size_t kept = count;
    for (std::size_t i = 0; i < 8; ++i) {
      to_try[count] = {depths[i], inside.first[i], inside.count[i]};
      count += any(depths[i] < end) ? 1U : 0U;
    }
    for (std::size_t i = kept + 1; i < count; ++i) {
      const Entered moved = to_try[i];
      std::size_t to = i;
      for (; to > kept && any(to_try[to - 1].depth < moved.depth); --to)
        to_try[to] = to_try[to - 1];
      to_try[to] = moved;
    }
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
  Mask<Real> lit;  ///< false: the ray met nothing, so there is no shadow to look for
};
template <class Real>
[[nodiscard]] OtherTriangles<Real> others(const Mesh& mesh, const MeshHit<Real>& hit) {
  return {mesh, hit.triangle, hit.met};
}

/// True where one of these triangles lies between the ray's origin and `distance` along it.
template <class Real>
[[nodiscard]] Mask<Real> is_occluded(const OtherTriangles<Real>& others, const Ray<Real>& ray,
                                     const Real& distance, int /*leaving*/ = -1) {
  Mask<Real> hidden = mask_of<Real>(false);
  Real limit = select(others.lit, distance, -infinity<Real>());
  for_each_crossing(others.mesh, ray, limit, [&](int number, const Crossing<Real>& found) {
    hidden = hidden || (found.met && !(others.own == Real(number)) && found.distance > Real(0) &&
                        found.distance < limit);
    limit = select(hidden, -infinity<Real>(), limit);  // the first triangle in the way decides
  });
  return hidden;
}

}  // namespace texmap
