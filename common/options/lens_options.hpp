// The options of a camera with a lens and an exposure, and of the sky over it.
#pragma once
#include "camera.hpp"
#include "command_line.hpp"
#include "directions.hpp"

namespace texmap {

/// What only some pictures need: blur by defocus and by motion, a sky with a gradient. What is not asked for costs nothing.
struct LensOptions {
  double defocus_degrees = 0;  ///< angle of the cone of rays that meet in a point in focus; 0 for a pinhole
  double focus_distance = 10;  ///< from the eye to what is sharp
  double shift = 0;            ///< how far the scene moves up during the exposure
  bool gradient = false;

  void declare(CommandLine& line) {
    line.decimal("--defocus", defocus_degrees, 0, 90, "angle of the cone of rays through a lens, in degrees");
    line.decimal("--focus", focus_distance, 0.001, 1e6, "distance of what a lens draws sharp; the globe's front is at 10");
    line.decimal("--shift", shift, -100, 100, "the globe moves up by so much during the exposure");
    line.choice<bool>("--sky", gradient, {{"constant", false}, {"gradient", true}},
                      "alike everywhere, or white below and blue above");
  }

  /// True if rays start elsewhere than at the eye.
  [[nodiscard]] bool blurs() const { return defocus_degrees > 0 || shift != 0; }

  /// The ray of one sample of a pixel: anywhere in the pixel, on the lens and in the exposure, as far as there are any.
  ///
  /// @return  any length of direction: 1 along the view
  template <class Real, class Numbers>
  [[nodiscard]] Ray<Real> ray(const ViewIn<Real>& view, const Real& column, const Real& row, Numbers& numbers) const {
    const auto& in_pixel = numbers.pair();
    Ray<Real> ray = {view.eye, direction_through(view, column + (in_pixel.u - Real(0.5)), row + (in_pixel.v - Real(0.5)))};
    if (defocus_degrees > 0) {
      const auto on_lens = uniform_disk(numbers.pair());
      const double radius = focus_distance * std::tan(defocus_degrees * std::numbers::pi / 360);
      const Vec3<Real> offset = view.right * (on_lens.x * Real(radius)) + view.up * (on_lens.y * Real(radius));
      ray = {ray.origin + offset, ray.direction * Real(focus_distance) - offset};
    }
    // A globe that moves up and an eye that moves down see the same.
    if (shift != 0) ray.origin.y = ray.origin.y - Real(shift) * numbers.pair().u;
    return ray;
  }
};

}  // namespace texmap
