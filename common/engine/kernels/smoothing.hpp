// Limits on how far a pixel's content may be smoothed.
#pragma once

namespace texmap {

/// Limits on the error estimates of a PixelProbe; zeros switch smoothing off.
struct Smoothing {
  double most_curvature_error = 0;  ///< for places from a polynomial of degree 2
  double most_normal_error = 0;     ///< for directions from a polynomial of degree 1

  // The largest errors that follow, in units of the estimates; a test holds them.
  static constexpr double turns_per_curvature_error = 0.03;       ///< in longitude
  static constexpr double half_turns_per_curvature_error = 0.05;  ///< in latitude
  static constexpr double normal_per_normal_error = 0.9;          ///< in a normal's coordinate
  static constexpr double direction_per_normal_error = 1.4;  ///< in a cosine_direction's coordinate
};

}  // namespace texmap
