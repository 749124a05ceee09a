// A sphere seen from above its north pole, and arrows along curves.
#pragma once
#include <vector>

#include "drawing.hpp"

namespace texmap::diagrams {

/// Where a point is drawn by a viewer above the north pole: x to the right, z down. Eastward is
/// then against the clock.
[[nodiscard]] inline Spot from_above(const Vec3d& p, Spot center, double scale) {
  return center + Spot{p.x, p.z} * scale;
}

/// Draws a curve with an arrow's head at its end.
///
/// @param spot_at  called with numbers from `from` to `to`; returns a Spot
template <class Curve>
void curved_arrow(Drawing& drawing, const Curve& spot_at, double from, double to,
                  const std::string& style) {
  const int pieces = 64;
  std::vector<Spot> through;
  for (int i = 0; i <= pieces; ++i) through.push_back(spot_at(from + (to - from) * i / pieces));
  const Spot tip = through.back();
  // The line ends inside the head, which is 9 long.
  while (through.size() > 2) {
    const Spot rest = tip - through.back();
    if (rest.x * rest.x + rest.y * rest.y >= 81) break;
    through.pop_back();
  }
  drawing.curve(through, style);
  const Spot along = tip - through.back();
  drawing.arrow(tip - along * 1.01, tip, style);
}

}  // namespace texmap::diagrams
