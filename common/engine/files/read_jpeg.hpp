// From the bytes of a JPEG file to a picture.
#pragma once
#include <string>

#include "engine/files/bytes.hpp"
#include "texture/image.hpp"

namespace texmap {

[[nodiscard]] bool looks_like_jpeg(Bytes file);

/// The picture in a JPEG file. Checks its tables, its header and every code of every scan first.
/// @param file  a file that looks_like_jpeg; a damaged EXIF turns nothing
/// @param note  if there, gets what decode_image says
/// @param has_colors  false for numbers such as normals: the note then says nothing of colors
/// Errors: FileError; std::bad_alloc.
/// Source: ITU-T T.81, annexes B, C, F and G.
[[nodiscard]] Image read_jpeg(Bytes file, std::string* note = nullptr, int later_bytes = 0,
                              bool has_colors = true);

}  // namespace texmap
