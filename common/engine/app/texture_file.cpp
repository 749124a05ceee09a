// The option --texture.
#include "engine/app/texture_file.hpp"

#include "engine/app/command_line.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"

namespace texmap {

void TextureFile::declare(CommandLine& line) { line.text("--texture", "FILE", name, help); }

Image TextureFile::load() const {
  loaded = true;
  return load_image(find_texture(name));
}

}  // namespace texmap
