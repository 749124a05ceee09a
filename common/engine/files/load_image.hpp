// From the name of a PNG or JPEG file to a picture.
#pragma once
#include <filesystem>
#include <string>

#include "engine/files/file_error.hpp"
#include "texture/light_image.hpp"

namespace texmap {

/// The picture in a PNG or JPEG file; its content decides which, not its name.
///
/// @param path  a regular file of 1 byte to 64 MiB with at most 16384 pixels a side and 2^27 in all
/// @param note, deep, later_bytes  see decode_image
/// @return      8 bits a channel, no alpha; decode_image says how other files are converted
/// Errors: FileError `cannot load texture 'F': why`, never a part of a picture; std::bad_alloc.
[[nodiscard]] Image load_image(const std::filesystem::path& path, std::string* note = nullptr,
                               DeepImage* deep = nullptr, int later_bytes = 0);

}  // namespace texmap
