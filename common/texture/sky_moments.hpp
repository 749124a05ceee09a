// A sky as nine numbers a channel: enough for the light of matte surfaces.
#pragma once
#include <array>
#include <numbers>

#include "math/vec3.hpp"
#include "texture/environment.hpp"

namespace texmap {

/// The sums of a sky's light over all directions (x, y, z), weighted by 1, x, y, z, xx, yy, xy, yz
/// and xz. They are the nine coefficients of spherical harmonics up to degree 2, in another basis.
/// Source: Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps"
/// (2001). Texels are integrated exactly, as if each had one color.
class SkyMoments {
 public:
  SkyMoments() = default;
  explicit SkyMoments(const Environment& sky) {
    const LightImage& map = sky.map();
    const double wide = 2 * std::numbers::pi / map.width;
    for (int row = 0; row < map.height; ++row) {
      // Light summed along the row, weighted by 1, cos, sin, cos 2 and sin 2 of the longitude.
      std::array<Rgb, 5> around{};
      for (int column = 0; column < map.width; ++column) {
        const double turn = std::numbers::pi - wide * (column + 0.5);
        const double once = 2 * sin(wide / 2);
        const double twice = sin(wide);
        const std::array weights = {wide, once * cos(turn), once * sin(turn), twice * cos(2 * turn),
                                    twice * sin(2 * turn)};
        const auto light = number_cast<double>(map.at(column, row));
        for (std::size_t k = 0; k < 5; ++k) around[k] = around[k] + light * weights[k];
      }
      add_row(around, std::numbers::pi * row / map.height,
              std::numbers::pi * (row + 1) / map.height);
    }
  }

  /// The light that a white matte surface sends out: irradiance / pi, without shadows. Under
  /// contrasts it may be below 0; such light is 0 here.
  ///
  /// @param normal  a unit vector of the picture (see Environment::to_map)
  /// Of a lamp at an angle t: 1/4 + cos t / 2 + 5/32 (3 cos^2 t - 1) in place of max(0, cos t).
  template <class Real>
  [[nodiscard]] Color<Real> reflected(const Vec3<Real>& normal) const {
    const auto channel = [&](double Rgb::*of) {
      const auto number = [&](std::size_t k) { return Real(sums_[k].*of); };
      const Real all = number(0);
      const Real along = number(1) * normal.x + number(2) * normal.y + number(3) * normal.z;
      const Real x = normal.x, y = normal.y, z = normal.z;
      const Real squared =
          number(4) * (x * x) + number(5) * (y * y) + (all - number(4) - number(5)) * (z * z) +
          Real(2) * (number(6) * (x * y) + number(7) * (y * z) + number(8) * (x * z));
      const Real sum =
          all * Real(0.25) + along * Real(0.5) + (Real(3) * squared - all) * Real(0.15625);
      return max(sum / pi<Real>(), Real(0));
    };
    return {channel(&Rgb::r), channel(&Rgb::g), channel(&Rgb::b)};
  }

  [[nodiscard]] const std::array<Rgb, 9>& sums() const { return sums_; }

 private:
  /// @param above, below  polar angles of the row's edges, from +y
  void add_row(const std::array<Rgb, 5>& around, double above, double below) {
    // Integrals of sin^i cos^j over the polar angle.
    const auto between = [&](const auto& integral) { return integral(below) - integral(above); };
    const double sine = 2 * sin((below - above) / 2) * sin((below + above) / 2);
    const double sine_cosine = between([](double t) { return square(sin(t)) / 2; });
    const double sine_2 = between([](double t) { return t / 2 - sin(2 * t) / 4; });
    const auto cube_of_cosine = [](double t) { return cos(t) * cos(t) * cos(t); };
    const double sine_cosine_2 = between([&](double t) { return -cube_of_cosine(t) / 3; });
    const double sine_3 = sine - sine_cosine_2;
    const double sine_2_cosine = between([](double t) { return sin(t) * sin(t) * sin(t) / 3; });
    const auto add = [&](std::size_t k, const Rgb& light, double weight) {
      sums_[k] = sums_[k] + light * weight;
    };
    add(0, around[0], sine);
    add(1, around[1], sine_2);
    add(2, around[0], sine_cosine);
    add(3, around[2], sine_2);
    add(4, (around[0] + around[3]) * 0.5, sine_3);
    add(5, around[0], sine_cosine_2);
    add(6, around[1], sine_2_cosine);
    add(7, around[2], sine_2_cosine);
    add(8, around[4] * 0.5, sine_3);
  }

  std::array<Rgb, 9> sums_{};
};

}  // namespace texmap
