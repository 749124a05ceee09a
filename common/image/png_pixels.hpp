// The rows of a PNG picture: out of the compressed stream, and checked to the last byte.
#pragma once
#include <cstdint>
#include <vector>

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
[[nodiscard]] std::vector<std::uint8_t> read_png_pixels(const PngChunks& png);

}  // namespace texmap
