// What every WebAssembly module of the book gives to its page: memory for what a page hands over,
// texts and pixels. They stay where they are until the next call.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "texture/image.hpp"

#define EXPORTED(name) extern "C" __attribute__((export_name(#name)))

/// Memory for what the page hands over; the page gives it back.
EXPORTED(take) void* take(int bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }
EXPORTED(give_back) void give_back(void* memory) { std::free(memory); }

namespace texmap {

/// The text that `work` returns, ended by a zero byte; if it failed, ! and why.
template <class Work>
const char* answer(const Work& work) {
  static std::string text;
  try {
    text = work();
  } catch (const std::bad_alloc&) {
    text = "!there is not enough memory for this";
  } catch (const std::exception& error) {
    text = std::string("!") + error.what();
  }
  return text.c_str();
}

/// Pixels as a page takes them, 4 bytes each.
inline const std::uint8_t* rgba_of(const Image& image) {
  static std::vector<std::uint8_t> drawn;
  drawn.resize(image.pixels.size() * 4);
  auto out = drawn.begin();
  for (const Rgb8& pixel : image.pixels) {
    for (const std::uint8_t byte : {pixel.r, pixel.g, pixel.b, std::uint8_t{255}}) *out++ = byte;
  }
  return drawn.data();
}

}  // namespace texmap
