// Noise in space: a number for each point that changes smoothly and has no pattern.
#pragma once
#include "math/vec3.hpp"
#include "sampling/hash.hpp"

namespace texmap {

/// From 0 to 1 as x goes from 0 to 1, with slope 0 at both ends.
template <class Real>
[[nodiscard]] Real smooth_step(const Real& x) {
  return x * x * (Real(3) - Real(2) * x);
}

namespace noise {

inline constexpr std::uint32_t period = 1024;  // ten bits for each of x, y and z

/// The number of a cell in its period, for a whole number; 0 for NaN.
template <class Real>
[[nodiscard]] UInt<Real> cell_number(const Real& cell) {
  const Real all = Real(period);
  return uint_from_real(clamp(cell - all * floor(cell / all), Real(0), all - Real(1)));
}

/// A random vector, the same for equal keys: each part is one of 1024 numbers between -1 and 1.
template <class Real>
[[nodiscard]] Vec3<Real> slope(const UInt<Real>& key) {
  const UInt<Real> bits = hash_bits(UInt<Real>(key + 0x9e3779b9U));
  const auto part = [&bits](int shift) {
    const Real number = real_from_uint<Real>(UInt<Real>((bits >> shift) & (period - 1)));
    return (number - Real(511.5)) * Real(1.0 / 512);  // exact
  };
  return {part(0), part(10), part(20)};
}

}  // namespace noise

/// Gradient noise. Each corner of a lattice of unit cubes has a random vector, the slope of a
/// linear function that is 0 in the corner. A point mixes those of the 8 corners around it.
///
/// @return  between -1 and 1; 0 at corners; repeats after 1024 in x, in y and in z
/// Bound: 3 unit roundoffs.
/// Source: Perlin, "An Image Synthesizer" (1985).
template <class Real>
[[nodiscard]] Real gradient_noise(const Vec3<Real>& p) {
  const Vec3<Real> corner{floor(p.x), floor(p.y), floor(p.z)};
  const Vec3<Real> inside = p - corner;
  const Vec3<Real> far{smooth_step(inside.x), smooth_step(inside.y), smooth_step(inside.z)};
  const UInt<Real> column = noise::cell_number(corner.x);
  const UInt<Real> row = noise::cell_number(corner.y);
  const UInt<Real> layer = noise::cell_number(corner.z);
  Real sum(0);
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t x = i & 1U, y = i >> 1 & 1U, z = i >> 2;
    const auto key = [](const UInt<Real>& cell, int shift) {
      return UInt<Real>((cell & (noise::period - 1)) << shift);
    };
    const UInt<Real> place = key(column + x, 0) | key(row + y, 10) | key(layer + z, 20);
    const auto weight = [](std::uint32_t end, const Real& t) { return end == 1 ? t : Real(1) - t; };
    sum = sum + weight(x, far.x) * weight(y, far.y) * weight(z, far.z) *
                    dot(noise::slope<Real>(place), inside - Vec3<Real>{Real(x), Real(y), Real(z)});
  }
  return sum * (Real(2) / Real(3));  // the sum is at most 3/2, in a cube's middle
}

/// Noise of several sizes: each octave is half as large and half as strong as the one before, and
/// moved by 1/2, so that they are not 0 at the same points.
///
/// @param octaves  1 to 16
/// @return  between -2 and 2
template <class Real>
[[nodiscard]] Real fractal_noise(Vec3<Real> p, int octaves) {
  Real sum(0), strength(1);
  for (int octave = 0; octave < octaves; ++octave) {
    sum = sum + strength * gradient_noise(p);
    strength = strength * Real(0.5);
    p = p * Real(2) + Vec3<Real>{Real(0.5), Real(0.5), Real(0.5)};
  }
  return sum;
}

}  // namespace texmap
