// Where a texture lies.
#pragma once
#include <string>

#include "image_error.hpp"

namespace texmap {

/// The path of a texture: the name itself if there is such a file, otherwise, if it has no slash, the file of that name in the
/// course's assets.
///
/// The assets are looked for where they were when the program was built, in `assets` beside the running program, and in the
/// folder that the environment variable TEXMAP_ASSETS names, in this order.
///
/// @param name  a path, relative to the current folder or absolute, or the bare name of an asset
/// Errors: ImageError `cannot load texture 'NAME': not found; looked for ...` with every place. A name with a slash comes back
/// as it is: load_image says what is wrong with it.
[[nodiscard]] std::string find_texture(const std::string& name);

}  // namespace texmap
