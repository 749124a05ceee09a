// A tree of boxes around the triangles of a mesh: a ray then tries few of them.
#pragma once
#include "scene/mesh.hpp"

namespace texmap {

/// Gives a mesh its boxes. Rays meet the same triangles at the same places as without them, to the
/// last bit: boxes only leave out triangles that a ray cannot meet.
/// Memory: a mesh with its tree takes below 100 bytes per triangle; its (u, v) take 48 more.
/// Domain: at most 2^21 triangles. Source: surface area heuristic with bins, Wald (2007).
void build_box_tree(Mesh& mesh);

}  // namespace texmap
