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
struct View {
  Point eye;
  Point forward;
  Point right;
  Point up;
  double half_width = 1;   ///< tangent of half the horizontal angle of view
  double half_height = 1;  ///< tangent of half the vertical one
  int width = 0;
  int height = 0;
  double anchor = 0.5;  ///< from a pixel's corner to the point its coordinates name, in pixels
};

/// @param width, height  of the picture, in pixels, at least 1
/// @return  unit vectors forward, right and up, and the tangents of half the angles of view
/// Bound: the vectors are within 8 unit roundoffs over the cosine of the camera's tilt; docs/numbers.md.
/// Domain: `eye` differs from `target`, and not only in y: straight up and straight down leave "right" undefined.
[[nodiscard]] inline View view_of(const Camera& camera, int width, int height) {
  const Point forward = normalize(camera.target - camera.eye);
  const Point right = normalize(cross(forward, Point{0, 1, 0}));
  const double half_height = std::tan(camera.fov_y_degrees * std::numbers::pi / 360);
  return {
      .eye = camera.eye,
      .forward = forward,
      .right = right,
      .up = cross(right, forward),
      .half_width = half_height * width / height,
      .half_height = half_height,
      .width = width,
      .height = height,
      .anchor = camera.anchor == PixelAnchor::center ? 0.5 : 0,
  };
}

/// The ray through a point of the picture.
///
/// @param column, row  in pixels from the left and the upper edge; whole numbers name a pixel (its center or its corner, as the
///                     camera says), fractions the points between
/// @return  a ray from the eye, its direction of unit length
/// Bound: the direction is within 6 unit roundoffs, for angles of view of 1 to 120 degrees and pictures up to twice as wide as
/// high; in longer ones in proportion to their length; docs/numbers.md.
template <class Real>
[[nodiscard]] Ray<Real> ray_through(const View& view, const Real& column, const Real& row) {
  const Real anchor = Real(view.anchor);
  const Real x = (Real(2) * (column + anchor) / Real(view.width) - Real(1)) * Real(view.half_width);
  const Real y = (Real(1) - Real(2) * (row + anchor) / Real(view.height)) * Real(view.half_height);
  const Vec3<Real> direction =
      number_cast<Real>(view.forward) + number_cast<Real>(view.right) * x + number_cast<Real>(view.up) * y;
  return {number_cast<Real>(view.eye), normalize(direction)};
}

}  // namespace texmap
