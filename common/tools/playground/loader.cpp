// The WebAssembly module that reads the reader's PNG and JPEG files for all chapters' modules.
#include <cstdint>
#include <string>

#include "engine/picture/decode_image.hpp"
#include "engine/system/file_error.hpp"
#include "exports.hpp"

namespace {

texmap::Image picture;

}  // namespace

/// Reads a file; returns columns and rows.
EXPORTED(decode) const char* decode(const char* name, const std::uint8_t* bytes, int size) {
  return texmap::live::answer([&] {
    picture = texmap::with_name("cannot load texture", name, [&] {
      return texmap::decode_image({bytes, static_cast<std::size_t>(size)});
    });
    return std::to_string(picture.width) + " " + std::to_string(picture.height);
  });
}

/// The pixels of the last file, three bytes each.
EXPORTED(pixels) const texmap::Rgb8* pixels() { return picture.pixels.data(); }

/// Frees them.
EXPORTED(forget) void forget() { picture = {}; }
