// A PNG file with nothing to unpack in it.
#pragma once
#include <cstdint>
#include <vector>

#include "png_chunks.hpp"

namespace texmap {

/// The same picture as a PNG file for the decoder: rows stored as they are instead of compressed, and no other chunks.
///
/// The rows had to be unpacked to be checked. Handing them on spares the decoder the work, which is most of its time, and lets
/// it see nothing but what this file wrote. Checksums are left at zero, since the decoder skips them; transparency is left out,
/// since alpha is dropped.
///
/// @param png   a file that has passed read_png_chunks
/// @param rows  what read_png_pixels made of it
/// Errors: std::bad_alloc.
/// Source: RFC 1951, section 3.2.4.
[[nodiscard]] std::vector<std::uint8_t> stored_png(const PngChunks& png, Bytes rows);

}  // namespace texmap
