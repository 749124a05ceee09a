// A WebAssembly module of some chapters: what a page calls. Texts and pixels stay where they are
// until the next call.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/system/browser.hpp"
#include "exports.hpp"
#include "live_chapters.hpp"
#include "live_files.hpp"

namespace {

using namespace texmap;
using live::answer;

std::unique_ptr<live::LiveLesson> lesson;
std::vector<std::uint8_t> drawn;

/// The words of a text that ends each with a line feed.
std::vector<std::string> words_of(const char* lines) {
  std::vector<std::string> words(1);
  for (; *lines != '\0'; ++lines) {
    if (*lines == '\n') {
      words.emplace_back();
    } else {
      words.back() += *lines;
    }
  }
  words.pop_back();
  return words;
}

}  // namespace

/// Keeps a file, such as a mesh, under a name.
EXPORTED(keep) const char* keep(const char* name, const std::uint8_t* bytes, int size) {
  return answer([&] {
    keep_file(name, {bytes, bytes + size});
    return std::string();
  });
}

/// Keeps a texture: what the loader read.
EXPORTED(keep_picture)
const char* keep_picture(const char* name, const Rgb8* pixels, int width, int height) {
  return answer([&] {
    Image picture(width, height);
    std::copy_n(pixels, picture.pixels.size(), picture.pixels.begin());
    live::keep_picture(name, std::move(picture));
    return std::string();
  });
}

/// Begins with a chapter, such as "06"; returns its options.
EXPORTED(begin) const char* begin(const char* chapter) {
  return answer([&] {
    lesson = live::lesson_of(chapter);
    return lesson->options();
  });
}

/// Sets the options; returns columns and rows.
EXPORTED(set) const char* set(const char* words, int widest) {
  return answer([&] {
    lesson->set(words_of(words), widest);
    return std::to_string(lesson->size().width) + " " + std::to_string(lesson->size().height);
  });
}

/// Draws rows; returns their pixels, 4 bytes each.
EXPORTED(rows) const std::uint8_t* rows(int first, int count) {
  const Image image = lesson->rows(first, count);
  drawn.resize(image.pixels.size() * 4);
  auto out = drawn.begin();
  for (const Rgb8& pixel : image.pixels) {
    for (const std::uint8_t byte : {pixel.r, pixel.g, pixel.b, std::uint8_t{255}}) *out++ = byte;
  }
  return drawn.data();
}

/// What the ray of a pixel meets.
EXPORTED(look) const char* look(int column, int row) {
  return answer([&] { return lesson->look(column, row); });
}
