// The options --convention and --rounding.
#pragma once
#include "engine/run/texture_file.hpp"
#include "texture/conventions.hpp"

namespace texmap {

struct Offer;

/// How the user lays an image on the globe.
struct LayoutOptions {
  Convention convention = Convention::rtiow;
  TexelRounding rounding = TexelRounding::floor;

  void declare(Offer& offer);
  /// The image as a texture in this layout.
  [[nodiscard]] ImageTexture load(TextureFile& file) const;
};

}  // namespace texmap
