// Textures in a browser: the loader has decoded them, and the page handed them over. Linked before
// the library, these functions take the place of those that read the disk.
#include "engine/picture/load_image.hpp"

#include <map>
#include <utility>

#include "engine/picture/find_texture.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/system.hpp"
#include "live_files.hpp"

namespace texmap {
namespace {

std::map<std::string, Image>& pictures() {
  static std::map<std::string, Image> kept;
  return kept;
}

}  // namespace

namespace live {

void keep_picture(const std::string& name, Image picture) { pictures()[name] = std::move(picture); }

}  // namespace live

std::filesystem::path find_texture(const std::string& name) { return path_of(name); }

Image load_image(const std::filesystem::path& path) {
  const auto kept = pictures().find(name_of(path));
  if (kept != pictures().end()) return kept->second;
  throw FileError("cannot load texture '" + name_of(path) + "': this page does not have it");
}

void check_output(const std::filesystem::path&) {}
SavingTime save_png(const Image&, const std::filesystem::path& path) {
  check_writable(path);
  return {};
}

}  // namespace texmap
