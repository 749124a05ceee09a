// Which layout a picture of the whole sphere probably has.
#pragma once
#include <optional>
#include <string>

#include "texture/image.hpp"
#include "texture/projections.hpp"

namespace texmap::chapter_10 {

/// How well a picture goes on where a layout says that it does.
struct SeamFigures {
  double inside = 0;  ///< mean square difference of neighbors beside the seams
  double across = 0;  ///< the same across the seams
  double spread = 0;  ///< mean square difference of any two texels beside the seams
};
[[nodiscard]] SeamFigures seam_figures(const Image& image, Projection projection);

/// How likely the picture's slopes are in this layout, if on the sphere they are equally steep at
/// every place and in every direction: the mean logarithm over the texels. To be compared with the
/// value for the twin layout, which has the same seams and other distortions.
[[nodiscard]] double likelihood(const Image& image, Projection projection);

/// The layout that fits: its shape is the picture's; its seams match, although neighbors differ
/// less than any two texels of the seams; and of two twins it makes the picture more likely.
/// Nothing otherwise: for noise, for one color, for most pictures that are not of a sphere.
[[nodiscard]] std::optional<Projection> probable_layout(const Image& image);

/// What the layout of a file probably is, and the figures for each layout that has its shape.
[[nodiscard]] std::string about_layout(const std::string& name, const Image& image);

}  // namespace texmap::chapter_10
