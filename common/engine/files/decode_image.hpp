// From the bytes of a PNG or JPEG file to a picture.
#pragma once
#include <string>

#include "engine/files/bytes.hpp"
#include "texture/image.hpp"

namespace texmap {

/// The picture in a PNG or JPEG file that is already in memory; the content decides which it is.
/// Keeps the high byte of 16-bit channels, makes grey three channels, drops alpha.
///
/// @param file  at most 64 MiB, otherwise any bytes
/// @param note  if there, gets what its user should know, as a predicate: "is turned as its EXIF
///              says"
/// Memory: at most 1 GiB. Errors: FileError unless it is a whole picture of at most 16384 pixels a
/// side and 2^27 in all; std::bad_alloc.
[[nodiscard]] Image decode_image(Bytes file, std::string* note = nullptr);

/// Throws FileError with the kind of a file that is none of those wanted, by its first bytes, and
/// what makes a picture of it.
[[noreturn]] void refuse_kind(Bytes file, bool is_sky);

}  // namespace texmap
