// From a picture of the sphere in one layout to the same picture in another.
#pragma once
#include <functional>

#include "texture/image.hpp"
#include "texture/light_image.hpp"
#include "texture/projection_facts.hpp"

namespace texmap {

/// Columns and rows of a picture, in texels.
struct PictureSize {
  int width, height;
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// The size in which a layout has as many texels for the sphere as a picture in another layout.
/// A cube's is a multiple of (3, 2), so that no texel lies on two faces.
[[nodiscard]] PictureSize converted_size(const Image& image, Projection from, Projection to);

/// A texel's place, from the left and from the top.
struct Texel {
  int column, row;
};
/// The texel that a neighbor of a texel is, on its side of an edge of the layout or beyond.
///
/// @param home         a texel inside the picture
/// @param column, row  at most one away from it; may lie outside the picture
[[nodiscard]] Texel texel_beside(Projection projection, const Texel& home, int column, int row,
                                 int width, int height);

/// The light at (u, v) of a picture in a layout, mixed from the four nearest texel centers. What is
/// beyond an edge or a seam is taken from where it goes on.
[[nodiscard]] Color<double> light_at(const SharedLight& image, Projection projection,
                                     const Uv<double>& uv);

/// Whether a pixel is to be drawn; asked from any thread. Empty: all.
using PixelChoice = std::function<bool(int column, int row)>;

/// A picture in another layout: light_at, and where the picture shrinks the mean of n x n places of
/// a texel, n up to 8 from the footprint that duals give. Light is averaged, not bytes.
///
/// @param threads  0: all cores
/// @return  `image` itself where nothing changes; black where `from` shows nothing, or not wanted
[[nodiscard]] Image convert_projection(const SharedImage& image, Projection from, Projection to,
                                       const PictureSize& size, int threads = 0,
                                       const PixelChoice& wanted = {});

}  // namespace texmap
