// From a picture to a PNG file.
#include "engine/picture/save_png.hpp"

#include <stb_image_write.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/measure/stopwatch.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

// Filter 1 in every row: each byte minus the one a pixel to its left. stb would try five filters a
// row, which takes several times as long as compressing and saves a tenth of the file
// (docs/packages.md).
void choose_filter() {
  [[maybe_unused]] static const int chosen = stbi_write_force_png_filter =
      1;  // once, also when threads save at the same time
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  if (image.width < 0 || image.height < 0) throw FileError("its size is negative");
  // stb_image_write counts bytes in an int, which the limits on the size keep from overflowing.
  check_image_size(
      {static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height)});
  if (image.pixels.size() !=
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
    throw FileError("the picture does not have as many pixels as its size says");
  }
  choose_filter();
  std::vector<std::uint8_t> bytes;
  const auto keep = [](void* context, void* data, int size) {
    const std::span<const std::uint8_t> part(static_cast<const std::uint8_t*>(data),
                                             static_cast<std::size_t>(size));
    static_cast<std::vector<std::uint8_t>*>(context)->assign(part.begin(), part.end());
  };
  if (stbi_write_png_to_func(keep, &bytes, image.width, image.height, 3, image.pixels.data(),
                             3 * image.width) == 0) {
    throw FileError("the picture cannot be encoded");
  }
  return bytes;
}

void check_output(const std::filesystem::path& path) {
  with_name("cannot write", path, [&] { check_writable(path); });
}

SavingTime save_png(const Image& image, const std::filesystem::path& path) {
  SavingTime time;
  with_name("cannot write", path, [&] {
    const Stopwatch encoding;
    const std::vector<std::uint8_t> bytes = encode_png(image);
    time.encode = encoding.milliseconds();
    const Stopwatch writing;
    write_file_atomically(path, bytes);
    time.write = writing.milliseconds();
  });
  return time;
}

}  // namespace texmap
