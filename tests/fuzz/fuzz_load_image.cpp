// Any bytes as a picture file: the loader loads or refuses them, nothing else.
#include <stb_image.h>

#include <algorithm>
#include <cstring>
#include <span>

#include "engine/files/decode_image.hpp"
#include "engine/files/png_chunks.hpp"
#include "engine/files/read_png.hpp"
#include "fuzz/target.hpp"

namespace texmap::test {
namespace {

void put_big_endian_32(std::span<std::uint8_t> place, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i)
    place[i] = static_cast<std::uint8_t>(number >> (24 - 8 * i) & 0xFFU);
}

struct Chunk {
  std::size_t data, length;  // where its data begins in the file
};

// The chunks of a PNG file, up to one that is longer than the file.
std::vector<Chunk> chunks_of(Bytes png) {
  std::vector<Chunk> chunks;
  for (std::size_t place = png_signature.size(); png.size() - place >= 12;) {
    const std::size_t length = big_endian_32(png, place);
    if (length > png.size() - place - 12) break;
    chunks.push_back({place + 8, length});
    place += 12 + length;
  }
  return chunks;
}

// Lets libFuzzer change the data of one chunk, of any length, and keeps the file's other parts.
std::size_t change_chunk(std::uint8_t* data, std::size_t size, std::size_t max_size,
                         const Chunk& chunk) {
  const std::size_t most = chunk.length + max_size - size;
  if (most == 0) return size;
  const std::vector<std::uint8_t> rest(data + chunk.data + chunk.length, data + size);
  const std::size_t length = LLVMFuzzerMutate(data + chunk.data, chunk.length, most);
  std::copy(rest.begin(), rest.end(), data + chunk.data + length);
  put_big_endian_32({data + chunk.data - 8, 4}, static_cast<std::uint32_t>(length));
  return size - chunk.length + length;
}

// Corrects the checksum of the pixels; their stream may be cut into several chunks anywhere.
void fix_pixel_checksum(std::span<std::uint8_t> png) {
  static std::vector<char> unpacked(std::size_t{1} << 20);
  std::vector<char> stream;
  std::vector<std::uint8_t*> places;  // of the stream's bytes in the file
  for (const Chunk& chunk : chunks_of(png)) {
    if (std::memcmp(&png[chunk.data - 4], "IDAT", 4) != 0) continue;
    for (std::uint8_t& byte : png.subspan(chunk.data, chunk.length)) {
      stream.push_back(static_cast<char>(byte));
      places.push_back(&byte);
    }
  }
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
  for (const Chunk& chunk : chunks_of(png)) {
    put_big_endian_32(png.subspan(chunk.data + chunk.length, 4),
                      crc32(png.subspan(chunk.data - 4, chunk.length + 4)));
  }
}

}  // namespace
}  // namespace texmap::test

// JPEG files have no checksums and short segments: libFuzzer's own changes do for them.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace texmap::test;
  // One in eight PNG files is changed anywhere and keeps the wrong checksums, one the right ones.
  const bool png = texmap::looks_like_png({data, size});
  const auto chunks = png && seed % 8 > 1 ? chunks_of({data, size}) : std::vector<Chunk>();
  size = chunks.empty() ? LLVMFuzzerMutate(data, size, max_size)
                        : change_chunk(data, size, max_size, chunks[seed / 8 % chunks.size()]);
  if (seed % 8 > 0 && texmap::looks_like_png({data, size})) fix_checksums({data, size});
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using texmap::test::claim;
  return texmap::test::loads_or_refuses([&] {
    std::string note;
    const texmap::Image image = texmap::decode_image({data, size}, &note);
    texmap::DeepImage deep;
    const texmap::Image numbers = texmap::decode_image({data, size}, nullptr, &deep);
    claim(numbers.pixels.size() + deep.pixels.size() == image.pixels.size(),
          "numbers are as many as colors, all of 8 or of 16 bits");
    claim(image.width >= 1 && image.width <= 16384, "a picture has 1 to 16384 columns");
    claim(image.height >= 1 && image.height <= 16384, "a picture has 1 to 16384 rows");
    const std::size_t area =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    claim(image.pixels.size() == area, "a picture has as many pixels as its size says");
  });
}
