// The computed diagrams of chapter 07: sampling patterns, the sRGB curve.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "diagrams.hpp"
#include "math/srgb.hpp"
#include "sampling/samplers.hpp"

namespace texmap::diagrams {
namespace {

/// The 16 samples of one pixel, in four patterns.
Drawing sampler_patterns() {
  Drawing d{"sampler_patterns", 720, 250, "16 samples of a pixel in four patterns",
            "Four squares, each a pixel with 16 dots and a grid of 4 by 4 cells. Random: some "
            "cells have no dot, others two or three. Stratified: each cell has one dot. "
            "Multi-jitter: each of the faint 16 columns and 16 rows has one dot, too. Sobol: also "
            "each cell of the grids of 2 by 8 and 8 by 2."};
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
      d.dot(corner + Spot{at.u, at.v} * size, "fill-blue");
    }
    d.text(corner + Spot{size / 2, size + 24}, pattern.name, Anchor::middle, "strong");
    d.text(corner + Spot{size / 2, size + 44}, pattern.rule, Anchor::middle, "small");
    d.text(corner + Spot{size / 2, size + 62}, pattern.more, Anchor::middle, "small");
    left += 178;
  }
  return d;
}

/// From a byte of a file to light, and what the mean of black and white is.
Drawing srgb_curve() {
  Drawing d{"srgb_curve", 640, 330, "From bytes to light",
            "A curve over bytes from 0 to 255. The light rises slowly at first: byte 128 has 0.216 "
            "of the light of byte 255, and half of the light belongs to byte 188."};
  const auto place = [](double byte, double light) {
    return Spot{90 + 440 * byte / 255, 30 + 230 * (1 - light)};
  };
  std::vector<Spot> through;
  for (int byte = 0; byte <= 255; ++byte) through.push_back(place(byte, srgb_decode(byte / 255.0)));
  d.line(place(0, 0), place(255, 0));
  d.line(place(0, 0), place(0, 1));
  d.line(place(0, 0), place(255, 1), "soft dashed");
  d.text(place(192, 0.8), "if bytes were light", Anchor::end, "small");
  const auto follow = [&](double byte, const std::string& style) {
    const double light = srgb_decode(byte / 255.0);
    d.line(place(byte, 0), place(byte, light), style + " dashed");
    d.line(place(byte, light), place(0, light), style + " dashed");
    d.dot(place(byte, light), "fill-" + style);
  };
  const double half = 255 * srgb_encode(0.5);
  follow(128, "red");
  follow(half, "green");
  d.curve(through, "blue thick");
  const auto label_x = [&](double byte, const char* words, const char* style) {
    d.text(place(byte, 0) + Spot{0, 22}, words, Anchor::middle, style);
  };
  label_x(0, "0", "small");
  label_x(128, "128", "red");
  label_x(half, "188", "green");
  label_x(255, "255", "small");
  const auto label_y = [&](double light, const char* words, const char* style) {
    d.text(place(0, light) + Spot{-10, 5}, words, Anchor::end, style);
  };
  label_y(0, "0", "small");
  label_y(srgb_decode(128 / 255.0), "0.216", "red");
  label_y(0.5, "0.5", "green");
  label_y(1, "1", "small");
  d.text(place(128, 0) + Spot{0, 50}, "byte in the file", Anchor::middle, "small");
  d.text(place(0, 1) + Spot{0, -12}, "light", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_07() { return {sampler_patterns(), srgb_curve()}; }

}  // namespace texmap::diagrams
