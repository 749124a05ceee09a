// Which boxes around the triangles of a mesh a ray enters, and which triangles it crosses there.
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <type_traits>

#include "engine/fast/box_tree.hpp"
#include "engine/fast/four_floats.hpp"

namespace texmap {

/// The most boxes inside each other.
inline constexpr std::size_t most_nested_boxes = 24;

/// The largest coordinate of a ray's origin; in float, where small numbers end early, more if the
/// direction is so short that `snapped` moves corners by more than rounding does.
template <class Real>
[[nodiscard]] Real margin_size(const RaySpace<Real>& space) {
  const Real size = largest(space.origin);
  if constexpr (!std::is_same_v<Scalar<Real>, float>) return size;
  return size + Real(0x1p20) * least_factor<Real>() / abs(space.direction.z);
}

/// A ray as boxes see it; distances are depths along its longest axis. docs/numerics.md proves that
/// rounding never hides a triangle. Packs and others try one box with all lanes.
template <class Real>
struct BoxRay {
  using Number = Real;  ///< of depths

  const RaySpace<Real>& space;
  Vec3<Real> low, high;  ///< its origin, less and more a margin
  Vec3<Real> slope;      ///< the depth of a step along each axis, at most 2^60

  BoxRay(const RaySpace<Real>& of, const Vec3<Real>& d) : space(of) {
    const Real margin = Real(box_margin) * margin_size(of);
    low = of.origin - Vec3<Real>{margin, margin, margin};
    high = of.origin + Vec3<Real>{margin, margin, margin};
    const Real length = abs(of.direction.z);
    const Real least = length * Real(0x1p-60);
    const auto slope_of = [&](const Real& part) {
      return length / select(abs(part) > least, part, least);
    };
    slope = {slope_of(d.x), slope_of(d.y), slope_of(d.z)};
  }

  /// A distance as a depth.
  [[nodiscard]] Real depth_of(const Real& distance) const {
    return distance * abs(space.direction.z);
  }
  /// Bits for the boxes of eight that the ray enters before `limit`, with the depths where it does,
  /// less their margins; infinite in lanes that miss a box.
  [[nodiscard]] unsigned enter(const MeshBoxes& boxes, const Real& limit,
                               std::array<Real, 8>& depths) const {
    unsigned entered = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      if (std::isnan(boxes.sides[i])) continue;  // no box; intervals take NaN for any number
      Real near = -infinity<Real>();
      Real far = infinity<Real>();
      Real in = infinity<Real>();
      Real out = infinity<Real>();
      const auto cut = [&](std::size_t axis, const Real& from, const Real& to, const Real& by,
                           const Mask<Real>& longest) {
        const Real one = (Real(boxes.sides[8 * axis + i]) - to) * by;
        const Real other = (Real(boxes.sides[8 * axis + 24 + i]) - from) * by;
        near = max(near, min(one, other));
        far = min(far, max(one, other));
        in = select(longest, min(one, other), in);
        out = select(longest, max(one, other), out);
      };
      cut(0, low.x, high.x, slope.x, space.x_is_longest);
      cut(1, low.y, high.y, slope.y, space.y_is_longest);
      cut(2, low.z, high.z, slope.z, !(space.x_is_longest || space.y_is_longest));
      depths[i] = select(near < far && out > Real(0), in, infinity<Real>());
      entered |= any(depths[i] < limit) ? 1U << i : 0U;
    }
    return entered;
  }
  /// Bits for the triangles of a leaf that the ray may meet.
  [[nodiscard]] unsigned may_meet(const MeshLeaf& /*leaf*/) const { return 15; }
};

/// Single numbers try four boxes or four triangles at once, in float, with the renamed axes.
template <std::floating_point Real>
struct BoxRay<Real> {
  using Number = float;

  struct Axis {
    std::size_t enters, leaves;  ///< where MeshBoxes::sides has these sides
    std::size_t in_leaf;         ///< where MeshLeaf has these coordinates
    FourFloats from, near, far;  ///< the origin, and moved by the margin for each side
    FourFloats slope;
  };
  Axis x, y, z;
  FourFloats slide_x, slide_y;  ///< x and y of a step in depth
  FourFloats reach;             ///< twice the ray's margin_size
  Real length;

