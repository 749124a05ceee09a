// The daily exercise's normal map of 23 February 2026 as published: bricks.
#pragma once
#include <cmath>

#include "texture/normal_map.hpp"

namespace texmap::published {

/// The width of the mortar on each side of a brick, in bricks.
inline constexpr double brick_mortar = 0.05;

/// Its normal relative to tangent, bitangent and normal. There are 12 x 6 bricks, each second row
/// moved by half a brick. On the mortar between them, 1 - 0.9^2 = 19 % of the square, it is
/// (0, 0, -1), which points into the globe; on bricks (a, a, 1) made a unit vector,
/// a = sin(20 x) cos(20 y) / 10.
[[nodiscard]] inline Vec3d brick_normal(const Uv<double>& uv) {
  const double row = uv.v * 6;
  const bool odd = std::fmod(std::floor(row), 2) == 1;
  const double column = uv.u * 12 + (odd ? 0.5 : 0);
  const double across = column - std::floor(column);
  const double up = row - std::floor(row);
  if (across < brick_mortar || across > 1 - brick_mortar || up < brick_mortar ||
      up > 1 - brick_mortar)
    return {0, 0, -1};
  const double lean = sin(across * 20) * cos(up * 20) * 0.1;
  return normalize(Vec3d{lean, lean, 1});
}

/// Its tangent +y x normal (+x x normal within 2.6 degrees of a pole); bitangent normal x tangent.
/// With the exercise's (u, v) they are along -dP/du and -dP/dv.
[[nodiscard]] inline TangentFrame<double> brick_tangents(const Vec3d& normal) {
  const Vec3d axis = std::abs(normal.y) > 0.999 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d tangent = normalize(cross(axis, normal));
  return {tangent, cross(normal, tangent)};
}

}  // namespace texmap::published
