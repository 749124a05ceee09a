// The diagrams of chapter 06: powers of the cosine.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "diagrams.hpp"
#include "scene/phong.hpp"

namespace texmap::diagrams {
namespace {

/// cos^s over the angle, for four exponents.
Drawing phong_power() {
  Drawing d("phong_power", 640, 300, "Powers of the cosine",
            "Four curves over the angle alpha from 0 to 90 degrees: the cosine to the power s = 1, "
            "5, 50 and 500. All begin at 1. The larger s, the faster they fall to 0.");
  const Chart place{{70, 40}, 500, 200, 90};
  const auto value = [](double degrees, double exponent) {
    return std::pow(std::max(0.0, std::cos(degrees * std::numbers::pi / 180)), exponent);
  };
  d.line(place(0, 0.5), place(64, 0.5), "soft");
  for (int degrees = 0; degrees <= 90; degrees += 15) {
    const Spot tick = place(degrees, 0);
    d.line(tick, tick + Spot{0, 6}, "ink");
    place.label_x(d, degrees, std::to_string(degrees) + "°");
  }
  place.draw_axes(d);
  d.text(place(0, 1) + Spot{-20, -16}, "cosine to the power s", Anchor::start, "small");
  place.label_y(d, 1, "1");
  place.label_y(d, 0.5, "1/2");
  place.label_y(d, 0, "0");
  d.text(place(45, 0) + Spot{0, 48}, "angle α between the mirrored direction and the eye",
         Anchor::middle, "small");
  struct Power {
    int exponent;
    const char* color;
    const char* words;
  };
  const std::array powers{Power{1, "ink", "s = 1"}, Power{5, "blue", "s = 5"},
                          Power{50, "green", "s = 50"}, Power{500, "red", "s = 500"}};
  Spot label = place(72, 0.93);
  for (const Power& power : powers) {
    std::vector<Spot> through;
    for (int step = 0; step <= 360; ++step)
      through.push_back(place(step / 4.0, value(step / 4.0, power.exponent)));
    const std::string style = power.color;
    d.curve(through, style + " thick");
    d.line(label, label + Spot{30, 0}, style + " thick");
    d.text(label + Spot{40, 5}, power.words, Anchor::start, power.exponent == 1 ? "plain" : style);
    label.y += 22;
    // Where the power has fallen to half.
    const double half = std::acos(std::pow(0.5, 1.0 / power.exponent)) * 180 / std::numbers::pi;
    std::string name = "half at ";
    name += std::to_string(power.exponent);
    d.mark(name, place(half, 0.5));
  }
  d.mark("0 degrees", place(0, 0.5));
  d.mark("90 degrees", place(90, 0.5));
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_06() { return {phong_power()}; }

}  // namespace texmap::diagrams
