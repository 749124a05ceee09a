// A pinhole camera: from a pixel to the ray through it.
#pragma once
#include <numbers>

#include "scene/ray.hpp"

namespace texmap {

/// Which point of a pixel has whole coordinates: renderers differ here by half a pixel.
enum class PixelAnchor { center, corner };

/// A camera in a right-handed world: it looks from `eye` at `target`, with +y up in the picture.
struct Camera {
  Point eye;
  Point target;
  double fov_y_degrees = 60;  ///< vertical angle of view, 0 to 180
  PixelAnchor anchor = PixelAnchor::center;
};

/// A place in a picture, in pixels: (0, 0) is the center or the upper left corner of the upper left
/// pixel, as Camera::anchor says. Columns grow to the right, rows downward.
template <class Real>
struct PixelPlace {
  Real column, row;
};

/// A camera prepared for a picture size.
template <class Real = double>
struct View {
  Vec3<Real> eye;
  Vec3<Real> forward;
  Vec3<Real> right;
  Vec3<Real> up;
  Real pixel{};          ///< size of a pixel in the plane at distance 1 from the eye
  Real center_column{};  ///< the place in the picture that `forward` points at
  Real center_row{};
  int width = 0;
  int height = 0;
};

/// The view in another number.
template <class Real>
[[nodiscard]] View<Real> number_cast(const View<>& view) {
  return {number_cast<Real>(view.eye),
          number_cast<Real>(view.forward),
          number_cast<Real>(view.right),
          number_cast<Real>(view.up),
          number_cast<Real>(view.pixel),
          number_cast<Real>(view.center_column),
          number_cast<Real>(view.center_row),
          view.width,
          view.height};
}

/// The view of a camera for a picture of width x height pixels, each at least 1.
/// Domain: `eye` and `target` differ, not only in y.
[[nodiscard]] inline View<> view_of(const Camera& camera, int width, int height) {
  const Vec3d forward = normalize(camera.target - camera.eye);
  const Vec3d right = normalize(cross(forward, Vec3d{0, 1, 0}));
  const double half_height = tan(camera.fov_y_degrees * std::numbers::pi / 360);
  const double anchor = camera.anchor == PixelAnchor::center ? 0.5 : 0;
  return {
      .eye = camera.eye,
      .forward = forward,
      .right = right,
      .up = cross(right, forward),
      .pixel = 2 * half_height / height,
      .center_column = width / 2.0 - anchor,
      .center_row = height / 2.0 - anchor,
      .width = width,
      .height = height,
  };
}

/// The direction from the eye through a point of the picture; its component along `forward` is 1.
/// The column and the row are those of a PixelPlace. Bound: 6 unit roundoffs of its length.
template <class Real, class Other>
[[nodiscard]] Vec3<Real> direction_through(const View<Other>& view, const Real& column,
                                           const Real& row) {
  const Real x = (column - number_cast<Real>(view.center_column)) * number_cast<Real>(view.pixel);
  const Real y = (number_cast<Real>(view.center_row) - row) * number_cast<Real>(view.pixel);
  return number_cast<Real>(view.forward) + number_cast<Real>(view.right) * x +
         number_cast<Real>(view.up) * y;
}

/// The ray through a point of the picture, its direction of unit length.
/// Domain: 1 to 120 degrees of view; pictures at most 2:1.
template <class Real, class Other>
[[nodiscard]] Ray<Real> ray_through(const View<Other>& view, const Real& column, const Real& row) {
  return {number_cast<Real>(view.eye), normalize(direction_through(view, column, row))};
}

}  // namespace texmap
