// From a picture to a PNG file.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "image.hpp"
#include "image_error.hpp"

namespace texmap {

/// Checks, before a picture is drawn, that it can be written to this path afterwards.
///
/// @param path  a new file in a folder that exists, a file to replace, or a device
/// Errors: ImageError `cannot write 'F': why`.
void check_output(const std::string& path);

/// The bytes of a picture as a PNG file of 8 bits a channel.
///
/// @param image  1 to 16384 pixels a side, 2^26 in all
/// Errors: Refusal with the reason; std::bad_alloc.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Image& image);

/// What saving a picture took, in milliseconds.
struct SavingTime {
  double encode = 0;  ///< from pixels to the bytes of a PNG file
  double write = 0;   ///< until the disk has them
};

/// Writes a picture as a PNG file of 8 bits a channel; the file is there as a whole or not at all.
///
/// @param image  1 to 16384 pixels a side, 2^26 in all
/// @param path   as for check_output
/// @return       how long it took, for those who want to know
/// Errors: ImageError `cannot write 'F': why`; then an old file at the path is as it was, and no temporary one is left.
/// std::bad_alloc.
SavingTime save_png(const Image& image, const std::string& path);

}  // namespace texmap