  BoxRay(const RaySpace<Real>& space, const Vec3<Real>& /*d*/) : length(abs(space.direction.z)) {
    const Vec3<float> from = number_cast<float>(space.renamed(space.origin));
    const auto size = static_cast<float>(margin_size(space));
    const float margin = static_cast<float>(box_margin) * size;
    const auto axis = [&](std::size_t world, float start, float slope) {
      const bool back = slope < 0;
      return Axis{
          .enters = 8 * world + (back ? 24 : 0),
          .leaves = 8 * world + (back ? 0 : 24),
          .in_leaf = 4 * world,
          .from = four_times(start),
          .near = four_times(back ? start - margin : start + margin),
          .far = four_times(back ? start + margin : start - margin),
          .slope = four_times(slope),
      };
    };
    const auto along_x = static_cast<float>(space.direction.x / space.direction.z);
    const auto along_y = static_cast<float>(space.direction.y / space.direction.z);
    const float ahead = space.direction.z < Real(0) ? -1.0F : 1.0F;
    const auto slope_of = [&](float along) {
      return ahead / (abs(along) > 0x1p-60F ? along : 0x1p-60F);
    };
    const std::size_t longest = space.x_is_longest ? 0 : space.y_is_longest ? 1 : 2;
    x = axis((longest + 1) % 3, from.x, slope_of(along_x));
    y = axis((longest + 2) % 3, from.y, slope_of(along_y));
    z = axis(longest, from.z, ahead);
    slide_x = four_times(along_x);
    slide_y = four_times(along_y);
    reach = four_times(2 * size);
  }

  [[nodiscard]] float depth_of(const Real& distance) const {
    return static_cast<float>(distance * length);
  }
  [[nodiscard]] unsigned enter(const MeshBoxes& boxes, float limit,
                               std::array<float, 8>& depths) const {
    const auto four = [&](std::size_t first) {
      const auto side = [&](std::size_t at) { return four_at(&boxes.sides[at + first]); };
      const auto in = [&](const Axis& axis) {
        return (side(axis.enters) - axis.near) * axis.slope;
      };
      const auto out = [&](const Axis& axis) {
        return (side(axis.leaves) - axis.far) * axis.slope;
      };
      const FourFloats in_z = in(z);
      const FourFloats out_z = out(z);
      store(in_z, &depths[first]);
      const FourFloats near = max(max(in(x), in(y)), in_z);
      const FourFloats far = min(min(out(x), out(y)), out_z);
      return bits_less(near, far) & bits_less(four_times(0), out_z) &
             bits_less(in_z, four_times(limit));
    };
    return four(0) | four(4) << 4;
  }
  /// A triangle is missed if areas at two edges have different signs, beyond what rounding moves.
  [[nodiscard]] unsigned may_meet(const MeshLeaf& leaf) const {
    struct Seen {
      FourFloats x, y, z;
    };
    const auto seen = [&](const std::array<float, 12>& corner) {
      const auto from_origin = [&](const Axis& axis) {
        return four_at(&corner[axis.in_leaf]) - axis.from;
      };
      const FourFloats depth = from_origin(z);
      return Seen{from_origin(x) - depth * slide_x, from_origin(y) - depth * slide_y, depth};
    };
    const Seen a = seen(leaf.corners[0]);
    const Seen b = seen(leaf.corners[1]);
    const Seen c = seen(leaf.corners[2]);
    const FourFloats ab = a.x * b.y - a.y * b.x;
    const FourFloats bc = b.x * c.y - b.y * c.x;
    const FourFloats ca = c.x * a.y - c.y * a.x;
    const auto size = [](const Seen& p) { return max(abs(p.x), abs(p.y)); };
    const FourFloats aside = max(max(size(a), size(b)), size(c));
    const FourFloats depth = max(max(abs(a.z), abs(b.z)), abs(c.z));
    const FourFloats error = four_times(0x1p-17F) * aside * (reach + aside + depth);
    const FourFloats least = min(min(ab, bc), ca) + error;
    const FourFloats most = max(max(ab, bc), ca) - error;
    return 15U & ~(bits_less(least, four_times(0)) & bits_less(four_times(0), most));
  }
};

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
  const auto seen = [&](int point) {
    return seen_along(space, number_cast<Real>(mesh.points[static_cast<std::size_t>(point)]));
  };
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
        visit_crossing(mesh, leaf.triangles[i], space, own, seen, visit);
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

/// The most points of a mesh that a ray sees at once.
inline constexpr std::size_t most_seen_at_once = 48;

/// for_each_crossing without boxes: each point is seen once for all triangles at it.
template <class Real, class Visit>
void cross_all(const Mesh& mesh, const Ray<Real>& ray, const Visit& visit, const Real& own) {
  const RaySpace<Real> space(ray);
  std::array<std::array<Real, 3>, most_seen_at_once> seen;  // a Vec3 would be set to 0 first
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3<Real> point = seen_along(space, number_cast<Real>(mesh.points[i]));
    seen[i] = {point.x, point.y, point.z};
  }
  const auto corner = [&](int point) {
    const auto& [x, y, z] = seen[static_cast<std::size_t>(point)];
    return Vec3<Real>{x, y, z};
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    visit_crossing(mesh, static_cast<int>(i), space, own, corner, visit);
}

template <class Real, class Visit>
void for_each_crossing(const BoxedMesh& mesh, const Ray<Real>& ray, const Real& limit,
                       const Visit& visit, const Real& own) {
  if (!mesh.boxes.empty()) return cross_boxes(mesh, ray, limit, visit, own);
  const Mesh& list = mesh;
  if (list.points.size() <= most_seen_at_once) return cross_all(list, ray, visit, own);
  for_each_crossing(list, ray, limit, visit, own);
}

}  // namespace texmap
