// The group of files: encoding a picture, loading a texture.
#include <memory>
#include <stdexcept>

#include "01_plain_spheres/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "bench.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/system.hpp"
#include "pictures.hpp"

// stb_image and stb_image_write as they come, without what the project puts around them: static,
// because its own functions are others.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace texmap::bench {
namespace {

/// Chapter 03's picture, drawn once.
[[nodiscard]] const Image& picture() {
  static const Image drawn = render<double>(
      prepared<chapter_03::Lesson>(), view_of(Camera{.eye = {0, 2, 8}, .target = {}}, 800, 600));
  return drawn;
}

/// The bytes of a PNG file, by stb_image_write with its own compressor and its own settings.
[[nodiscard]] std::vector<std::uint8_t> stb_encoded(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const auto keep = [](void* context, void* data, int size) {
    const auto* const first = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(context)->assign(first, first + size);
  };
  stbi_write_png_to_func(keep, &bytes, image.width, image.height, 3, image.pixels.data(),
                         3 * image.width);
  return bytes;
}

/// True if stb_image can read the bytes of a file.
[[nodiscard]] bool stb_decodes(const std::vector<std::uint8_t>& file) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* const pixels = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width,
                                                &height, &channels, 3);
  stbi_image_free(pixels);
  return pixels != nullptr;
}

/// A work on the bytes of the Earth's file.
template <class Function>
[[nodiscard]] std::function<Work()> on_earth(Function function) {
  return [function]() -> Work {
    const auto bytes = std::make_shared<std::vector<std::uint8_t>>(
        read_file(find_texture("earth.png"), max_file_bytes));
    return [function, bytes] { function(*bytes); };
  };
}

void expect(bool right, const char* what) {
  if (!right) throw std::runtime_error(what);
}

}  // namespace

Group encoding_group() {
  Group group{
      .name = "encoding",
      .title = "Files",
      .text =
          "Chapter 03's picture, 800 × 600, as a PNG file; and the Earth's file, 2048 × 1024,\n"
          "as pixels. The bases are stb_image_write and stb_image as they come. Our encoder tries\n"
          "one filter instead of five and compresses by libdeflate ([packages](packages.md)); our\n"
          "decoder checks every byte of the file, and makes the pixels of plain rows itself:\n"
          "libdeflate only inflates them.",
      .unit = "ms",
  };
  const auto add = [&group](const std::string& line, const std::string& set,
                            std::function<Work()> prepare) {
    group.rows.push_back(
        {.line = line, .column = "one thread", .set = set, .prepare = std::move(prepare)});
  };
  const auto add_encoder = [&](const std::string& line, auto encoded) {
    add(line, "encode",
        [=]() -> Work { return [=] { expect(!encoded(picture()).empty(), "no file is made"); }; });
  };
  add_encoder("encode, stb_image_write", stb_encoded);
  add_encoder("encode, ours", [](const Image& image) { return encode_png(image); });
  add("decode, stb_image", "decode", on_earth([](const auto& bytes) {
        expect(stb_decodes(bytes), "stb_image cannot read the Earth");
      }));
  add("decode with all checks, ours", "decode", on_earth([](const auto& bytes) {
        expect(!decode_image(bytes).pixels.empty(), "the Earth has no pixels");
      }));
  return group;
}

}  // namespace texmap::bench
