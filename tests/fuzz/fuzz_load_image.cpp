// Feeds libFuzzer's bytes to the texture loader: it may load or refuse them, nothing else.
//
// Build with clang++ -fsanitize=fuzzer,address,undefined; start on a copy of tests/corpus with
// -timeout=5.
#include <stb_image.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <span>
#include <string_view>
#include <vector>

#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/codecs/png_chunks.hpp"
#include "engine/picture/codecs/read_png.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/system/file_error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

void put_big_endian_32(std::span<std::uint8_t> place, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i)
    place[i] = static_cast<std::uint8_t>(number >> (24 - 8 * i) & 0xFFU);
}

// Corrects the checksums of a PNG file: a wrong one would end every other run at the first check.
void fix_checksums(std::span<std::uint8_t> png) {
  static std::vector<char> unpacked(std::size_t{1} << 20);
  for (std::size_t place = texmap::png_signature.size(); png.size() - place >= 12;) {
    const std::size_t length = texmap::big_endian_32(png, place);
    if (length > png.size() - place - 12) return;
    const std::span<std::uint8_t> data = png.subspan(place + 8, length);
    const std::string_view type(reinterpret_cast<const char*>(png.data() + place + 4), 4);
    if (type == "IDAT" && length >= 6) {
      const int made = stbi_zlib_decode_buffer(unpacked.data(), static_cast<int>(unpacked.size()),
                                               reinterpret_cast<const char*>(data.data()),
                                               static_cast<int>(length));
      if (made >= 0) {
        const texmap::Bytes bytes(reinterpret_cast<const std::uint8_t*>(unpacked.data()),
                                  static_cast<std::size_t>(made));
        put_big_endian_32(data.last(4), texmap::adler32(bytes));
      }
    }
    put_big_endian_32(png.subspan(place + 8 + length, 4),
                      texmap::crc32(png.subspan(place + 4, length + 4)));
    place += 12 + length;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max_size);
  const std::span<std::uint8_t> bytes(data, mutated);
  // One in eight keeps the wrong checksums.
  if (seed % 8 != 0 && texmap::looks_like_png(bytes)) fix_checksums(bytes);
  return mutated;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const texmap::Image image = texmap::decode_image({data, size});
    const std::size_t area =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width < 1 || image.height < 1 || image.pixels.size() != area) std::abort();
  } catch (const texmap::FileError& error) {
    if (*error.what() == '\0') std::abort();
  } catch (const std::bad_alloc&) {
    // A picture may be too large for this machine; that is no fault of the loader.
  }
  return 0;
}
