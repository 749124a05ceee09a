// From a picture to a PNG file.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/files/bytes.hpp"
#include "engine/files/file_error.hpp"
#include "texture/image.hpp"

namespace texmap {

/// How hard to look for repetitions.
enum class Packing {
  fast,  ///< for a picture that somebody waits for
  close  ///< a fifth smaller, 50 times as long: for pictures that are kept
};

/// Compresses bytes into a zlib stream, by libdeflate or, where that is missing, by
/// stb_image_write.
///
/// @param bytes  at most 2^31 - 1, possibly none
/// Errors: std::bad_alloc.
[[nodiscard]] std::vector<std::uint8_t> deflate(Bytes bytes, Packing packing);

/// Checks, before a picture is drawn, that it can be written to this path afterwards.
///
/// @param path  a new file in a folder that exists, a file to replace, or a device
/// Errors: FileError `cannot write 'F': why`.
void check_output(const std::filesystem::path& path);

/// The bytes of a picture as a PNG file of 8 bits a channel.
///
/// @param image  1 to 16384 pixels a side, 2^27 in all
/// Errors: FileError with the reason; std::bad_alloc.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Image& image,
                                                   Packing packing = Packing::fast);

/// What saving a picture took, in milliseconds.
struct SavingTime {
  double encode = 0;  ///< from pixels to the bytes of a PNG file
  double write = 0;   ///< until the system has them
};

/// Writes a picture as a PNG file of 8 bits a channel; the file is there as a whole or not at all.
///
/// @param image  1 to 16384 pixels a side, 2^27 in all
/// @param path   as for check_output
/// @return       how long encoding and writing took
/// Errors: FileError `cannot write 'F': why`, then the old file is unchanged; std::bad_alloc.
SavingTime save_png(const Image& image, const std::filesystem::path& path);

}  // namespace texmap
