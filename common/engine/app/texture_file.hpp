// A picture that the user may choose: the option --texture, or one of another name.
#pragma once
#include <string>

#include "texture/image.hpp"

namespace texmap {

class CommandLine;

/// A texture that the user can replace by another image; a second one needs its own `option`.
struct TextureFile {
  std::string name;  ///< a path, or a file in assets/
  const char* help = "the picture on the globe, a PNG or JPEG twice as wide as high";
  const char* option = "--texture";

  mutable bool loaded = false;  ///< a texture that is offered must be used
  Image kept{};                 ///< for the pictures of a turn; empty: load the file

  void declare(CommandLine& line);
  /// Loads it. Errors: FileError with the file and where it was looked for.
  [[nodiscard]] Image load() const;
};

}  // namespace texmap
