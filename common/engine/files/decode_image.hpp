// From the bytes of a PNG or JPEG file to a picture.
#pragma once
#include <string>

#include "engine/files/bytes.hpp"
#include "texture/light_image.hpp"

namespace texmap {

/// The picture in a PNG or JPEG file that is already in memory; the content decides which it is.
/// Rounds 16-bit channels to bytes, makes grey three channels; drops alpha unless there is a note.
///
/// @param note  if there, gets what its user should know, such as "is turned as its EXIF says", and
///              transparent pixels are put over black
/// @param deep  if there, the pixels are numbers, not colors: alpha is dropped, and this gets those
///              of a PNG with 16-bit channels, each divided by 65535; of others it stays empty
/// Memory: at most 1 GiB. Errors: FileError unless it is a whole picture of at most 16384 pixels a
/// side and 2^27 in all; std::bad_alloc.
[[nodiscard]] Image decode_image(Bytes file, std::string* note = nullptr,
                                 LightImage* deep = nullptr);

/// Throws FileError with the kind of a file that is none of those wanted, by its first bytes, and
/// what makes a picture of it.
[[noreturn]] void refuse_kind(Bytes file, bool is_sky);

}  // namespace texmap
