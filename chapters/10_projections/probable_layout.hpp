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
  double spread = 0;  ///< mean square difference of any two texels
};
[[nodiscard]] SeamFigures seam_figures(const Image& image, Projection projection);

/// How much of the bend at the inner edges of a layout is left when that of the layout is taken out,
/// as a mean square; smaller is better. Only compared with the other layout of the same shape.
[[nodiscard]] double bend_left(const Image& image, Projection projection);

/// The layout that fits: its shape is the picture's, its seams match although the picture is not
/// of one color, and the picture's lines bend at inner edges as the layout's do. Nothing otherwise,
/// as for noise and for pictures that are not of a sphere.
[[nodiscard]] std::optional<Projection> probable_layout(const Image& image);

/// A sentence about a file: what its layout probably is, and the figures for each that has its shape.
[[nodiscard]] std::string about_layout(const std::string& name, const Image& image);

}  // namespace texmap::chapter_10
