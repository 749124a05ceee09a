// Colors of a picture that is being painted: real numbers, rounded once at the end.
#pragma once
#include <algorithm>
#include <cstdint>

#include "noise.hpp"
#include "texture/image.hpp"

namespace texmap {

/// Red, green and blue, 0 to 255, not yet rounded.
struct Paint {
  double r = 0, g = 0, b = 0;
};

[[nodiscard]] inline Paint mix(Paint a, Paint b, double t) {
  return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t)};
}

[[nodiscard]] inline Paint scaled(Paint p, double factor) {
  return {p.r * factor, p.g * factor, p.b * factor};
}

[[nodiscard]] inline Paint paint_of(Rgb8 c) {
  return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)};
}

/// The nearest color of 8 bits a channel.
[[nodiscard]] inline Rgb8 rounded(Paint p) {
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
  };
  return {byte(p.r), byte(p.g), byte(p.b)};
}

}  // namespace texmap
