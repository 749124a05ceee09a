// The options --projection, --from and --to.
#pragma once
#include "engine/app/texture_file.hpp"
#include "texture/image_texture.hpp"
#include "texture/projections.hpp"

namespace texmap {

/// The layouts that the user chose.
struct ProjectionOptions {
  Projection projection = Projection::equirect;  ///< of the picture on the globe
  Projection from = Projection::equirect;        ///< of the texture's file
  Projection to = Projection::equirect;          ///< of the picture to save, instead of the globe

  void declare(CommandLine& line);
  /// The texture's file, converted to the layout of the globe.
  [[nodiscard]] ImageTexture load(const TextureFile& file) const;
};

}  // namespace texmap
