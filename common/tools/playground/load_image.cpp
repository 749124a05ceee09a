// Textures in a browser: decoded once. Linked before the library, these functions take the place of
// those that read the disk.
#include "engine/picture/load_image.hpp"

#include <map>

#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/system.hpp"
#include "live_files.hpp"

namespace texmap {
namespace {

std::map<std::string, Image>& pictures() {
  static std::map<std::string, Image> decoded;
  return decoded;
}

}  // namespace

namespace live {

void forget_picture(const std::string& name) { pictures().erase(name); }

}  // namespace live

std::filesystem::path find_texture(const std::string& name) { return path_of(name); }

Image load_image(const std::filesystem::path& path) {
  const std::string name = name_of(path);
  const auto kept = pictures().find(name);
  if (kept != pictures().end()) return kept->second;
  return pictures()[name] = with_name("cannot load texture", path, [&] {
           return decode_image(read_file(path, max_file_bytes));
         });
}

void check_output(const std::filesystem::path&) {}
SavingTime save_png(const Image&, const std::filesystem::path& path) {
  check_writable(path);
  return {};
}

}  // namespace texmap
