// A WebAssembly module of some chapters: what a page calls. Texts and pixels stay where they are
// until the next call.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "engine/system/browser.hpp"
#include "live_files.hpp"
#include "live_chapters.hpp"

namespace {

using namespace texmap;

std::unique_ptr<live::LiveLesson> lesson;
std::string text;
std::vector<std::uint8_t> pixels;

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

/// What `work` returns, or the reason why it failed after an exclamation mark.
template <class Work>
const char* answer(const Work& work) {
  try {
    text = work();
  } catch (const std::bad_alloc&) {
    text = "!there is not enough memory for this";
  } catch (const std::exception& error) {
    text = std::string("!") + error.what();
  }
  return text.c_str();
}

}  // namespace

#define EXPORTED(name) extern "C" __attribute__((export_name(#name)))

/// Memory for what the page hands over; the page gives it back.
EXPORTED(take) void* take(int bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }
EXPORTED(give_back) void give_back(void* memory) { std::free(memory); }

/// Keeps a file under a name.
EXPORTED(keep) const char* keep(const char* name, const std::uint8_t* bytes, int size) {
  return answer([&] {
    keep_file(name, {bytes, bytes + size});
    live::forget_picture(name);
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
  pixels.resize(image.pixels.size() * 4);
  auto out = pixels.begin();
  for (const Rgb8& pixel : image.pixels) {
    for (const std::uint8_t byte : {pixel.r, pixel.g, pixel.b, std::uint8_t{255}}) *out++ = byte;
  }
  return pixels.data();
}

/// What the ray of a pixel meets.
EXPORTED(look) const char* look(int column, int row) {
  return answer([&] { return lesson->look(column, row); });
}
