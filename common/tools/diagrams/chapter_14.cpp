// The computed diagram of chapter 14: steps near the pole.
#include <cmath>
#include <numbers>
#include <string>

#include "diagrams.hpp"

namespace texmap::diagrams {
namespace {

/// Equal steps of y and of x on a circle near the pole.
Drawing pole_steps() {
  Drawing d("pole_steps", 640, 300, "Steps of y and of x near the pole",
            "Twice the top of a circle. Left: heights y in equal steps; near the pole the places "
            "on the circle are far apart. Right: distances x from the axis in the same steps; near "
            "the pole the places are close together.");
  const double radius = 150, step = 0.05;
  const auto panel = [&](Spot center, const std::string& words) {
    std::vector<Spot> through;
    for (int i = 0; i <= 96; ++i) {
      const double angle = std::numbers::pi * i / 96;
      through.push_back(center + Spot{std::cos(angle), -std::sin(angle)} * radius);
    }
    d.line(center - Spot{0, -8}, center - Spot{0, radius + 22}, "soft dashed");
    d.curve(through, "ink");
    d.text(center - Spot{0, radius + 30}, "pole", Anchor::middle, "small");
    d.text(center + Spot{0, 62}, words, Anchor::middle, "small");
  };
  const Spot left{165, 220}, right{475, 220};
  panel(left, "the angle from y: steps grow at the pole");
  panel(right, "the angle from x: steps stay equal");
  for (int k = 0; k <= 6; ++k) {
    const double y = 1 - k * step, x = k * step;
    const double wide = std::sqrt(1 - y * y), above = std::sqrt(1 - x * x);
    const Spot by_height = left + Spot{wide, -y} * radius;
    d.line({left.x, by_height.y}, by_height, "red");
    d.dot(by_height, "fill-red");
    d.mark("y " + std::to_string(k), by_height);
    const Spot by_width = right + Spot{x, -above} * radius;
    d.line({by_width.x, right.y}, by_width, "blue");
    d.dot(by_width, "fill-blue");
    d.mark("x " + std::to_string(k), by_width);
  }
  d.mark("left", left);
  d.mark("right", right);
  d.text(left + Spot{-10, -0.85 * radius + 5}, "y", Anchor::end, "red");
  d.text(right + Spot{0.15 * radius, 22}, "x", Anchor::middle, "blue");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_14() { return {pole_steps()}; }

}  // namespace texmap::diagrams
