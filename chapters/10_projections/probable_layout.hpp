// Which layout a picture of the whole sphere probably has.
#pragma once
#include <optional>
#include <string>

#include "texture/image.hpp"
#include "texture/projections.hpp"

namespace texmap::chapter_10 {

/// How well a picture goes on where a layout says that it does.
struct SeamFigures {
  double inside = 0;  ///< mean square difference of neighbors on one side of a seam
  double across = 0;  ///< of neighbors across a seam
  double spread = 0;  ///< of any two texels next to the seams
};
[[nodiscard]] SeamFigures seam_figures(const Image& image, Projection projection);

/// How likely the picture is in this layout if its colors change equally fast everywhere on the
/// sphere and in every direction: the mean logarithm of the likelihood over the texels. It decides
/// between two layouts with the same seams, such as the cube and the equi-angular cube.
[[nodiscard]] double likelihood(const Image& image, Projection projection);

/// The layout that has the picture's shape and matching seams: neighbors across a seam differ
/// much less than any two texels next to it. Of two layouts with the same seams, the likelier one.
/// Nothing for noise, for one color and for most pictures that do not show a sphere.
[[nodiscard]] std::optional<Projection> probable_layout(const Image& image);

/// What the layout of a file probably is, and the figures for each layout that has its shape.
[[nodiscard]] std::string about_layout(const std::string& name, const Image& image);

}  // namespace texmap::chapter_10
