// The diagrams of chapter 06: the mirrored direction, and powers of the cosine.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "diagrams.hpp"
#include "scene/phong.hpp"

namespace texmap::diagrams {
namespace {

/// Unit vector in the plane of the drawing, y up; degrees from the normal, to the right.
Vec3d from_normal(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::sin(angle), std::cos(angle), 0};
}

/// Left: the two components of l, and r made from them. Right: n, l, r, e and the angle.
Drawing mirror_vector() {
  Drawing d("mirror_vector", 680, 230, "The mirrored direction",
            "Left: the direction l to the lamp is the sum of a part along the normal n and a part "
            "along the surface. The mirrored direction r has the same part along n and the "
            "opposite part along the surface. Right: l and r make the same angle theta with "
            "n, and the direction e to the eye makes an angle alpha with r.");
  const double size = 150;
  const Vec3d n{0, 1, 0};
  const Vec3d l = from_normal(50);
  const Vec3d r = mirror(l, n);
  const auto place = [&](Spot foot, const Vec3d& p) { return foot + Spot{p.x, -p.y} * size; };

  const Spot a{180, 180};
  const Vec3d along = n * dot(n, l);
  d.line(a + Spot{-150, 0}, a + Spot{150, 0}, "ink");
  d.line(place(a, along), place(a, l), "green thick");
  d.line(place(a, along), place(a, r), "green thick dashed");
  d.arrow(a, place(a, n), "ink");
  d.line(a, place(a, along), "blue thick");
  d.arrow(a, place(a, l), "red");
  d.arrow(a, place(a, r), "red");
  d.text(place(a, n) + Spot{10, 8}, "n", Anchor::start);
  d.text(place(a, l) + Spot{8, 2}, "l", Anchor::start, "red strong");
  d.text(place(a, r) + Spot{-8, 2}, "r", Anchor::end, "red strong");
  d.text(place(a, along * 0.7) + Spot{-8, 0}, "(n·l) n", Anchor::end, "blue small");
  d.text(place(a, (along + l) * 0.5) + Spot{4, -10}, "l - (n·l) n", Anchor::middle, "green small");
  d.text(place(a, (along + r) * 0.5) + Spot{-4, -10}, "the opposite", Anchor::middle,
         "green small");
  d.text(a + Spot{0, 26}, "r = (n·l) n - (l - (n·l) n)", Anchor::middle);

  const Spot b{510, 180};
  const Vec3d e = from_normal(-24);
  d.line(b + Spot{-150, 0}, b + Spot{150, 0}, "ink");
  d.arrow(b, place(b, n), "ink");
  d.arrow(b, place(b, l), "red");
  d.arrow(b, place(b, r), "red");
  d.arrow(b, place(b, e), "blue");
  d.arc(b, 66, 40, 140, "soft");
  d.arc(b, 112, 114, 140, "green thick");
  d.text(place(b, n) + Spot{10, 8}, "n", Anchor::start);
  d.text(place(b, l) + Spot{0, -10}, "l, to the lamp", Anchor::middle, "red");
  d.text(place(b, r) + Spot{-8, 2}, "r", Anchor::end, "red strong");
  d.text(place(b, e) + Spot{-2, -8}, "e, to the eye", Anchor::end, "blue");
  for (const double degrees : {65.0, 127.0})
    d.text(place(b, from_normal(90 - degrees) * 0.32) + Spot{0, 5}, "θ", Anchor::middle, "small");
  d.text(b + Spot{-62, -72}, "α", Anchor::middle, "green strong");
  d.text(b + Spot{0, 26}, "cos α = r·e", Anchor::middle);
  for (const auto& [name, p] : {std::pair{"n", n}, {"l", l}, {"r", r}, {"e", e}}) {
    d.mark(name, place(b, p));
  }
  d.mark("foot", b);
  return d;
}

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

std::vector<Drawing> diagrams_of_06() { return {mirror_vector(), phong_power()}; }

}  // namespace texmap::diagrams
