// The group of files: encoding and saving a picture, loading a texture.
#include <cstdlib>
#include <filesystem>
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
#include "stb_alone.hpp"

namespace texmap::bench {
namespace {

const char* const column = "one thread";

/// Chapter 03's picture, drawn once.
[[nodiscard]] const Image& picture() {
  static const Image drawn = render<double>(
      prepared<chapter_03::Lesson>(), view_of(Camera{.eye = {0, 2, 8}, .target = {}}, 800, 600));
  return drawn;
}

/// A file that is removed in the end.
struct TemporaryFile {
  std::string path;
  TemporaryFile() {
    std::string name = (std::filesystem::temp_directory_path() / "texmap-bench-XXXXXX").string();
    const int file = mkstemp(name.data());
    if (file < 0) throw std::runtime_error("cannot make a temporary file");
    path = name;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

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
          "Chapter 03's picture, 800 × 600, as a PNG file; and the Earth's file, 2048 × 1024, as "
          "pixels. The bases are stb_image_write and stb_image as they come. Our encoder tries "
          "one filter instead of five and compresses by libdeflate ([packages](packages.md)); our "
          "decoder checks every byte of the file, and makes the pixels of plain rows itself: "
          "libdeflate only inflates them.",
      .unit = "ms",
      .note = "size in bytes",
  };
  const auto add = [&group](const std::string& line, const std::string& set,
                            std::function<Work()> prepare, std::function<std::string()> size = {}) {
    group.rows.push_back({.line = line,
                          .column = column,
                          .set = set,
                          .prepare = std::move(prepare),
                          .find_note = std::move(size)});
  };
  add(
      "encode, stb_image_write", "encode",
      [] {
        return Work(
            [] { expect(!stb_encoded(picture()).empty(), "stb_image_write encodes nothing"); });
      },
      [] { return std::to_string(stb_encoded(picture()).size()); });
  add(
      "encode, ours", "encode",
      [] { return Work([] { expect(!encode_png(picture()).empty(), "nothing is encoded"); }); },
      [] { return std::to_string(encode_png(picture()).size()); });
  add("encode and save, ours", "encode", [] {
    const auto file = std::make_shared<TemporaryFile>();
    return Work([file] { save_png(picture(), file->path); });
  });
  add("decode, stb_image", "decode", on_earth([](const auto& bytes) {
        expect(stb_decoded_pixels(bytes) > 0, "stb_image cannot read the Earth");
      }));
  add("decode with all checks, ours", "decode", on_earth([](const auto& bytes) {
        expect(!decode_image(bytes).pixels.empty(), "the Earth has no pixels");
      }));
  return group;
}

}  // namespace texmap::bench
