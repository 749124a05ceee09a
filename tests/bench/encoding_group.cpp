// The group of files: encoding a picture, loading a texture.
#include <memory>
#include <stdexcept>

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

/// Chapter 03's picture.
[[nodiscard]] Image picture() {
  return render<double>(prepared<chapter_03::Lesson>(),
                        view_of(Camera{.eye = {0, 2, 8}, .target = {}}, 800, 600));
}

/// True if stb_image_write makes the bytes of a PNG file, with its own compressor and settings.
[[nodiscard]] bool stb_encodes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const auto keep = [](void* context, void* data, int size) {
    const auto* const first = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(context)->assign(first, first + size);
  };
  return stbi_write_png_to_func(keep, &bytes, image.width, image.height, 3, image.pixels.data(),
                                3 * image.width) != 0;
}

[[nodiscard]] bool stb_decodes(const std::vector<std::uint8_t>& file) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* const pixels = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width,
                                                &height, &channels, 3);
  stbi_image_free(pixels);
  return pixels != nullptr;
}

}  // namespace

Group encoding_group() {
  Group group = described("encoding");
  // The work is what `succeeds` does with what `make` made once.
  const auto add = [&group](const std::string& line, const char* set, auto make, auto succeeds) {
    group.rows.push_back({.line = line, .column = "one thread", .set = set});
    group.rows.back().prepare = [=]() -> Work {
      return [=, input = std::make_shared<const decltype(make())>(make())] {
        if (!succeeds(*input)) throw std::runtime_error(line + ": nothing came of it");
      };
    };
  };
  const auto earth = [] { return read_file(find_texture("earth.png"), max_file_bytes); };
  add("encode, stb_image_write", "encode", picture, stb_encodes);
  add("encode, ours", "encode", picture,
      [](const Image& image) { return !encode_png(image).empty(); });
  add("decode, stb_image", "decode", earth, stb_decodes);
  add("decode with all checks, ours", "decode", earth,
      [](const auto& bytes) { return !decode_image(bytes).pixels.empty(); });
  return group;
}

}  // namespace texmap::bench
