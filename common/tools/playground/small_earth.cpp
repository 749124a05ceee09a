// The program small_earth: a picture, made smaller by whole factors and saved as a JPEG, for a page
// that must be small itself.
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

#include "engine/picture/load_image.hpp"

namespace {

using namespace texmap;

constexpr int columns = 512;
constexpr int quality = 78;  // of 100; a third of the bytes of 92

/// The mean of the bytes in each block of `factor` by `factor` pixels.
std::vector<std::uint8_t> smaller(const Image& image, int factor) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels.size() * 3 /
                (static_cast<std::size_t>(factor) * static_cast<std::size_t>(factor)));
  for (int row = 0; row + factor <= image.height; row += factor) {
    for (int column = 0; column + factor <= image.width; column += factor) {
      int red = 0, green = 0, blue = 0;
      for (int i = 0; i < factor * factor; ++i) {
        const Rgb8& pixel = image.at(column + i % factor, row + i / factor);
        red += pixel.r;
        green += pixel.g;
        blue += pixel.b;
      }
      for (const int sum : {red, green, blue})
        bytes.push_back(static_cast<std::uint8_t>(sum / (factor * factor)));
    }
  }
  return bytes;
}

int make(const std::string& from, const std::string& to) {
  const Image image = load_image(from);
  const int factor = image.width / columns;
  if (factor < 1 || image.width % columns != 0 || image.height % factor != 0) {
    std::cerr << "error: a side of '" << from << "' is no whole multiple\n";
    return 1;
  }
  const std::vector<std::uint8_t> bytes = smaller(image, factor);
  if (!stbi_write_jpg(to.c_str(), columns, image.height / factor, 3, bytes.data(), quality)) {
    std::cerr << "error: cannot write '" << to << "'\n";
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: small_earth PICTURE OUT.jpg\n";
    return 2;
  }
  return make(argv[1], argv[2]);
}
