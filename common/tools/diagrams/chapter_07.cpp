// The diagrams of chapter 07: sampling patterns, cosine and chance, the sRGB curve.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "diagrams.hpp"
#include "math/srgb.hpp"
#include "sampling/samplers.hpp"

namespace texmap::diagrams {
namespace {

/// A name for one of several marks: "sobol 3".
std::string numbered(std::string name, std::uint32_t i) {
  name += ' ';
  name += std::to_string(i);
  return name;
}

/// The 16 samples of one pixel, in four patterns.
Drawing sampler_patterns() {
  Drawing d("sampler_patterns", 720, 250, "16 samples of a pixel in four patterns",
            "Four squares, each a pixel with 16 dots and a grid of 4 by 4 cells. Random: some "
            "cells have no dot, others two or three. Stratified: each cell has one dot. "
            "Multi-jitter: each of the faint 16 columns and 16 rows has one dot, too. Sobol: also "
            "each cell of the grids of 2 by 8 and 8 by 2.");
  const double size = 150, top = 20;
  struct Pattern {
    SamplerKind kind;
    const char* name;
    const char* rule;
    const char* more;
  };
  const std::array patterns{
      Pattern{SamplerKind::random, "random", "each by itself", ""},
      Pattern{SamplerKind::stratified, "stratified", "one in each cell", ""},
      Pattern{SamplerKind::multi_jitter, "multi-jitter", "also one in each of",
              "16 columns and 16 rows"},
      Pattern{SamplerKind::sobol, "sobol", "also one in each cell", "of 2 × 8, 8 × 2, …"},
  };
  const auto pixel = hash_pixels<double>(std::uint32_t{7}, std::uint32_t{3});
  double left = 18;
  for (const Pattern& pattern : patterns) {
    const Spot corner{left, top};
    for (int i = 1; i < 4; ++i) {
      d.line(corner + Spot{size * i / 4, 0}, corner + Spot{size * i / 4, size}, "soft");
      d.line(corner + Spot{0, size * i / 4}, corner + Spot{size, size * i / 4}, "soft");
    }
    for (int i = 1; i < 16 && pattern.kind == SamplerKind::multi_jitter; ++i) {
      const double at = size * i / 16 - 0.5;  // faint lines: thin areas
      d.rectangle(corner + Spot{at, 0}, 1, size, "fill-soft");
      d.rectangle(corner + Spot{0, at}, size, 1, "fill-soft");
    }
    d.rectangle(corner, size, size, "ink");
    const Sampler sampler(pattern.kind, 16);
    for (std::uint32_t i = 0; i < 16; ++i) {
      const Point2<double> at = sampler.pair<double>(pixel, i, 0);
      const Spot spot = corner + Spot{at.u, at.v} * size;
      d.dot(spot, "fill-blue");
      d.mark(numbered(pattern.name, i), Spot{at.u, at.v});
    }
    d.text(corner + Spot{size / 2, size + 24}, pattern.name, Anchor::middle, "strong");
    d.text(corner + Spot{size / 2, size + 44}, pattern.rule, Anchor::middle, "small");
    d.text(corner + Spot{size / 2, size + 62}, pattern.more, Anchor::middle, "small");
    left += 178;
  }
  return d;
}

/// Left: all directions are equally likely and count with the cosine. Right: the chance has it.
Drawing cosine_and_chance() {
  Drawing d("cosine_and_chance", 680, 270, "Cosine and chance",
            "Left: directions in equal steps of the angle; each arrow is as long as the cosine of "
            "its angle to the normal, and the tips lie on a circle. Right: directions lifted from "
            "equal steps on the ground to a half circle; near the normal they are dense, and all "
            "arrows have the same length.");
  const double radius = 150;
  const std::uint32_t count = 13;
  const Spot a{175, 200}, b{505, 200};
  for (const Spot& foot : {a, b}) {
    d.line(foot + Spot{-160, 0}, foot + Spot{160, 0}, "ink");
    d.arc(foot, radius, 0, 180, "soft");
  }
  d.circle(a + Spot{0, -radius / 2}, radius / 2, "soft dashed");
  for (std::uint32_t i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    const double angle = (share - 0.5) * std::numbers::pi;
    const Spot tip = a + Spot{std::sin(angle), -std::cos(angle)} * (radius * std::cos(angle));
    if (std::cos(angle) > 0.2) {
      d.arrow(a, tip, "blue");
    } else {
      d.line(a, tip, "blue");  // too short for a head
    }
    d.mark(numbered("weighted", i), tip - a);
    const double x = 2 * share - 1;
    const Spot on_circle = b + Spot{x, -std::sqrt(1 - x * x)} * radius;
    d.line(b + Spot{x * radius, 0}, on_circle, "soft dashed");
    d.arrow(b, on_circle, "blue");
    d.dot(b + Spot{x * radius, 0}, "fill-ink");
    d.mark(numbered("chosen", i), on_circle - b);
  }
  d.text(a + Spot{0, -radius - 14}, "n", Anchor::middle);
  d.text(b + Spot{0, -radius - 14}, "n", Anchor::middle);
  d.text(a + Spot{0, 28}, "all directions with the same chance:", Anchor::middle, "small");
  d.text(a + Spot{0, 48}, "each counts as much as its cosine", Anchor::middle, "small");
  d.text(b + Spot{0, 28}, "the chance has the cosine:", Anchor::middle, "small");
  d.text(b + Spot{0, 48}, "each direction counts the same", Anchor::middle, "small");
  return d;
}

/// From a byte of a file to light, and what the mean of black and white is.
Drawing srgb_curve() {
  Drawing d("srgb_curve", 640, 330, "From bytes to light",
            "A curve over bytes from 0 to 255. The light rises slowly at first: byte 128 has 0.216 "
            "of the light of byte 255, and half of the light belongs to byte 188.");
  const Chart place{{90, 30}, 440, 230, 255};
  std::vector<Spot> through;
  for (int byte = 0; byte <= 255; ++byte) through.push_back(place(byte, srgb_decode(byte / 255.0)));
  place.draw_axes(d);
  d.line(place(0, 0), place(255, 1), "soft dashed");
  d.text(place(192, 0.8), "if bytes were light", Anchor::end, "small");
  const auto follow = [&](double byte, const std::string& style, const char* name) {
    const double light = srgb_decode(byte / 255.0);
    d.line(place(byte, 0), place(byte, light), style + " dashed");
    d.line(place(byte, light), place(0, light), style + " dashed");
    d.dot(place(byte, light), "fill-" + style);
    d.mark(name, place(byte, light));
  };
  const double half = 255 * srgb_encode(0.5);
  follow(128, "red", "128");
  follow(half, "green", "half");
  d.curve(through, "blue thick");
  place.label_x(d, 0, "0");
  place.label_x(d, 128, "128", "red");
  place.label_x(d, half, "188", "green");
  place.label_x(d, 255, "255");
  place.label_y(d, 0, "0");
  place.label_y(d, srgb_decode(128 / 255.0), "0.216", "red");
  place.label_y(d, 0.5, "0.5", "green");
  place.label_y(d, 1, "1");
  d.text(place(128, 0) + Spot{0, 50}, "byte in the file", Anchor::middle, "small");
  d.text(place(0, 1) + Spot{0, -12}, "light", Anchor::middle, "small");
  d.mark("origin", place(0, 0));
  d.mark("white", place(255, 1));
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_07() {
  return {sampler_patterns(), cosine_and_chance(), srgb_curve()};
}

}  // namespace texmap::diagrams
