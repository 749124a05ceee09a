// From the bytes of a PNG or JPEG file to a picture.
#pragma once
#include "bytes.hpp"
#include "image.hpp"

namespace texmap {

/// The picture in a PNG or JPEG file that is already in memory. The content decides which of the two it is.
///
/// 16-bit channels keep their high byte, grey is spread over three channels, alpha is dropped and leaves the color under it,
/// and a camera's note that the picture is to be turned is not heeded.
///
/// @param file  at most 64 MiB, otherwise any bytes
/// Errors: Refusal for anything but a whole picture of at most 16384 pixels a side and 2^26 in all; std::bad_alloc.
[[nodiscard]] Image decode_image(Bytes file);

}  // namespace texmap
