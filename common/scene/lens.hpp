// A camera's lens and exposure: defocus blur and motion blur.
#pragma once
#include <numbers>

#include "sampling/directions.hpp"
#include "scene/camera.hpp"

namespace texmap {

/// Defocus and motion; the defaults are those of a pinhole.
struct Lens {
  double defocus_degrees = 0;  ///< angle of the cone from the lens to a point in focus; 0: pinhole
  double focus_distance = 10;  ///< from the eye to what is sharp
  double shift = 0;            ///< how far the scene moves up during the exposure

  /// True if rays start elsewhere than at the eye.
  [[nodiscard]] bool blurs() const { return defocus_degrees > 0 || shift != 0; }

  /// The ray of one sample: a random point of the pixel, of the lens and of the exposure.
  ///
  /// @param random  its next_2d() returns two numbers in [0, 1)
  /// @return        its direction has any length
  template <class Real, class Random>
  [[nodiscard]] Ray<Real> ray(const View<Real>& view, const PixelPlace<Real>& at,
                              Random& random) const {
    const auto& in_pixel = random.next_2d();
    Ray<Real> ray = {view.eye, direction_through(view, at.column + (in_pixel.u - Real(0.5)),
                                                 at.row + (in_pixel.v - Real(0.5)))};
    if (defocus_degrees > 0) {
      const auto on_lens = uniform_disk(random.next_2d());
      const double radius = focus_distance * tan(defocus_degrees * std::numbers::pi / 360);
      const Vec3<Real> offset =
          view.right * (on_lens.x * Real(radius)) + view.up * (on_lens.y * Real(radius));
      ray = {ray.origin + offset, ray.direction * Real(focus_distance) - offset};
    }
    // Lowering the eye looks the same as raising the scene.
    if (shift != 0) ray.origin.y = ray.origin.y - Real(shift) * random.next_2d().u;
    return ray;
  }
};

}  // namespace texmap
