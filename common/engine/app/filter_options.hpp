// The options --filter, --wrap, --taps, --floor and --plot.
#pragma once
#include <string>

#include "engine/app/texture_file.hpp"
#include "texture/filters.hpp"

namespace texmap {

/// How the user wants textures to be read.
struct FilterOptions {
  Filter filter = Filter::anisotropic;
  Wrap wrap = Wrap::repeat;  ///< of the floor; the globe's is spherical
  int taps = 16;
  std::string floor_file = "checkers";
  std::string plot;  ///< the file for the plot of errors; empty: none

  void declare(CommandLine& line);
  /// True for filters that use the footprints of pixels.
  [[nodiscard]] bool needs_footprints() const {
    return filter != Filter::nearest && filter != Filter::bilinear;
  }
  /// Chooses another filter, here and for a texture.
  void apply(Filter other, int most_taps, FilteredTexture& texture) {
    texture.filter = filter = other;
    texture.taps = taps = most_taps;
  }
  /// The floor's picture as a texture.
  [[nodiscard]] FilteredTexture load_floor() const;
  /// The globe's.
  [[nodiscard]] FilteredTexture load_globe(const TextureFile& file) const;
};

/// A checkerboard of black and white squares as a picture.
[[nodiscard]] Image checkers_image(int size, int squares);

}  // namespace texmap
