// SSIM and FLIP without any of the tested code: each sum runs over a whole two-dimensional window
// and nothing is reused. Slow, but easy to compare with the papers.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "texture/image.hpp"

namespace texmap::test::naive {

inline const double pi = std::acos(-1.0);

/// The pixel, or the nearest one of the picture.
inline Rgb8 pixel(const Image& image, int column, int row) {
  return image.at(std::clamp(column, 0, image.width - 1), std::clamp(row, 0, image.height - 1));
}

inline std::array<double, 3> levels(Rgb8 p) { return {double(p.r), double(p.g), double(p.b)}; }

/// SSIM at one pixel: the sums of equations 14 to 16 of the paper, with centered differences.
inline double ssim(const Image& a, const Image& b, int column, int row) {
  double sum = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto weighted = [&](const std::function<double(double, double)>& of) {
      double top = 0, bottom = 0;
      for (int dy = -5; dy <= 5; ++dy) {
        for (int dx = -5; dx <= 5; ++dx) {
          const double weight = std::exp(-(dx * dx + dy * dy) / 4.5);
          top += weight * of(levels(pixel(a, column + dx, row + dy))[channel],
                             levels(pixel(b, column + dx, row + dy))[channel]);
          bottom += weight;
        }
      }
      return top / bottom;
    };
    const double ma = weighted([](double x, double) { return x; });
    const double mb = weighted([](double, double y) { return y; });
    const double vaa = weighted([&](double x, double) { return (x - ma) * (x - ma); });
    const double vbb = weighted([&](double, double y) { return (y - mb) * (y - mb); });
    const double vab = weighted([&](double x, double y) { return (x - ma) * (y - mb); });
    sum += (2 * ma * mb + 6.5025) * (2 * vab + 58.5225) /
           ((ma * ma + mb * mb + 6.5025) * (vaa + vbb + 58.5225));
  }
  return sum / 3;
}

using Three = std::array<double, 3>;

/// X, Y, Z of light in the three primaries, where white is 1, 1, 1. The amounts s of the primaries
/// solve a linear system, here by Cramer's rule.
inline Three xyz(const Three& light) {
  const double x[3] = {0.64, 0.30, 0.15};
  const double y[3] = {0.33, 0.60, 0.06};
  const double wx = 0.31271, wy = 0.32902;
  const Three white = {wx / wy, 1, (1 - wx - wy) / wy};
  const auto determinant = [](const Three& p, const Three& q, const Three& r) {
    return p[0] * (q[1] * r[2] - q[2] * r[1]) - q[0] * (p[1] * r[2] - p[2] * r[1]) +
           r[0] * (p[1] * q[2] - p[2] * q[1]);
  };
  const auto primary = [&](int i) { return Three{x[i], y[i], 1 - x[i] - y[i]}; };
  const Three r = primary(0), g = primary(1), b = primary(2);
  const double all = determinant(r, g, b);
  const Three s = {determinant(white, g, b) / all, determinant(r, white, b) / all,
                   determinant(r, g, white) / all};
  Three result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] =
        (r[i] * s[0] * light[0] + g[i] * s[1] * light[1] + b[i] * s[2] * light[2]) / white[i];
  return result;
}

/// Light that has these X, Y, Z, again by Cramer's rule.
inline Three light_of(const Three& target) {
  const Three r = xyz({1, 0, 0}), g = xyz({0, 1, 0}), b = xyz({0, 0, 1});
  const auto determinant = [](const Three& p, const Three& q, const Three& s) {
    return p[0] * (q[1] * s[2] - q[2] * s[1]) - q[0] * (p[1] * s[2] - p[2] * s[1]) +
           s[0] * (p[1] * q[2] - p[2] * q[1]);
  };
  const double all = determinant(r, g, b);
  return {determinant(target, g, b) / all, determinant(r, target, b) / all,
          determinant(r, g, target) / all};
}

inline double decoded(double level) {
  const double e = level / 255;
  return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
}

inline Three lab_after_hunt(const Three& light) {
  const Three c = xyz(light);
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::pow(t, 1.0 / 3) : (24389.0 / 27 * t + 16) / 116;
  };
  const double l = 116 * f(c[1]) - 16;
  return {l, l / 100 * 500 * (f(c[0]) - f(c[1])), l / 100 * 200 * (f(c[1]) - f(c[2]))};
}

