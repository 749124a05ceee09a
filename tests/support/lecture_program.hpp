// The lecture's program, written again without the common code: its scene, bytes and order.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "texture/image.hpp"

namespace texmap::test::lecture {

struct Choices {
  int width = 800;
  double degrees = 0;
  double blend = 0.3;
  double shininess = 500;
  bool texel_of_the_slides = true;  ///< (int)((n - 1) u) instead of floor(u n)
  bool sign_of_the_slides =
      false;  ///< the highlight with the primary ray's direction instead of its opposite
};

inline Image draw(const Image& map, const Choices& choices) {
  const double pi = std::acos(-1.0);
  const int width = choices.width;
  const int height = width / 2;
  const double step = 4.0 / width;
  const double turn = choices.degrees * pi / 180;
  Image image(width, height);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      double dx = -2 + step * i;
      double dy = 1 - step * j;
      double dz = 2 - 4.0;
      const double dn = std::sqrt(dx * dx + dy * dy + dz * dz);
      dx /= dn;
      dy /= dn;
      dz /= dn;

      // Two balls: the globe at the origin, and the ground.
      double best = 1e30;
      int which = -1;
      const double centers[2][3] = {{0, 0, 0}, {0, -101, -1}};
      const double radii[2] = {1, 100};
      for (int k = 0; k < 2; ++k) {
        const double ox = -centers[k][0];
        const double oy = -centers[k][1];
        const double oz = 4 - centers[k][2];
        const double b = ox * dx + oy * dy + oz * dz;
        const double c = ox * ox + oy * oy + oz * oz - radii[k] * radii[k];
        if (b * b - c < 0) continue;
        const double t = -b - std::sqrt(b * b - c);
        if (t > 1e-6 && t < best) {
          best = t;
          which = k;
        }
      }
      if (which < 0) continue;  // the background is black

      const double px = best * dx;
      const double py = best * dy;
      const double pz = 4 + best * dz;
      const double nx = (px - centers[which][0]) / radii[which];
      const double ny = (py - centers[which][1]) / radii[which];
      const double nz = (pz - centers[which][2]) / radii[which];
      double lx = 3 - px;
      double ly = 2 - py;
      double lz = 2 - pz;
      const double ln = std::sqrt(lx * lx + ly * ly + lz * lz);
      lx /= ln;
      ly /= ln;
      lz /= ln;
      const double nl = nx * lx + ny * ly + nz * lz;
      const double rx = 2 * nx * nl - lx;
      const double ry = 2 * ny * nl - ly;
      const double rz = 2 * nz * nl - lz;
      const double rd = rx * dx + ry * dy + rz * dz;
      const double exponent = which == 0 ? choices.shininess : 50;
      double shine = 0;
      if (choices.sign_of_the_slides) {
        shine = std::pow(rd, exponent);
      } else if (nl > 0 && -rd > 0) {
        shine = std::pow(-rd, exponent);
      }
      const double matt = 0.2 + (which == 0 ? 0.5 : 0.8) * std::max(0.0, nl);
      const std::array<double, 3> color =
          which == 0 ? std::array<double, 3>{1, 1, 1} : std::array<double, 3>{1, 1, 0};
      std::array<int, 3> out{};
      for (std::size_t k = 0; k < 3; ++k) {
        out[k] = static_cast<int>(std::clamp(color[k] * matt + 0.3 * shine, 0.0, 1.0) * 255);
      }
      if (which == 0) {
        const double x = px * std::cos(turn) + pz * std::sin(turn);
        const double z = -px * std::sin(turn) + pz * std::cos(turn);
        double phi = std::atan2(x, z);
        if (phi < 0) phi += 2 * pi;
        const double u = phi / (2 * pi);
        const double v = 1 - std::acos(std::clamp(py, -1.0, 1.0)) / pi;
        int column = 0;
        int row = 0;
        if (choices.texel_of_the_slides) {
          column = static_cast<int>((map.width - 1) * u);
          row = static_cast<int>((map.height - 1) * v);
        } else {
          column = std::min(map.width - 1, static_cast<int>(map.width * u));
          row = std::min(map.height - 1, static_cast<int>(map.height * v));
        }
        const Rgb8 texel = map.at(column, map.height - row - 1);
        const std::array<int, 3> picture = {texel.r, texel.g, texel.b};
        for (std::size_t k = 0; k < 3; ++k) {
          out[k] = static_cast<int>(picture[k] * choices.blend + out[k] * (1 - choices.blend));
        }
      }
      image.at(i, j) = {static_cast<std::uint8_t>(out[0]), static_cast<std::uint8_t>(out[1]),
                        static_cast<std::uint8_t>(out[2])};
    }
  }
  return image;
}

}  // namespace texmap::test::lecture
