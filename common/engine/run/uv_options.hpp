// The options --uv-scale, --uv-turn, --uv-offset and --wrap.
#pragma once
#include <array>

#include "published/look_up.hpp"
#include "texture/transformed.hpp"

namespace texmap {

struct Offer;

/// How the user scales and moves a picture in (u, v), and what it then shows beyond its edges.
struct UvOptions {
  std::array<double, 2> scale{1, 1};
  double turn_degrees = 0;
  std::array<double, 2> offset{0, 0};
  std::optional<published::LookUp> look_up{};  ///< nothing: repeated, where (u, v) were moved

  void declare(Offer& offer);
  /// The user's transform; nothing if it would change nothing.
  [[nodiscard]] std::optional<UvTransform> transform() const;
  /// A mapping with this transform.
  template <class Mapping>
  [[nodiscard]] Transformed<Mapping> moved(const Mapping& mapping) const {
    return {transform(), mapping};
  }
  /// The image as a texture for such a mapping.
  [[nodiscard]] published::LookUpTexture read(const ImageTexture& image) const;
};

}  // namespace texmap
