// Which layout a picture of the whole sphere probably has.
#pragma once
#include <string>
#include <vector>

#include "texture/image.hpp"
#include "texture/projections.hpp"

namespace texmap::chapter_10 {

/// The layouts that have the picture's shape and matching seams: neighbors across a seam differ
/// much less than any two texels next to it. Both cubes have the same seams, and so have both
/// octahedra. None for noise, for one color and for most pictures that do not show a sphere.
[[nodiscard]] std::vector<Projection> probable_layouts(const Image& image);

/// What the layout of a file probably is, in a line.
[[nodiscard]] std::string about_layout(const std::string& name, const Image& image);

}  // namespace texmap::chapter_10
