// Where a texture lies.
#include "engine/picture/find_texture.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace texmap {
namespace {

// Anything but a clear "no" counts as there: load_image then says what is wrong with it.
bool is_there(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 || (errno != ENOENT && errno != ENOTDIR);
}

// The folder of the running program, or nothing where the system does not tell.
std::string program_folder() {
  std::string path(PATH_MAX, '\0');
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size());
  if (length <= 0) return "";
  path.resize(static_cast<std::size_t>(length));
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::vector<std::string> asset_folders() {
  std::vector<std::string> folders = {TEXMAP_ASSETS_DIR};
  const std::string beside = program_folder();
  if (!beside.empty()) folders.push_back(beside + "/assets");
  const char* const named = std::getenv("TEXMAP_ASSETS");
  if (named != nullptr && *named != '\0') folders.emplace_back(named);
  return folders;
}

}  // namespace

std::string find_texture(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos || is_there(name)) return name;
  std::string tried = name;
  for (const std::string& folder : asset_folders()) {
    std::string path = folder;
    path.append("/").append(name);
    if (is_there(path)) return path;
    tried.append(", ").append(path);
  }
  throw FileError("cannot load texture '" + name + "': not found; looked for " + tried);
}

}  // namespace texmap
