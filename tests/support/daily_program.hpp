// The daily exercise's program, written again without the common code: left-handed world, its
// formulas, plain doubles. A reference must not share the mistakes of what it tests.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "texture/image.hpp"

namespace texmap::test::daily {

using Triple = std::array<double, 3>;

inline double inner(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Triple along(const Triple& a, const Triple& d, double t) {
  return {a[0] + d[0] * t, a[1] + d[1] * t, a[2] + d[2] * t};
}
inline Triple unit(const Triple& a) {
  const double n = std::sqrt(inner(a, a));
  return {a[0] / n, a[1] / n, a[2] / n};
}

struct Ball {
  Triple center;
  double radius;
  Triple color;
  bool checkered;
};

/// The smaller distance beyond 0.001, or -1: textbook b^2 - 4ac for a unit direction.
inline double meet(const Ball& ball, const Triple& from, const Triple& toward) {
  const Triple oc = along(from, ball.center, -1);
  const double b = 2 * inner(oc, toward);
  const double c = inner(oc, oc) - ball.radius * ball.radius;
  const double under_root = b * b - 4 * c;
  if (under_root < 0) return -1;
  for (const double root : {(-b - std::sqrt(under_root)) / 2, (-b + std::sqrt(under_root)) / 2}) {
    if (root > 0.001) return root;
  }
  return -1;
}

/// @param checkered  false for the same scene in plain colors: white, red, blue, white
inline Image draw(int width, int height, bool checkered) {
  const Triple white{0.9, 0.9, 0.9};
  const Triple blue{0.2, 0.2, 0.8};
  const std::array<Ball, 4> balls = {{
      {{0, 0, 0}, 1, white, checkered},
      {{-2.5, 0, -1}, 0.8, {1, 0.3, 0.3}, false},
      {{2.5, 0, -1}, 0.8, blue, checkered},
      {{0, -1001, 0}, 1000, white, checkered},
  }};
  const Triple eye{0, 2, -8};
  const Triple lamp{5, 5, -5};
  const Triple ahead = unit({0, -2, 8});
  const Triple right{1, 0, 0};
  const Triple up = unit({0, 8, 2});
  const double tangent = std::tan(std::acos(-1.0) / 6);

  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double sx = ((x + 0.5) / width * 2 - 1) * tangent * width / height;
      const double sy = (1 - (y + 0.5) / height * 2) * tangent;
      const Triple look = unit(along(along(ahead, right, sx), up, sy));
      const Ball* nearest = nullptr;
      double distance = 1e20;
      for (const Ball& ball : balls) {
        const double t = meet(ball, eye, look);
        if (t > 0 && t < distance) {
          distance = t;
          nearest = &ball;
        }
      }
      const double rise = 0.5 * (look[1] + 1);
      Triple color{1 - rise + 0.5 * rise, 1 - rise + 0.7 * rise, 1};
      if (nearest != nullptr) {
        const Triple point = along(eye, look, distance);
        const Triple normal = unit(along(point, nearest->center, -1));
        color = nearest->color;
        if (nearest->checkered) {
          const double u = 0.5 + std::atan2(normal[2], normal[0]) / (2 * std::acos(-1.0));
          const double v = 0.5 - std::asin(normal[1]) / std::acos(-1.0);
          const long parity = std::lround(std::floor(10 * u)) + std::lround(std::floor(10 * v));
          color = parity % 2 == 0 ? white : blue;
        }
        const Triple path = along(lamp, point, -1);
        const double far = std::sqrt(inner(path, path));
        const Triple to_lamp = unit(path);
        const bool shadow = std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
          const double t = meet(ball, point, to_lamp);
          return t > 0 && t < far;
        });
        const double light = 0.2 + (shadow ? 0 : 0.8 * std::max(0.0, inner(normal, to_lamp)));
        for (double& channel : color) channel *= light;
      }
      const auto byte = [](double v) {
        return static_cast<std::uint8_t>(std::min(255.0, 255 * v));
      };
      image.at(x, y) = {byte(color[0]), byte(color[1]), byte(color[2])};
    }
  }
  return image;
}

}  // namespace texmap::test::daily
