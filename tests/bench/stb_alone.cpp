// stb_image and stb_image_write as they come. Their functions are static here: the project's own
// are others.
#include "stb_alone.hpp"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace texmap::bench {

std::vector<std::uint8_t> stb_encoded(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const auto keep = [](void* context, void* data, int size) {
    const auto* const first = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(context)->assign(first, first + size);
  };
  stbi_write_png_to_func(keep, &bytes, image.width, image.height, 3, image.pixels.data(),
                         3 * image.width);
  return bytes;
}

std::size_t stb_decoded_pixels(const std::vector<std::uint8_t>& file) {
  int width = 0;
  int height = 0;
  int channels = 0;
  stbi_uc* const pixels = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width,
                                                &height, &channels, 3);
  if (pixels == nullptr) return 0;
  stbi_image_free(pixels);
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace texmap::bench
