// The lecture's way to blend two bytes, as its slides have it: for comparing with `mix`.
#pragma once

namespace texmap::seeds {

/// Seed 4: (int)(a t + b (1 - t)) of two bytes, cut off. A byte blended with itself does not always stay itself.
///
/// @param a, b  0 to 255
/// @param t     weight of `a`, 0 to 1
[[nodiscard]] inline int blend_lecture(int a, int b, double t) { return static_cast<int>(a * t + b * (1 - t)); }

}  // namespace texmap::seeds
