// From a picture to a PNG file.
#include "save_png.hpp"

#include <stb_image_write.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image_limits.hpp"
#include "write_file.hpp"

namespace texmap {
namespace {

// Adds the name of the file to what goes wrong with it.
template <class Work>
void with_name(const std::string& path, Work work) {
  try {
    work();
  } catch (const Refusal& refusal) {
    // Up to a zero byte, if the name has one: what() ends there.
    const char* name = path.c_str();
    throw ImageError(std::string("cannot write '") + name + "': " + refusal.what());
  }
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  if (image.width < 0 || image.height < 0) throw Refusal("its size is negative");
  // stb_image_write counts bytes in an int, which the limits on the size keep from overflowing.
  check_image_size(static_cast<std::uint64_t>(image.width), static_cast<std::uint64_t>(image.height));
  if (image.pixels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
    throw Refusal("the picture has not as many pixels as its size says");
  }
  std::vector<std::uint8_t> bytes;
  const auto keep = [](void* context, void* data, int size) {
    const std::span<const std::uint8_t> part(static_cast<const std::uint8_t*>(data), static_cast<std::size_t>(size));
    static_cast<std::vector<std::uint8_t>*>(context)->assign(part.begin(), part.end());
  };
  if (stbi_write_png_to_func(keep, &bytes, image.width, image.height, 3, image.pixels.data(), 3 * image.width) == 0) {
    throw Refusal("the picture cannot be encoded");
  }
  return bytes;
}

void check_output(const std::string& path) {
  with_name(path, [&] { check_writable(path); });
}

void save_png(const Image& image, const std::string& path) {
  with_name(path, [&] { write_file_atomically(path, encode_png(image)); });
}

}  // namespace texmap
