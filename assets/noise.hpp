// Smooth noise that is the same on every machine: it uses integer hashes and + - * / only.
#pragma once
#include <cmath>
#include <cstdint>

namespace texmap {

/// A hash of three whole numbers, in [0, 1).
[[nodiscard]] inline double lattice_value(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u;
  h = (h ^ (h >> 15)) + static_cast<std::uint32_t>(y) * 0x85ebca77u;
  h = (h ^ (h >> 13)) * 0xc2b2ae3du + static_cast<std::uint32_t>(z) * 0x27d4eb2fu;
  h = (h ^ (h >> 16)) * 0x165667b1u;
  h ^= h >> 14;
  return static_cast<double>(h >> 8) / 16777216.0;
}

/// From 0 to 1 as t goes from 0 to 1, with slope 0 at both ends, constant outside.
[[nodiscard]] inline double smooth_step(double t) {
  if (t <= 0) return 0;
  if (t >= 1) return 1;
  return t * t * (3 - 2 * t);
}

[[nodiscard]] inline double mix(double a, double b, double t) { return a + (b - a) * t; }

/// Value noise: random values on a lattice with smooth interpolation between them.
///
/// @param x, y, z  below 2^30 in magnitude; the lattice is spaced by 1
/// @return         in [0, 1), with a mean near 0.5
[[nodiscard]] inline double value_noise(double x, double y, double z) {
  const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
  const auto ix = static_cast<std::int32_t>(fx), iy = static_cast<std::int32_t>(fy),
             iz = static_cast<std::int32_t>(fz);
  const double tx = smooth_step(x - fx), ty = smooth_step(y - fy), tz = smooth_step(z - fz);
  const auto along_x = [&](int dy, int dz) {
    return mix(lattice_value(ix, iy + dy, iz + dz), lattice_value(ix + 1, iy + dy, iz + dz), tx);
  };
  return mix(mix(along_x(0, 0), along_x(1, 0), ty), mix(along_x(0, 1), along_x(1, 1), ty), tz);
}

/// A sum of octaves of value noise, each with twice the frequency and half the amplitude.
///
/// @param octaves  1 or more
/// @return         in [-1, 1), with a mean near 0
[[nodiscard]] inline double layered_noise(double x, double y, double z, int octaves) {
  double sum = 0, height = 1, total = 0;
  for (int octave = 0; octave < octaves; ++octave) {
    const double shift = 17.25 * octave;  // else the lattices of all octaves would coincide
    sum += height * (2 * value_noise(x + shift, y - shift, z + shift) - 1);
    total += height;
    height /= 2;
    x *= 2, y *= 2, z *= 2;
  }
  return sum / total;
}

}  // namespace texmap
