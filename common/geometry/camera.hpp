// A pinhole camera: from a pixel to the ray that looks through it.
#pragma once
#include "ray.hpp"

namespace texmap {

/// Which point of a pixel its coordinates name. Programs differ here by half a pixel.
enum class PixelAnchor { center, corner };

/// A camera in a right-handed world, looking from `eye` at `target` with +y up in the picture.
struct Camera {
  Point eye;
  Point target;
  double fov_y_degrees = 60;  ///< angle from the lower to the upper edge of the picture, 0 to 180
  PixelAnchor anchor = PixelAnchor::center;
};

/// A camera made ready for one picture size: what every ray of the picture has in common.
template <class Real>
struct ViewIn {
  Vec3<Real> eye;
  Vec3<Real> forward;
  Vec3<Real> right;
  Vec3<Real> up;
  Real pixel{};          ///< width and height of a pixel in the plane at distance 1 before the eye
  Real center_column{};  ///< what `forward` looks through, in pixels
  Real center_row{};
  int width = 0;
  int height = 0;
};

/// A view as it is made; number_cast turns it into that of the number that a picture is drawn with.
using View = ViewIn<double>;

/// A view in another number, for those who need it often: turning it costs as much as a ray.
template <class Real>
[[nodiscard]] ViewIn<Real> number_cast(const View& view) {
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

/// @param width, height  of the picture, in pixels, at least 1
/// @return  unit vectors forward, right and up, and how pixels lie in the plane at distance 1
/// Bound: the vectors are within 8 unit roundoffs over the cosine of the camera's tilt; docs/numbers.md.
/// Domain: `eye` differs from `target`, and not only in y: straight up and straight down leave "right" undefined.
[[nodiscard]] inline View view_of(const Camera& camera, int width, int height) {
  const Point forward = normalize(camera.target - camera.eye);
  const Point right = normalize(cross(forward, Point{0, 1, 0}));
  const double half_height = std::tan(camera.fov_y_degrees * std::numbers::pi / 360);
  const double anchor = camera.anchor == PixelAnchor::center ? 0.5 : 0;  // from a pixel's corner to what its numbers name
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

/// The direction from the eye through a point of the picture, not brought to unit length.
///
/// @param column, row  in pixels from the left and the upper edge; whole numbers name a pixel (its center or its corner, as the
///                     camera says), fractions the points between
/// @return  1 long along view.forward; longer where it looks aside
/// Bound: within 6 unit roundoffs of its length, as ray_through, whose bound holds it; docs/numbers.md.
template <class Real, class Number>
[[nodiscard]] Vec3<Real> direction_through(const ViewIn<Number>& view, const Real& column, const Real& row) {
  const Real x = (column - number_cast<Real>(view.center_column)) * number_cast<Real>(view.pixel);
  const Real y = (number_cast<Real>(view.center_row) - row) * number_cast<Real>(view.pixel);
  return number_cast<Real>(view.forward) + number_cast<Real>(view.right) * x + number_cast<Real>(view.up) * y;
}

/// The ray through a point of the picture.
///
/// @param column, row  as for direction_through
/// @return  a ray from the eye, its direction of unit length
/// Bound: the direction is within 6 unit roundoffs, for angles of view of 1 to 120 degrees and pictures up to twice as wide as
/// high; in longer ones in proportion to their length; docs/numbers.md.
template <class Real, class Number>
[[nodiscard]] Ray<Real> ray_through(const ViewIn<Number>& view, const Real& column, const Real& row) {
  return {number_cast<Real>(view.eye), normalize(direction_through(view, column, row))};
}

}  // namespace texmap
