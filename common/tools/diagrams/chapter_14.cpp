// The diagrams of chapter 14: floats on a line, a far sphere, the pole, a shadow ray's start.
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "diagrams.hpp"

namespace texmap::diagrams {
namespace {

/// Numbers with three binary digits: four between each power of two and the next.
Drawing floats_on_a_line() {
  Drawing d("floats_on_a_line", 640, 150, "Numbers with three binary digits",
            "A number line from 0 to 8. From 1 to 2 a number with three binary digits lies at "
            "every quarter, from 2 to 4 at every half, from 4 to 8 at every whole number.");
  const Spot zero{40, 90};
  const double unit = 69;
  const auto at = [&](double x) { return zero + Spot{x * unit, 0}; };
  d.arrow(at(0), at(8.4));
  d.line(at(0) + Spot{0, -6}, at(0) + Spot{0, 6});
  d.text(at(0) + Spot{0, 28}, "0");
  for (int power = 0; power < 3; ++power) {
    const double first = std::ldexp(1.0, power);
    for (int k = 0; k < 4; ++k) {
      const double x = first * (1 + k / 4.0);
      const double half = k == 0 ? 14 : 8;
      d.line(at(x) + Spot{0, -half}, at(x) + Spot{0, half}, k == 0 ? "blue thick" : "blue");
      d.mark(std::to_string(power) + " " + std::to_string(k), at(x));
    }
    d.text(at(first) + Spot{0, 32}, std::to_string(1 << power));
    const std::array<const char*, 3> steps{"1/4 apart", "1/2 apart", "1 apart"};
    d.text(at(first * 1.5) + Spot{0, -28}, steps.at(static_cast<std::size_t>(power)),
           Anchor::middle, "blue small");
  }
  d.line(at(8) + Spot{0, -14}, at(8) + Spot{0, 14}, "blue thick");
  d.text(at(8) + Spot{0, 32}, "8");
  return d;
}

/// A far sphere: b^2 and a c are nearly equal, h and r are not.
Drawing far_sphere() {
  Drawing d("far_sphere", 640, 330, "A sphere from 1,000 radii away",
            "Above: the eye far to the left, 1,000 radii from a sphere; a ray passes the center at "
            "the distance h = 0.8 r. Below: on the line of floats, b squared and a c are less than "
            "six steps apart, and b squared lies between two floats.");
  const Spot center{530, 100};
  const double r = 60, h = 0.8;
  const Spot eye{40, 100};
  d.circle(center, r, "fill-soft");
  d.circle(center, r, "ink");
  // The drawing is not to scale along the way, which is broken in the middle.
  const double way = center.x - eye.x, sine = h * r / way, cosine = std::sqrt(1 - sine * sine);
  const auto along = [&](double length) { return eye + Spot{cosine, -sine} * length; };
  const Spot passing = along(way * cosine);
  d.line(eye, {250, eye.y}, "soft dashed");
  d.line({285, eye.y}, center, "soft dashed");
  d.line(eye, along(210), "red");
  d.arrow(along(245), along(580), "red");
  d.line(center, passing, "blue thick");
  const double angle = -0.35;
  const Spot rim = center + Spot{std::cos(angle), -std::sin(angle)} * r;
  d.line(center, rim, "green thick");
  d.dot(eye);
  d.dot(center);
  d.mark("h", passing);
  d.mark("r", rim);
  d.mark("center", center);
  d.text(eye + Spot{-4, -12}, "eye", Anchor::start);
  d.text(center + Spot{-8, -20}, "h", Anchor::end, "blue");
  d.text(center + Spot{22, 24}, "r", Anchor::start, "green");
  d.text({267, 128}, "D = 1,000 r", Anchor::middle, "small");
  d.text(along(150) + Spot{0, -10}, "b", Anchor::middle, "red");

  // Floats between 2^19 and 2^20 are 2^-4 apart.
  const double step = std::ldexp(1.0, 19 - 23);
  const double ac = 1000.0 * 1000 - 1, bb = 1000.0 * 1000 - h * h;
  const double unit = 800;
  const auto on_line = [&](double x) { return Spot{140 + (x - ac) * unit, 250}; };
  d.line(on_line(ac - 1.5 * step), on_line(ac + 8.5 * step));
  for (int k = -1; k <= 8; ++k) {
    const Spot tick = on_line(ac + k * step);
    d.line(tick + Spot{0, -7}, tick + Spot{0, 7}, "ink");
    d.mark("float " + std::to_string(k), tick);
  }
  d.dot(on_line(ac), "fill-green");
  d.dot(on_line(bb), "fill-red");
  d.mark("a c", on_line(ac));
  d.mark("b b", on_line(bb));
  d.text(on_line(ac) + Spot{0, -16}, "a c = 999,999", Anchor::middle, "green small");
  d.text(on_line(bb) + Spot{0, -16}, "b² = 999,999.36", Anchor::middle, "red small");
  d.text(on_line(ac + 2.9 * step) + Spot{0, 32}, "the floats there are 1/16 apart", Anchor::middle,
         "small");
  d.text({320, 318}, "the first six digits cancel; 0.36 remains", Anchor::middle, "small");
  return d;
}

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

/// A hit that rounding moves below the surface, and one that a bound lifts.
Drawing shadow_start() {
  Drawing d("shadow_start", 640, 270, "Where a shadow ray starts",
            "A grid of dots is the points that the number has. A sloping surface runs between "
            "them. The exact hit on the surface rounds to the nearest dot, which lies below the "
            "surface; a shadow ray from there meets the surface at once. A start that is lifted "
            "off the surface by a bound does not.");
  const double cell = 40;
  const Spot corner{40, 30};
  for (int row = 0; row <= 5; ++row) {
    for (int column = 0; column <= 14; ++column)
      d.circle(corner + Spot{column * cell, row * cell}, 1.5, "soft");
  }
  const auto surface = [&](double x) { return Spot{x, 196 - 0.14 * (x - 40)}; };
  d.area({surface(30), surface(610), {610, 240}, {30, 240}}, "fill-soft");
  d.line(surface(30), surface(610), "ink thick");
  const auto start = [&](double x, bool lifted) {
    const Spot hit = surface(x);
    Spot from = corner + Spot{std::round((hit.x - corner.x) / cell) * cell,
                              std::round((hit.y - corner.y) / cell) * cell};
    if (lifted) from = from - Spot{0, cell};
    const std::string color = lifted ? "green" : "red";
    d.arrow(from, from + Spot{90, lifted ? -75.0 : -95.0}, color);
    d.dot(hit, "fill-ink");
    d.text(hit + Spot{-8, -8}, "hit", Anchor::end, "small");
    d.dot(from, "fill-" + color);
    d.mark(lifted ? "lifted" : "rounded", from);
    d.mark(lifted ? "hit 2" : "hit 1", hit);
    return from;
  };
  const Spot below = start(145, false);
  const Spot above = start(425, true);
  d.mark("surface 1", surface(below.x));
  d.mark("surface 2", surface(above.x));
  d.text(below + Spot{12, 20}, "rounded hit: below the surface", Anchor::start, "red small");
  d.text(below + Spot{44, -70}, "meets the surface: acne", Anchor::end, "red small");
  d.text(above + Spot{-10, -12}, "lifted by a bound", Anchor::end, "green small");
  d.text({320, 262}, "dots: the points that the number has", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_14() {
  return {floats_on_a_line(), far_sphere(), pole_steps(), shadow_start()};
}

}  // namespace texmap::diagrams
