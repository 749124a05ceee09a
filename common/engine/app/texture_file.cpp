// The option --texture.
#include "engine/app/texture_file.hpp"

#include <stdexcept>

#include "engine/app/command_line.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"

namespace texmap {

void TextureFile::declare(CommandLine& line) {
  line.text("--texture", "FILE", name, help);
  line.wishes.before_frames.emplace_back([this] {
    if (loaded) kept = load();
  });
  line.wishes.uses.emplace_back([this] {
    if (loaded) return;
    throw std::logic_error(
        "the lesson offers --texture and never loads it: is its hook spelt `prepare`? Write "
        "`override` after it, and the compiler checks the name");
  });
}

Image TextureFile::load() const {
  loaded = true;
  if (!kept.pixels.empty()) return kept;
  return load_image(find_texture(name));
}

}  // namespace texmap
