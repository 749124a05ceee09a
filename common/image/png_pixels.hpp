// The rows of a PNG picture: out of the compressed stream, and checked to the last byte.
#pragma once
#include <cstdint>

#include "image.hpp"
#include "png_chunks.hpp"

namespace texmap {

/// Bytes that the rows of a picture take when they are no longer compressed, one filter byte a row included.
[[nodiscard]] std::uint64_t promised_bytes(const PngHeader& header);

/// Bytes that the decoder holds at once while it turns the rows into pixels, at most.
[[nodiscard]] std::uint64_t png_decoding_bytes(const PngHeader& header);

/// The rows of the picture, still filtered, exactly as many bytes as the header promises.
///
/// Errors: Refusal, if the stream is damaged, ends early or holds more, if its checksum is wrong, if a row has a filter that
/// does not exist, or if a pixel asks for a color that the palette has not.
[[nodiscard]] LargeArray<std::uint8_t> read_png_pixels(const PngChunks& png);

/// True for a picture stored in one pass, 8 bits a channel or palette index: most are, and image_of_png_rows can show it.
[[nodiscard]] bool is_plain(const PngHeader& header);

/// The picture that rows are of. Alpha and transparency are dropped.
///
/// The rows had to be unpacked to be checked: the decoder would unpack them once more, and touch six times as much memory,
/// which takes longer than all the rest.
/// @param png   a file that has passed read_png_chunks, whose header is_plain
/// @param rows  what read_png_pixels made of it
/// Errors: std::bad_alloc.
/// Source: PNG specification, third edition, section 9.
[[nodiscard]] Image image_of_png_rows(const PngChunks& png, LargeArray<std::uint8_t> rows);

}  // namespace texmap
