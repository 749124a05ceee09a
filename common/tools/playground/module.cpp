// The WebAssembly module of the live chapters: what a page calls.
#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/decode_image.hpp"
#include "engine/files/find_texture.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "exported.hpp"
#include "live.hpp"

namespace {

using namespace texmap;

std::unique_ptr<live::LiveLesson> lesson;
Image decoded;
struct Kept {
  Image picture;
  std::string note;  ///< what decode_image said
};
std::map<std::string, Kept> pictures;  // those that the page handed over
std::map<std::string, std::vector<std::uint8_t>> files;

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

// Linked before the library, these take the place of those that read and write the disk.
namespace texmap {

std::filesystem::path find_texture(const std::string& name) { return path_of(name); }

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t) {
  const auto kept = files.find(name_of(path));
  if (kept != files.end()) return kept->second;
  throw FileError("this page does not have it");
}

Image load_image(const std::filesystem::path& path, std::string* note, DeepImage* deep, int) {
  const auto kept = pictures.find(name_of(path));
  if (kept != pictures.end()) {
    if (note != nullptr) *note = kept->second.note;
    return kept->second.picture;
  }
  return with_name("cannot load texture", path,
                   [&] { return decode_image(read_file(path, 0), note, deep); });
}

void check_output(const std::filesystem::path&) {}
SavingTime save_png(const Image&, const std::filesystem::path& path) {
  check_writable(path);
  return {};
}

}  // namespace texmap

/// Reads a PNG or JPEG file; returns columns, rows, and what decode_image notes.
EXPORTED(decode) const char* decode(const char* name, const std::uint8_t* bytes, int size) {
  return answer([&] {
    std::string note;
    decoded = with_name("cannot load texture", name, [&] {
      return decode_image({bytes, static_cast<std::size_t>(size)}, &note);
    });
    return std::to_string(decoded.width) + " " + std::to_string(decoded.height) + " " + note;
  });
}

/// The pixels of the last file, three bytes each.
EXPORTED(pixels) const Rgb8* pixels() { return decoded.pixels.data(); }

/// Keeps a texture under a name.
EXPORTED(keep_picture)
const char* keep_picture(const char* name, const char* note, const Rgb8* pixels, int width,
                         int height) {
  return answer([&] {
    Image picture(width, height);
    std::copy_n(pixels, picture.pixels.size(), picture.pixels.begin());
    pictures[name] = {std::move(picture), note};
    return std::string();
  });
}

/// Keeps a file that the chapter reads itself, under a name; none of 0 bytes.
EXPORTED(keep_file)
const char* keep_file(const char* name, const std::uint8_t* bytes, int size) {
  return answer([&] {
    if (size == 0) {
      files.erase(name);
    } else {
      files[name].assign(bytes, bytes + size);
    }
    return std::string();
  });
}

/// Begins with a chapter, such as 6; returns its options.
EXPORTED(begin) const char* begin(int chapter) {
  return answer([&] {
    lesson = live::make_lesson(chapter);
    return lesson->options();
  });
}

/// Sets the options. Returns the picture's columns, rows and passes, and the columns and rows of
/// the second picture. Then follow the notes on the files, a line each.
EXPORTED(set) const char* set(const char* words, int widest) {
  return answer([&] {
    lesson->set(words_of(words), widest);
    const Size size = lesson->size(), beside = lesson->size_beside();
    std::string numbers;
    for (const int n : {size.width, size.height, lesson->passes(), beside.width, beside.height})
      numbers += std::to_string(n) + " ";
    return numbers + "\n" + lesson->notes();
  });
}

/// Draws rows in a pass; returns their pixels, 4 bytes each.
EXPORTED(rows) const std::uint8_t* rows(int first, int count, int pass) {
  return rgba_of(lesson->rows(first, count, pass));
}

/// Draws a part of an object's texture; returns its pixels.
EXPORTED(flat)
const std::uint8_t* flat(int object, double left, double top, double width, double height,
                         int columns, int rows) {
  return rgba_of(lesson->flat(object, {left, top, width, height, columns, rows}));
}

/// What the ray of a pixel meets.
EXPORTED(look) const char* look(int column, int row) {
  return answer([&] { return lesson->look(column, row); });
}

/// The pixel that shows a place on the picture beside.
EXPORTED(find) const char* find(double x, double y) {
  return answer([&] { return lesson->find(x, y); });
}
