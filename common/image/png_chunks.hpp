// The parts of a PNG file, each checked before the next is looked at.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "bytes.hpp"

namespace texmap {

inline constexpr std::array<std::uint8_t, 8> png_signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

/// What a PNG file says about its picture, all of it legal.
struct PngHeader {
  std::uint32_t width = 0;       // pixels
  std::uint32_t height = 0;      // pixels
  std::uint32_t bit_depth = 0;   // bits a channel or palette index: 1, 2, 4, 8 or 16
  std::uint32_t color_type = 0;  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  bool interlaced = false;
};

/// A PNG file taken apart.
struct PngChunks {
  PngHeader header;
  Bytes header_bytes;                    // the 13 bytes of IHDR
  Bytes palette;                         // three bytes a color; empty without a palette
  std::vector<std::uint8_t> compressed;  // the zlib stream of all IDAT chunks
};

[[nodiscard]] bool looks_like_png(Bytes file);

/// Channels that a pixel of a color type has in the file, 1 to 4.
[[nodiscard]] std::uint32_t png_channels(std::uint32_t color_type);

/// Checks the order, the lengths, the checksums and the contents of all chunks, and the size of the picture.
///
/// @param file  a file that looks_like_png; the result points into it
/// Errors: Refusal.
/// Source: PNG specification, third edition, sections 5, 11 and 13.
[[nodiscard]] PngChunks read_png_chunks(Bytes file);

}  // namespace texmap
