// Any bytes as a picture file: the loader loads or refuses them, nothing else.
#include <stb_image.h>

#include <new>
#include <span>
#include <string_view>
#include <vector>

#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/codecs/png_chunks.hpp"
#include "engine/picture/codecs/read_png.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/system/file_error.hpp"
#include "fuzz/target.hpp"

namespace texmap::test {
namespace {

void put_big_endian_32(std::span<std::uint8_t> place, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i)
    place[i] = static_cast<std::uint8_t>(number >> (24 - 8 * i) & 0xFFU);
}

// Calls `use` with the type and the data of each chunk, up to one that is longer than the file.
template <class Use>
void each_chunk(std::span<std::uint8_t> png, const Use& use) {
  for (std::size_t place = png_signature.size(); png.size() - place >= 12;) {
    const std::size_t length = big_endian_32(png, place);
    if (length > png.size() - place - 12) return;
    use(std::string_view(reinterpret_cast<const char*>(&png[place + 4]), 4), place + 8, length);
    place += 12 + length;
  }
}

// Corrects the checksum of the pixels, whose stream may be cut into several chunks anywhere.
void fix_pixel_checksum(std::span<std::uint8_t> png) {
  static std::vector<char> unpacked(std::size_t{1} << 20);
  std::vector<char> stream;
  std::vector<std::uint8_t*> places;  // of the stream's bytes in the file
  each_chunk(png, [&](std::string_view type, std::size_t data, std::size_t length) {
    if (type != "IDAT") return;
    for (std::uint8_t& byte : png.subspan(data, length)) {
      stream.push_back(static_cast<char>(byte));
      places.push_back(&byte);
    }
  });
  if (stream.size() < 6) return;
  const int made = stbi_zlib_decode_buffer(unpacked.data(), static_cast<int>(unpacked.size()),
                                           stream.data(), static_cast<int>(stream.size()));
  if (made < 0) return;
  const Bytes bytes(reinterpret_cast<const std::uint8_t*>(unpacked.data()),
                    static_cast<std::size_t>(made));
  std::uint8_t sum[4];
  put_big_endian_32(sum, adler32(bytes));
  for (std::size_t i = 0; i < 4; ++i) *places[places.size() - 4 + i] = sum[i];
}

// Corrects the checksums of a PNG file: a wrong one would end every other run at the first check.
void fix_checksums(std::span<std::uint8_t> png) {
  fix_pixel_checksum(png);
  each_chunk(png, [&](std::string_view, std::size_t data, std::size_t length) {
    put_big_endian_32(png.subspan(data + length, 4), crc32(png.subspan(data - 4, length + 4)));
  });
}

}  // namespace
}  // namespace texmap::test

// JPEG files have no checksums: libFuzzer's own changes do for them.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max_size);
  const std::span<std::uint8_t> bytes(data, mutated);
  // One in eight keeps the wrong checksums.
  if (seed % 8 != 0 && texmap::looks_like_png(bytes)) texmap::test::fix_checksums(bytes);
  return mutated;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using texmap::test::claim;
  try {
    const texmap::Image image = texmap::decode_image({data, size});
    claim(image.width >= 1 && image.width <= 16384, "a picture has 1 to 16384 columns");
    claim(image.height >= 1 && image.height <= 16384, "a picture has 1 to 16384 rows");
    const std::size_t area =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    claim(image.pixels.size() == area, "a picture has as many pixels as its size says");
  } catch (const texmap::FileError& error) {
    claim(*error.what() != '\0', "a refusal says why");
  } catch (const std::bad_alloc&) {
    // A picture may be too large for this machine; that is no fault of the loader.
  }
  return 0;
}
