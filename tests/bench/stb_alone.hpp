// stb_image and stb_image_write as they come, without what common/image puts around them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "texture/image.hpp"

namespace texmap::bench {

/// The bytes of a PNG file, by stb_image_write with its own compressor and its own settings.
[[nodiscard]] std::vector<std::uint8_t> stb_encoded(const Image& image);

/// How many pixels stb_image finds in the bytes of a file; 0 if it cannot read them.
[[nodiscard]] std::size_t stb_decoded_pixels(const std::vector<std::uint8_t>& file);

}  // namespace texmap::bench
