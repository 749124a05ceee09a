// What this chapter draws again and again: chapter 07's globe, and the choices that are varied.
#pragma once
#include "engine/kernels/root_texture.hpp"
#include "engine/render/settings.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"
#include "texture/bilinear.hpp"

namespace texmap::chapter_13 {

/// How texels become a color.
enum class Filter {
  nearest,   ///< the texel at the place
  bilinear,  ///< the four around it, mixed
};

/// How a color becomes a byte.
enum class Curve {
  none,     ///< the texture's bytes are shown as they are, without any light
  formula,  ///< the sRGB curve by the C library's power
  exact,    ///< the same bytes without a power
  four,     ///< a polynomial of 4 terms: at most 1 level off
  three,    ///< a polynomial of 3 terms: at most 2 levels off
};

/// How the light of texels is stored.
enum class TexelFormat {
  bytes,  ///< the picture's bytes; a table decodes them
  roots,  ///< ten-bit roots: root_texture.hpp
};

/// The globe under a uniform sky, seen from 6 radii as in chapter 07, so near that it fills the
/// picture.
struct Globe {
  Sphere<> sphere{{0, 0, 0}, 2};
  double away = 12;          ///< from the eye to the globe's center
  Rgb sky{0.72, 0.8, 1};     ///< no channel lies on the edge between two bytes
  ImageTexture nearest;      ///< the picture's bytes as they are
  ImageTexture light;        ///< the same picture, decoded to light
  RootTexture roots;         ///< that light, stored as its roots
  BilinearTexture bilinear;  ///< the same picture, filtered

  explicit Globe(const Image& picture)
      : nearest{picture},
        light{.image = picture, .light = TexelLight::linear},
        roots(light),
        bilinear{picture} {}

  /// The view from a place around the globe.
  ///
  /// @param east, up  degrees to the east of chapter 07's, and above the equator, -89 to 89 At 0
  ///                  and 0 a picture's middle row and column look exactly at edges of texels,
  ///                  which no other view does.
  [[nodiscard]] View<> view(int width, int height, double east = 12, double up = 17) const;
};

}  // namespace texmap::chapter_13
