// Which layout a picture of the whole sphere probably has.
#pragma once
#include <optional>
#include <string>

#include "texture/image.hpp"
#include "texture/projections.hpp"

namespace texmap::chapter_10 {

/// The layout that has the picture's shape and matching seams: neighbors across a seam differ
/// much less than any two texels next to it. Of two layouts with the same seams, the likelier one.
/// Nothing for noise, for one color and for most pictures that do not show a sphere.
[[nodiscard]] std::optional<Projection> probable_layout(const Image& image);

/// What the layout of a file probably is, and the figures for each layout that has its shape.
[[nodiscard]] std::string about_layout(const std::string& name, const Image& image);

}  // namespace texmap::chapter_10
