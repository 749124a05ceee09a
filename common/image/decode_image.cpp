// From the bytes of a PNG or JPEG file to a picture.
#include "decode_image.hpp"

#include <stb_image.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "check_jpeg.hpp"
#include "image_error.hpp"
#include "image_limits.hpp"
#include "image_size.hpp"
#include "png_chunks.hpp"
#include "png_pixels.hpp"

namespace texmap {
namespace {

static_assert(sizeof(Rgb8) == 3 && std::is_trivially_copyable_v<Rgb8>, "the decoder's bytes are copied as they are");

[[noreturn]] void decoder_refuses() {
  const char* const reason = stbi_failure_reason();
  if (reason != nullptr && std::string_view(reason) == "outofmem") throw std::bad_alloc();
  throw Refusal(std::string("the decoder refuses it (") + (reason != nullptr ? reason : "no reason given") + ")");
}

// Decodes a file that has passed all checks. The decoder must see the same size in it as they did.
Image decode_checked(Bytes file, ImageSize size) {
  const int length = static_cast<int>(file.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  const auto check_agreement = [&] {
    if (ImageSize{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)} == size) return;
    throw Refusal("the file is damaged: it states two different sizes");
  };

  if (stbi_info_from_memory(file.data(), length, &width, &height, &channels) == 0) decoder_refuses();
  check_agreement();

  struct Release {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
  };
  const std::unique_ptr<stbi_uc, Release> pixels(stbi_load_from_memory(file.data(), length, &width, &height, &channels, 3));
  if (!pixels) decoder_refuses();
  check_agreement();

  Image image(width, height);
  std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * sizeof(Rgb8));
  return image;
}

Image decode_png(Bytes file) {
  const PngChunks png = read_png_chunks(file);
  check_decoding_bytes(file.size() + png_decoding_bytes(png.header));
  LargeArray<std::uint8_t> rows = read_png_pixels(png);
  if (is_plain(png.header)) return image_of_png_rows(png, std::move(rows));
  rows = {};  // the decoder needs room
  return decode_checked(file, {png.header.width, png.header.height});
}

}  // namespace

Image decode_image(Bytes file) {
  if (file.size() > max_file_bytes) throw Refusal("the file is too long");
  if (looks_like_png(file)) return decode_png(file);
  if (looks_like_jpeg(file)) return decode_checked(file, check_jpeg(file));
  throw Refusal("it is not a PNG or JPEG file, whatever its name says");
}

}  // namespace texmap
