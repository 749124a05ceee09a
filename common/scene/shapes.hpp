// Shapes other than the sphere. A new one is a struct with the three functions of `Shape`.
#pragma once
#include <concepts>
#include <variant>

#include "scene/sphere.hpp"

namespace texmap {

/// A shape has a distance along a ray (+infinity for a miss), a hit there, and convex(): true if no
/// ray that leaves it meets it again. What is derived from Sphere has the three of its own.
/// Lift `outside` by more than the error of the distance, or every point shades itself.
/// If the ray can see an inner side, the normal there faces the ray. So a mapping cannot use the
/// normal as a direction, and takes the Hit: see texture/shape_mappings.hpp. (A sphere's normal is
/// a direction and stays outward: who looks from its inside sees it lit as its outside is.)
template <class Type>
concept Shape = requires(const Type& shape, const Ray<double>& ray) {
  { distance_to(shape, ray) } -> std::same_as<double>;
  { hit_at(shape, ray, 1.0) } -> std::same_as<Hit<double>>;
  { shape.convex() } -> std::same_as<bool>;
};

/// A cylinder around a vertical axis, open at both ends: what a label round a can covers.
/// Its normal faces the ray, also on the inner side.
struct Cylinder {
  Point center{};
  double radius = 1;
  double half_height = 1;

  [[nodiscard]] static constexpr bool convex() { return false; }
};

/// Distance along the ray to the first point of the cylinder ahead, in lengths of `ray.direction`.
/// Textbook: the roots of a quadratic in t. Here its discriminant is r^2 |d|^2 less the square of
/// a vector product, and the root that would cancel is c / q, as for the sphere.
/// Bound in double, up to 100 radii away: 1e-14 times the sum of all lengths, if the ray comes
/// nearer to the axis than 0.999 radii and makes 10 degrees or more with it.
template <class Real>
[[nodiscard]] Real distance_to(const Cylinder& cylinder, const Ray<Real>& ray) {
  const Vec3<Real> o = ray.origin - number_cast<Real>(cylinder.center);
  const Vec3<Real>& d = ray.direction;
  const Real radius = Real(cylinder.radius);
  const Real squared = d.x * d.x + d.z * d.z;
  const Real along = o.x * d.x + o.z * d.z;
  const Real aside = o.x * d.z - o.z * d.x;
  const Real discriminant = radius * radius * squared - aside * aside;
  const Real root = sqrt(max(discriminant, Real(0)));
  const Real q = -(along + select(along < Real(0), -root, root));
  const Real one = (o.x * o.x + o.z * o.z - radius * radius) / q;
  const Real other = q / squared;
  const auto where_it_ends = [&](const Real& t) {
    const Mask<Real> met = discriminant >= Real(0) && t > Real(0) && t < infinity<Real>() &&
                           abs(o.y + t * d.y) <= Real(cylinder.half_height);
    return select(met, t, infinity<Real>());
  };
  return min(where_it_ends(one), where_it_ends(other));
}

/// The hit at a distance that `distance_to` returned.
/// Bound: the point is off the cylinder by 4 unit roundoffs of its coordinates and the radius.
template <class Real>
[[nodiscard]] Hit<Real> hit_at(const Cylinder& cylinder, const Ray<Real>& ray,
                               const Real& distance) {
  const Vec3<Real> center = number_cast<Real>(cylinder.center);
  const Vec3<Real> from_center = ray.origin - center + ray.direction * distance;
  const Vec3<Real> outward = normalize(Vec3<Real>{from_center.x, Real(0), from_center.z});
  const Vec3<Real> normal = select(dot(outward, ray.direction) > Real(0), -outward, outward);
  const Vec3<Real> point =
      center + outward * Real(cylinder.radius) + Vec3<Real>{Real(0), from_center.y, Real(0)};
  const Real size = largest(center) + Real(2 * cylinder.radius + cylinder.half_height);
  const Vec3<Real> lift = normal * (Real(16) * unit_roundoff<Real>() * size);
  return {normal, point, point + lift};
}

/// A flat picture in a frame. Its normal faces the ray.
struct Rectangle {
  Point center{};
  Vec3d right{1, 0, 0};  ///< from the center to the middle of its right side
  Vec3d up{0, 1, 0};     ///< from the center to the middle of its upper side, at a right angle

  [[nodiscard]] static constexpr bool convex() { return true; }  // it is flat
};

/// Distance along the ray to the rectangle, in lengths of `ray.direction`; its sides belong to it.
/// Bound in double: 1e-14 times the sum of all lengths, if the ray meets it at 1 degree or more.
template <class Real>
[[nodiscard]] Real distance_to(const Rectangle& rectangle, const Ray<Real>& ray) {
  const Vec3<Real> right = number_cast<Real>(rectangle.right);
  const Vec3<Real> up = number_cast<Real>(rectangle.up);
  const Vec3<Real> normal = cross(right, up);
  const Vec3<Real> to_center = number_cast<Real>(rectangle.center) - ray.origin;
  const Real t = dot(normal, to_center) / dot(normal, ray.direction);
  const Vec3<Real> from_center = ray.direction * t - to_center;
  const Mask<Real> met = t > Real(0) && t < infinity<Real>() &&
                         abs(dot(from_center, right)) <= dot(right, right) &&
                         abs(dot(from_center, up)) <= dot(up, up);
  return select(met, t, infinity<Real>());
}

/// The hit at a distance that `distance_to` returned.
template <class Real>
[[nodiscard]] Hit<Real> hit_at(const Rectangle& rectangle, const Ray<Real>& ray,
                               const Real& distance) {
  const Vec3<Real> right = number_cast<Real>(rectangle.right);
  const Vec3<Real> up = number_cast<Real>(rectangle.up);
  const Vec3<Real> front = normalize(cross(right, up));
  const Vec3<Real> normal = select(dot(front, ray.direction) > Real(0), -front, front);
  const Vec3<Real> point = ray.origin + ray.direction * distance;
  const Real size = largest(ray.origin) + largest(point) + largest(right) + largest(up);
  const Vec3<Real> lift = normal * (Real(16) * unit_roundoff<Real>() * size);
  return {normal, point, point + lift};
}

/// One of several kinds of shape, for a list of objects with different shapes. Each object then
/// names its own: `.shape = Sphere<>{...}`.
template <class... Shapes>
struct AnyShape : std::variant<Shapes...> {
  static_assert((Shape<Shapes> && ...),
                "a shape has distance_to, hit_at and a const convex(): see the concept Shape");
  using std::variant<Shapes...>::variant;

  /// Calls `work` with the shape that this object has.
  template <class Work>
  [[nodiscard]] auto with(const Work& work) const {
    return std::visit(work, static_cast<const std::variant<Shapes...>&>(*this));
  }
  [[nodiscard]] bool convex() const {
    return with([](const auto& shape) { return shape.convex(); });
  }
  template <class Real>
  [[nodiscard]] friend Real distance_to(const AnyShape& any, const Ray<Real>& ray) {
    return any.with([&](const auto& shape) { return distance_to(shape, ray); });
  }
  template <class Real>
  [[nodiscard]] friend Hit<Real> hit_at(const AnyShape& any, const Ray<Real>& ray,
                                        const Real& distance) {
    return any.with([&](const auto& shape) { return hit_at(shape, ray, distance); });
  }
};

}  // namespace texmap
