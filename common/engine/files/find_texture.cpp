// Where a texture lies.
#include "engine/files/find_texture.hpp"

#include <system_error>
#include <vector>

#include "engine/files/system.hpp"

namespace texmap {
namespace {

namespace fs = std::filesystem;

// Anything but a clear "no" counts as there: load_image then says what is wrong with it.
bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() != fs::file_type::not_found;
}

std::vector<fs::path> asset_folders() {
  std::vector<fs::path> folders = {path_of(TEXMAP_ASSETS_DIR)};
  const fs::path own = program_folder();
  if (!own.empty()) folders.push_back(own / "assets");
  const fs::path named = folder_in_environment("TEXMAP_ASSETS");
  if (!named.empty()) folders.push_back(named);
  return folders;
}

}  // namespace

fs::path find_texture(const std::string& name) {
  fs::path typed = path_of(name);
  if (typed.empty() || typed.has_parent_path() || is_there(typed)) return typed;
  std::string tried = name;
  for (const fs::path& folder : asset_folders()) {
    fs::path path = folder / typed;
    if (is_there(path)) return path;
    tried += ", " + name_of(path);
  }
  throw FileError("cannot load texture '" + name + "': not found; looked for " + tried);
}

}  // namespace texmap
