// Polygons of a mesh, cut into triangles.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "math/vec3.hpp"

namespace texmap {

/// What the polygons of a file may cost together, in looks at an edge: 3 s.
inline constexpr std::size_t most_polygon_looks = std::size_t{1} << 28;

/// Numbers of a polygon's corners, three for each triangle, in the polygon's direction.
using Cuts = std::vector<std::array<std::size_t, 3>>;

/// Cuts a polygon into triangles that cover it alone: a fan where that does, else ear by ear.
///
/// @param corners  3 or more, about in a plane; become what is seen along the axis that it faces
/// @param looks    how many looks at an edge are left; n corners usually take 1 to 4 n^2
/// @return         false: it crosses itself, or no looks are left; `cuts` is the fan
/// Source: Meisters, "Polygons have ears" (1975).
[[nodiscard]] bool cut_polygon(std::vector<Point>& corners, Cuts& cuts, std::size_t& looks);

}  // namespace texmap
