// Where a texture lies.
#pragma once
#include <filesystem>
#include <string>

#include "engine/files/file_error.hpp"

namespace texmap {

/// The path of a texture: `name` if that file exists, else the asset of that name.
///
/// @param name  a path, relative to the current folder or absolute, or the bare name of an asset
/// @return      a name with a slash as it is; load_image says what is wrong with it
/// Errors: FileError `cannot load texture 'NAME': not found; looked for ...` with every place.
[[nodiscard]] std::filesystem::path find_texture(const std::string& name);

}  // namespace texmap
