// From the name of a PNG or JPEG file to a picture.
#pragma once
#include <string>

#include "image.hpp"
#include "image_error.hpp"

namespace texmap {

/// The picture in a PNG or JPEG file; what it is made of decides, not what it is called.
///
/// @param path  a regular file of 1 byte to 64 MiB with at most 16384 pixels a side and 2^26 in all
/// @return      8 bits a channel, no alpha; see decode_image for what becomes of other files
/// Errors: ImageError `cannot load texture 'F': why`, never a picture that is only partly there; std::bad_alloc.
[[nodiscard]] Image load_image(const std::string& path);

}  // namespace texmap
