// From the bytes of a PNG file to a picture.
#pragma once
#include <string>

#include "engine/files/bytes.hpp"
#include "texture/light_image.hpp"

namespace texmap {

[[nodiscard]] bool looks_like_png(Bytes file);

/// The picture in a PNG file, every byte of it checked.
///
/// @param file  a file that looks_like_png; decode_image says what `note` and `deep` get
/// Errors: FileError, also if the zlib stream is shorter or longer than the header says;
/// std::bad_alloc.
/// Source: PNG specification, third edition, sections 7 to 9.
[[nodiscard]] Image read_png(Bytes file, std::string* note = nullptr, DeepImage* deep = nullptr,
                             int later_bytes = 0);

}  // namespace texmap
