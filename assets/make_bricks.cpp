// A normal map of a brick wall.
#include "make_bricks.hpp"

#include <algorithm>
#include <cmath>

#include "texture/normal_map.hpp"

namespace texmap {
namespace {

constexpr int brick_width = 32, brick_height = 16;  // in texels, as all lengths here

/// The height of the wall: bricks with rounded edges, mortar between them. y runs up.
double wall_height(double x, double y) {
  const double row = std::floor(y / brick_height);
  const double shift = std::fmod(row, 2) == 0 ? 0 : brick_width / 2;
  const double along = std::fmod(x + shift + brick_width, brick_width);
  const double across = y - row * brick_height;
  const double to_edge = std::min({along, brick_width - along, across, brick_height - across});
  const double t = std::clamp((to_edge - 1) / 3, 0.0, 1.0);
  return 2 * t * t * (3 - 2 * t);
}

}  // namespace

Image make_bricks_normals() {
  constexpr int height = 16 * brick_height;
  return image_of(16 * brick_width, height, [](int column, int row) {
    const double x = column + 0.5, y = height - row - 0.5;
    const double right = wall_height(x + 0.5, y) - wall_height(x - 0.5, y);
    const double up = wall_height(x, y + 0.5) - wall_height(x, y - 0.5);
    return color_of_normal(normalize(Vec3d{-right, -up, 1}));
  });
}

}  // namespace texmap
