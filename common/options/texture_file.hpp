// The option --texture.
#pragma once
#include <string>

#include "command_line.hpp"
#include "find_texture.hpp"
#include "load_image.hpp"

namespace texmap {

/// A texture that the user can replace by a picture of their own.
struct TextureFile {
  std::string name;  ///< a path, or the name of a file in assets/

  void declare(CommandLine& line) {
    line.text("--texture", "FILE", name, "the picture on the globe, a PNG or JPEG twice as wide as high");
  }
  /// Errors: ImageError naming the file, and where it was looked for. A missing texture is never replaced by a color.
  [[nodiscard]] Image load() const { return load_image(find_texture(name)); }
};

}  // namespace texmap
