// The part of the picture in which a sphere can be seen.
#pragma once
#include <numbers>

#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace texmap {

/// The columns of a row from `first` to end - 1.
struct Span {
  int first, end;
};

/// A rectangle of the picture, in pixels from its left and upper edge; may reach beyond it.
struct ScreenBounds {
  double left, right, top, bottom;

  /// The columns of a row inside the rectangle; {width, width} if there are none.
  ///
  /// @param width  of the picture, in pixels
  [[nodiscard]] Span columns(int row, int width) const {
    const auto within = [width](double column) {
      return static_cast<int>(clamp(column, 0.0, static_cast<double>(width)));
    };
    if (row < top || row > bottom || right < 0 || left >= width) return {width, width};
    return {within(std::ceil(left)), within(std::floor(right) + 1)};
  }
};

/// The tangents of two angles.
struct SeenTangents {
  double low = -infinity<double>(), high = infinity<double>();
};

/// The tangents of the angles of a circle's edges, seen from the origin along z.
///
/// @param x, z    its center
/// @param radius  above 0
/// @return  -infinity and +infinity if the circle contains the eye or reaches behind it
[[nodiscard]] inline SeenTangents seen_tangents(double x, double z, double radius) {
  const double away = std::hypot(x, z);
  if (!(away > radius)) return {};
  const double middle = std::atan2(x, z);
  const double half = std::asin(radius / away);
  const double right_angle = std::numbers::pi / 2;
  SeenTangents seen;
  if (std::abs(middle - half) < right_angle) seen.low = std::tan(middle - half);
  if (std::abs(middle + half) < right_angle) seen.high = std::tan(middle + half);
  // Wholly behind the eye nothing is seen, but a bound may be too large.
  if (std::abs(middle) >= right_angle) return {};
  return seen;
}

/// The rectangle outside of which no ray through a pixel meets the sphere; one pixel is added on
/// each side, for rays off the center and for rounding.
/// Source: the tangent planes through the eye that are parallel to an axis of the picture.
[[nodiscard]] inline ScreenBounds screen_bounds(const View<>& view, const Sphere<>& sphere) {
  const Point center = sphere.center - view.eye;
  const double z = dot(center, view.forward);
  const SeenTangents across = seen_tangents(dot(center, view.right), z, sphere.radius);
  const SeenTangents up = seen_tangents(dot(center, view.up), z, sphere.radius);
  const auto column = [&](double tangent) { return view.center_column + tangent / view.pixel; };
  const auto row = [&](double tangent) { return view.center_row - tangent / view.pixel; };
  return {column(across.low) - 1, column(across.high) + 1, row(up.high) - 1, row(up.low) + 1};
}

}  // namespace texmap
