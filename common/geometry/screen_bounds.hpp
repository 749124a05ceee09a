// Where on the picture a sphere can be seen: rays elsewhere need not look for it.
#pragma once
#include "camera.hpp"
#include "sphere.hpp"

namespace texmap {

/// Neighbouring columns of a row: from `first` on, `end` is the first that is not among them.
struct Span {
  int first, end;
};

/// A rectangle of the picture, in pixels from its left and upper edge; may reach beyond the picture.
struct ScreenBounds {
  double left, right, top, bottom;

  /// The columns of a row that can show what is inside; none is {width, width}.
  ///
  /// @param width  of the picture, in pixels
  [[nodiscard]] Span columns(int row, int width) const {
    const auto within = [width](double column) { return static_cast<int>(clamp(column, 0.0, static_cast<double>(width))); };
    if (row < top || row > bottom || right < 0 || left >= width) return {width, width};
    return {within(std::ceil(left)), within(std::floor(right) + 1)};
  }
};

/// The tangents of two angles.
struct SeenTangents {
  double low = -infinity<double>(), high = infinity<double>();
};

/// The tangents of the angles between which a circle is seen from the origin, looking along z.
///
/// @param x, z    its center
/// @param radius  its radius, above 0
/// @return  -infinity and +infinity where it is around the eye or reaches behind it
[[nodiscard]] inline SeenTangents seen_tangents(double x, double z, double radius) {
  const double away = std::hypot(x, z);
  if (!(away > radius)) return {};
  const double middle = std::atan2(x, z);
  const double half = std::asin(radius / away);
  const double right_angle = std::numbers::pi / 2;
  SeenTangents seen;
  if (std::abs(middle - half) < right_angle) seen.low = std::tan(middle - half);
  if (std::abs(middle + half) < right_angle) seen.high = std::tan(middle + half);
  // Wholly behind the eye: nothing is seen, but a bound may be too large and never too small.
  if (std::abs(middle) >= right_angle) return {};
  return seen;
}

/// The part of a picture outside of which no ray through a pixel meets the sphere.
///
/// One pixel is added on each side: for rays anywhere in a pixel, and for roundings.
/// Source: the tangent planes through the eye that are parallel to one axis of the picture.
[[nodiscard]] inline ScreenBounds screen_bounds(const View& view, const Sphere& sphere) {
  const Point center = sphere.center - view.eye;
  const double z = dot(center, view.forward);
  const SeenTangents across = seen_tangents(dot(center, view.right), z, sphere.radius);
  const SeenTangents up = seen_tangents(dot(center, view.up), z, sphere.radius);
  const auto column = [&](double tangent) { return view.center_column + tangent / view.pixel; };
  const auto row = [&](double tangent) { return view.center_row - tangent / view.pixel; };
  return {column(across.low) - 1, column(across.high) + 1, row(up.high) - 1, row(up.low) + 1};
}

}  // namespace texmap
