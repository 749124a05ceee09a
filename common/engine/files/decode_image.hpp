// From the bytes of a PNG or JPEG file to a picture.
#pragma once
#include <string>

#include "engine/files/bytes.hpp"
#include "texture/light_image.hpp"

namespace texmap {

/// The picture in a PNG or JPEG file of at most 64 MiB; the content decides which it is. Takes at
/// most 1 GiB. Rounds 16 bits to bytes, makes grey three channels, drops alpha without a note.
/// @param note  gets what its user should know, and transparent pixels are put over black
/// @param deep  for numbers, not colors: gets a PNG of 16 bits, and the result is empty
/// @param later_bytes  a pixel: what the caller makes of it. Errors: FileError unless whole, a side
///              at most 16384, the area 2^27, and for more than the free memory; std::bad_alloc.
[[nodiscard]] Image decode_image(Bytes file, std::string* note = nullptr, DeepImage* deep = nullptr,
                                 int later_bytes = 0);

/// Throws FileError with the kind of a file that is none of those wanted, by its first bytes, and
/// what makes a picture of it.
[[noreturn]] void refuse_kind(Bytes file, bool is_sky);

}  // namespace texmap