inline double hyab(const Three& p, const Three& q) {
  return std::abs(p[0] - q[0]) +
         std::sqrt((p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

/// The color difference of FLIP between two colors seen without any blur.
inline double color_difference(const Three& light_a, const Three& light_b) {
  const double most = std::pow(hyab(lab_after_hunt({0, 1, 0}), lab_after_hunt({0, 0, 1})), 0.7);
  const double error = std::pow(hyab(lab_after_hunt(light_a), lab_after_hunt(light_b)), 0.7);
  if (error < 0.4 * most) return 0.95 * error / (0.4 * most);
  return 0.95 + 0.05 * (error - 0.4 * most) / (0.6 * most);
}

using Weight = std::function<double(int dx, int dy)>;

/// Sum of weight times value over a square.
inline double gathered(int radius, const Weight& weight,
                       const std::function<double(int dx, int dy)>& value) {
  double sum = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) sum += weight(dx, dy) * value(dx, dy);
  }
  return sum;
}

/// FLIP at one pixel.
inline double flip(const Image& a, const Image& b, int column, int row, double pixels_per_degree) {
  const auto light = [&](const Image& image, int dx, int dy) {
    const Three level = levels(pixel(image, column + dx, row + dy));
    return Three{decoded(level[0]), decoded(level[1]), decoded(level[2])};
  };

  // Color. The blur is linear and Cx is a multiple of X - Y, Cz of Y - Z, so we blur X, Y and Z.
  const int wide = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / 2) / pi * pixels_per_degree));
  const auto sensitivity = [&](double a1, double b1, double a2, double b2) -> Weight {
    return [=](int dx, int dy) {
      const double d2 = (dx * dx + dy * dy) / (pixels_per_degree * pixels_per_degree);
      return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * d2 / b1) +
             a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * d2 / b2);
    };
  };
  const Weight of_y = sensitivity(1, 0.0047, 0, 1e-5);
  const Weight of_x = sensitivity(1, 0.0053, 0, 1e-5);
  const Weight of_z = sensitivity(34.1, 0.04, 13.5, 0.025);
  const auto one = [](int, int) { return 1.0; };
  const auto seen = [&](const Image& image) {
    const auto y = [&](int dx, int dy) { return xyz(light(image, dx, dy))[1]; };
    const auto x_y = [&](int dx, int dy) {
      return xyz(light(image, dx, dy))[0] - xyz(light(image, dx, dy))[1];
    };
    const auto y_z = [&](int dx, int dy) {
      return xyz(light(image, dx, dy))[1] - xyz(light(image, dx, dy))[2];
    };
    const double ny = gathered(wide, of_y, y) / gathered(wide, of_y, one);
    const double nx = ny + gathered(wide, of_x, x_y) / gathered(wide, of_x, one);
    const double nz = ny - gathered(wide, of_z, y_z) / gathered(wide, of_z, one);
    Three rgb = light_of({nx, ny, nz});
    for (double& c : rgb) c = std::max(0.0, std::min(1.0, c));
    return rgb;
  };
  const double color = color_difference(seen(a), seen(b));

  // Features: derivatives of a Gaussian; the positive weights sum to 1, the negative ones to -1.
  const double sigma = 0.041 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const auto strength = [&](const Image& image, const Weight& raw_across) {
    const auto y = [&](int dx, int dy) { return xyz(light(image, dx, dy))[1]; };
    const auto response = [&](const Weight& raw) {
      const double above = gathered(
          radius, [&](int dx, int dy) { return std::max(0.0, raw(dx, dy)); }, one);
      const double below = gathered(
          radius, [&](int dx, int dy) { return std::max(0.0, -raw(dx, dy)); }, one);
      return gathered(
          radius, [&](int dx, int dy) { return raw(dx, dy) / (raw(dx, dy) > 0 ? above : below); },
          y);
    };
    const double across = response(raw_across);
    const double down = response([&](int dx, int dy) { return raw_across(dy, dx); });
    return std::sqrt(across * across + down * down);
  };
  const auto g = [=](int dx, int dy) {
    return std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
  };
  const auto edge = [=](int dx, int dy) { return -dx * g(dx, dy); };
  const auto point = [=](int dx, int dy) { return (dx * dx / (sigma * sigma) - 1) * g(dx, dy); };
  const double feature = std::max(std::abs(strength(a, edge) - strength(b, edge)),
                                  std::abs(strength(a, point) - strength(b, point)));
  return std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0)));
}

}  // namespace texmap::test::naive
