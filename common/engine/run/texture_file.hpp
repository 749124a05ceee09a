// A picture that the user may choose: the option --texture, or one of another name.
#pragma once
#include <string>

#include "texture/image.hpp"

namespace texmap {

class CommandLine;
struct Offer;

/// A texture that the user can replace by another image; a second one needs its own `option`.
struct TextureFile {
  std::string name;  ///< a path, or a file in assets/
  const char* help = "the picture on the globe, a PNG or JPEG twice as wide as high";
  const char* option = "--texture";

  void declare(Offer& offer);
  /// The picture, read once. Errors: FileError with the file and where it was looked for.
  [[nodiscard]] SharedImage load(int later_bytes = 0);

  SharedImage kept{};                     ///< by load()
  const CommandLine* declared = nullptr;  ///< where
};

}  // namespace texmap
