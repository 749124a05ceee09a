// A normal map of a brick wall.
#pragma once
#include "texture/image.hpp"

namespace texmap {

/// The normal map of a wall of 16 x 16 bricks, 512 x 256 texels, green up. It repeats in u.
[[nodiscard]] Image make_bricks_normals();

}  // namespace texmap
