// A crate of twelve triangles, and a floor of two.
#pragma once
#include "texture/mesh_mapping.hpp"

namespace texmap {

/// The whole texture, from its lower left corner counterclockwise.
inline constexpr std::array<Uv<double>, 4> whole_texture{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// Adds a rectangle as two triangles, which share the edge from its first to its third corner.
///
/// @param corners  indices of points, counterclockwise seen from outside
/// @param uv       the texture coordinates of these corners
inline void add_rectangle(TexturedMesh& to, const std::array<int, 4>& corners,
                          const std::array<Uv<double>, 4>& uv = whole_texture) {
  to.mesh.triangles.push_back({corners[0], corners[1], corners[2]});
  to.mapping.corners.push_back({uv[0], uv[1], uv[2]});
  to.mesh.triangles.push_back({corners[0], corners[2], corners[3]});
  to.mapping.corners.push_back({uv[0], uv[2], uv[3]});
}

/// A cube from -1 to 1 in x, y and z. Each side shows the whole texture, upright; the top and the
/// bottom do so once the cube is tipped towards +z or back.
[[nodiscard]] inline TexturedMesh crate() {
  TexturedMesh crate;
  for (const double z : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double x : {-1.0, 1.0}) crate.mesh.points.push_back({x, y, z});
    }
  }
  // A corner's index is a sum: 1 at +x, 2 at +y, 4 at +z.
  add_rectangle(crate, {4, 5, 7, 6});  // +z
  add_rectangle(crate, {5, 1, 3, 7});  // +x
  add_rectangle(crate, {1, 0, 2, 3});  // -z
  add_rectangle(crate, {0, 4, 6, 2});  // -x
  add_rectangle(crate, {6, 7, 3, 2});  // +y
  add_rectangle(crate, {0, 1, 5, 4});  // -y
  return crate;
}

/// Adds a square floor in the plane y = -1, from -reach to reach in x and z. A texture is as large
/// as a side of the crate, so that (u, v) lie far outside 0 to 1.
inline void add_floor(TexturedMesh& to, double reach) {
  const int first = static_cast<int>(to.mesh.points.size());
  const double low = (1 - reach) / 2;
  const double high = (1 + reach) / 2;
  for (const double z : {reach, -reach}) {
    for (const double x : {-reach, reach}) to.mesh.points.push_back({x, -1, z});
  }
  add_rectangle(to, {first, first + 1, first + 3, first + 2},
                {{{low, low}, {high, low}, {high, high}, {low, high}}});
}

}  // namespace texmap
