// The options --projection, --from and --to.
#pragma once
#include <optional>

#include "engine/run/texture_file.hpp"
#include "texture/image_texture.hpp"
#include "texture/projections.hpp"

namespace texmap {

struct Offer;

struct ProjectionOptions {
  Projection from = Projection::equirect;  ///< of the texture's file
  std::optional<Projection> projection;    ///< of the picture on the globe; nothing: as the file
  std::optional<Projection> to;            ///< of the picture to save instead of drawing

  void declare(Offer& offer);
  [[nodiscard]] Projection on_globe() const { return projection.value_or(from); }
  /// The texture's file, converted to the layout of the globe.
  [[nodiscard]] ImageTexture load(TextureFile& file) const;
};

}  // namespace texmap
