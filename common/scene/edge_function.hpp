// On which side of an edge a ray passes, without an error: meshes then have no cracks.
#pragma once
#include "number/compensated.hpp"
#include "number/compiler.hpp"
#include "scene/ray.hpp"

namespace texmap {

/// A ray with its axes renamed, x to y to z to x, until z is the longest part of its direction.
template <class Real>
struct RaySpace {
  Vec3<Real> origin;        ///< with the world's axes
  Vec3<Real> direction;     ///< with the renamed axes
  Mask<Real> x_is_longest;  ///< the world's x
  Mask<Real> y_is_longest;

  explicit RaySpace(const Ray<Real>& ray) : origin(ray.origin) {
    const Vec3<Real> size{abs(ray.direction.x), abs(ray.direction.y), abs(ray.direction.z)};
    x_is_longest = size.x > size.y && size.x > size.z;
    y_is_longest = !x_is_longest && size.y > size.z;
    direction = renamed(ray.direction);
  }

  /// A vector of the world with the renamed axes.
  [[nodiscard]] Vec3<Real> renamed(const Vec3<Real>& v) const {
    return select(x_is_longest, Vec3<Real>{v.y, v.z, v.x},
                  select(y_is_longest, Vec3<Real>{v.z, v.x, v.y}, v));
  }
};

/// The product of two numbers that are at least so large loses no digits by underflow.
template <class Real>
[[nodiscard]] Real least_factor() {
  using Limits = std::numeric_limits<Scalar<Real>>;
  return Real(ldexp(Scalar<Real>(1), (Limits::min_exponent + Limits::digits) / 2));
}

/// 0 for a number below `least_factor`.
template <class Real>
[[nodiscard]] Real snapped(const Real& x) {
  const Real least = least_factor<Real>();
  // A 0 is kept as it is: it may have derivatives.
  return select(abs(x) < least && (x < Real(0) || x > Real(0)), Real(0), x);
}

/// A point as a ray sees it. (x, y) is its place in a picture with the ray at (0, 0), and z is its
/// depth: the point itself decides, so that all triangles at a corner see it at the same place.
/// If the ray's direction is point - origin as rounded, the point is at (0, 0) without an error.
/// Bound: x, y within 6 unit roundoffs of |direction| (|point| + |origin|), in largest parts.
/// Source: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (2013).
template <class Real>
[[nodiscard]] Vec3<Real> seen_along(const RaySpace<Real>& space, const Vec3<Real>& point) {
  const Vec3<Real>& d = space.direction;
  const Vec3<Real> p = space.renamed(point - space.origin);
  return {snapped(p.x * d.z - p.z * d.x), snapped(p.y * d.z - p.z * d.y), p.z};
}

/// On which side of an edge the ray passes: exactly one of the two, unless a corner is NaN or
/// both corners are at the same place.
template <class Real>
struct EdgeSide {
  Real area;     ///< twice the signed area of the ray and the edge; its sign is exact
  Real product;  ///< the first of the two products that it is a difference of
  Mask<Real> left, right;
};

/// The side of the edge from `a` to `b`, both as seen_along gives them. From `b` to `a` everything
/// is the exact opposite. A ray that passes through the edge is moved a little in x, and less in y.
/// Textbook: a.x b.y - a.y b.x, and its sign.
/// Domain: |x|, |y| below the root of the largest number / 4.
template <class Real>
[[nodiscard]] EdgeSide<Real> side_of_edge(const Vec3<Real>& a, const Vec3<Real>& b) {
  // Rounding never exchanges two products: if the rounded ones differ, their order is exact.
  const Real one = a.x * b.y;
  const Real other = a.y * b.x;
  EdgeSide<Real> side{one - other, one, one > other, one < other};
  const Mask<Real> undecided = one == other;
  if (!any(undecided)) return side;

  const Real one_rest = two_product(a.x, b.y).low;
  const Real other_rest = two_product(a.y, b.x).low;
  const Mask<Real> through = undecided && one_rest == other_rest;
  side.area = select(undecided, side.area + (one_rest - other_rest), side.area);
  side.left = side.left || (undecided && one_rest > other_rest) ||
              (through && (b.y < a.y || (b.y == a.y && b.x > a.x)));
  side.right = side.right || (undecided && one_rest < other_rest) ||
               (through && (b.y > a.y || (b.y == a.y && b.x < a.x)));
  return side;
}

/// Where a ray's line passes through a triangle.
template <class Real>
struct Crossing {
  Mask<Real> met;    ///< it does
  Mask<Real> front;  ///< and comes from the side where a, b, c run counterclockwise
  Real a, b, c;      ///< the corners' weights, 0 to 1, exactly (1, 0, 0) at corner a
  Real distance;     ///< in lengths of the ray's direction; negative behind its origin
};

/// The areas at bc, ca and ab as EdgeSide has them, each within 2 unit roundoffs of itself.
template <class Real>
[[nodiscard]] TEXMAP_NOINLINE Vec3<Real> areas_of_needle(const Vec3<Real>& a, const Vec3<Real>& b,
                                                         const Vec3<Real>& c) {
  const auto area = [](const Vec3<Real>& p, const Vec3<Real>& q) {
    return difference_of_products(p.x, q.y, p.y, q.x);
  };
  return {area(b, c), area(c, a), area(a, b)};
}

/// The crossing of a ray with a triangle; `a`, `b`, `c` are its corners as seen_along gives them.
/// Law: a line meets as many triangles of a closed mesh from the front as from the back; through
/// an edge or a corner it meets exactly one of the triangles there on each side.
/// Bound: the weights' mean of the corners is the ray's place within 10 unit roundoffs of the
/// corners as seen; the point at `distance` is within 34 of |corner| + |origin|, in largest parts,
/// of the plane, however small the height. docs/numerics.md proves the law and the second bound.
template <class Real>
[[nodiscard]] Crossing<Real> crossing(const RaySpace<Real>& space, const Vec3<Real>& a,
                                      const Vec3<Real>& b, const Vec3<Real>& c) {
  const EdgeSide<Real> ab = side_of_edge(a, b);
  const EdgeSide<Real> bc = side_of_edge(b, c);
  const EdgeSide<Real> ca = side_of_edge(c, a);
  const Mask<Real> left = ab.left && bc.left && ca.left;
  const Mask<Real> met = left || (ab.right && bc.right && ca.right);
  const Mask<Real> backward = space.direction.z < Real(0);
  const Mask<Real> front = (left && backward) || (met && !left && !backward);
  Crossing<Real> result{met, front, Real(1), Real(0), Real(0), Real(1)};
  if (!any(met)) return result;
  Vec3<Real> at{bc.area, ca.area, ab.area};
  const Real products = abs(ab.product) + abs(bc.product) + abs(ca.product);
  // A thin triangle's areas are small differences of large products.
  const Mask<Real> thin = met && products > Real(1.75) * abs(at.x + at.y + at.z);
  if (any(thin)) at = select(thin, areas_of_needle(a, b, c), at);
  const Real whole = select(met, at.x + at.y + at.z, Real(1));
  result.a = at.x / whole;
  result.b = at.y / whole;
  result.c = at.z / whole;
  result.distance = (result.a * a.z + result.b * b.z + result.c * c.z) / space.direction.z;
  return result;
}

}  // namespace texmap
