// The parts of a PNG file, each checked before the next is looked at, and its two checksums.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/files/bytes.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/pixel_order.hpp"

namespace texmap {

inline constexpr std::array<std::uint8_t, 8> png_signature = {0x89, 'P',  'N',  'G',
                                                              '\r', '\n', 0x1A, '\n'};

/// What a PNG file says about its picture, all of it legal.
struct PngHeader {
  ImageSize size;
  std::uint32_t bit_depth = 0;   // bits a channel or palette index: 1, 2, 4, 8 or 16
  std::uint32_t color_type = 0;  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  bool interlaced = false;
  std::uint32_t channels = 0;  // of a pixel, 1 to 4
};

/// A PNG file taken apart.
struct PngChunks {
  PngHeader header;
  Bytes palette;       // three bytes a color; empty without a palette
  Bytes transparency;  // of tRNS: palette colors' alpha, or the transparent color
  PixelOrder order;    // of eXIf
  // What tells of colors: one of cICP, iCCP, or the last two, which sRGB, too, replaces.
  Bytes color_code;               // of cICP: the numbers of its primaries and its curve first
  Bytes profile;                  // of iCCP: its zlib stream
  Bytes primaries;                // of cHRM: x and y of white, red, green and blue, times 100000
  std::uint32_t gamma = 0;        // of gAMA, times 100000
  std::vector<Bytes> compressed;  // the zlib stream, in the pieces of the IDAT chunks, at least one
};

/// Throws FileError `the PNG file is damaged: how`.
[[noreturn]] void damaged_png(const std::string& how);

/// Checks the order, lengths, checksums and contents of all chunks, and the size of the picture.
///
/// @param file  a file that looks_like_png; the result points into it
/// Errors: FileError.
/// Source: PNG specification, third edition, sections 5, 11 and 13.
[[nodiscard]] PngChunks read_png_chunks(Bytes file);

/// CRC-32 of some bytes, as every chunk of a PNG file carries it.
///
/// Source: PNG specification, annex D.
[[nodiscard]] std::uint32_t crc32(Bytes bytes);

/// Adler-32 of some bytes, as a zlib stream carries it at its end.
///
/// Source: RFC 1950, section 8.2.
[[nodiscard]] std::uint32_t adler32(Bytes bytes);

}  // namespace texmap
