// Tests of the compressor of pictures, decoded by stb_image, and of both checksums, by definition.
#include <doctest.h>
#include <stb_image.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/codecs/deflate.hpp"

namespace {

using texmap::Bytes;
using File = std::vector<std::uint8_t>;

// RFC 1950, section 8.2, word by word.
std::uint32_t adler32_by_definition(Bytes bytes) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const std::uint8_t byte : bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return b * 65536 + a;
}

// PNG specification, annex D: one bit after another.
std::uint32_t crc32_by_definition(Bytes bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? (crc >> 1) ^ 0xEDB88320U : crc >> 1;
  }
  return ~crc;
}

// So many bytes that do not repeat.
File noise(std::size_t size, std::uint32_t number = 1) {
  File bytes(size);
  for (std::uint8_t& byte : bytes) {
    number = number * 1664525U + 1013904223U;
    byte = static_cast<std::uint8_t>(number >> 24);
  }
  return bytes;
}

// Noise that begins again after `period` bytes.
File repeated(std::size_t period, std::size_t size) {
  File bytes = noise(size);
  for (std::size_t i = period; i < size; ++i) bytes[i] = bytes[i - period];
  return bytes;
}

// The stream, from a room of exactly the promised size.
File deflated(Bytes bytes) {
  constexpr std::uint8_t untouched = 0xA5;
  const std::size_t room = texmap::most_deflated_bytes(bytes.size());
  File stream(room + 16, untouched);
  const std::size_t size = texmap::deflate(bytes, {stream.data(), room});
  REQUIRE(size <= room);
  for (std::size_t i = room; i < stream.size(); ++i) REQUIRE(stream[i] == untouched);
  stream.resize(size);
  return stream;
}

// Whether stb_image unpacks the stream to these bytes, and the stream ends with their checksum.
bool comes_back(const File& bytes) {
  const File stream = deflated(bytes);
  File again(bytes.size() + 1);
  const int made = stbi_zlib_decode_buffer(
      reinterpret_cast<char*>(again.data()), static_cast<int>(again.size()),
      reinterpret_cast<const char*>(stream.data()), static_cast<int>(stream.size()));
  if (made != static_cast<int>(bytes.size())) return false;
  again.resize(bytes.size());
  return again == bytes &&
         texmap::big_endian_32(stream, stream.size() - 4) == adler32_by_definition(bytes);
}

}  // namespace

TEST_CASE("the checksums are those of their definitions for every length") {
  for (std::size_t size = 0; size < 300; ++size) {
    const File bytes = noise(size);
    CHECK(texmap::adler32(bytes) == adler32_by_definition(bytes));
    CHECK(texmap::crc32(bytes) == crc32_by_definition(bytes));
  }
  // The sums of Adler-32 are largest for 255, and are cut down after 5552 bytes.
  for (const std::size_t size :
       std::vector<std::size_t>{5551, 5552, 5553, 11103, 11104, 11169, 100000}) {
    const File bytes(size, 255);
    CHECK(texmap::adler32(bytes) == adler32_by_definition(bytes));
    CHECK(texmap::crc32(bytes) == crc32_by_definition(bytes));
  }
  const File word = {'W', 'i', 'k', 'i', 'p', 'e', 'd', 'i', 'a'};
  CHECK(texmap::adler32(word) == 0x11E60398U);
  const File digits = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  CHECK(texmap::crc32(digits) == 0xCBF43926U);
}

TEST_CASE("nothing, one byte of each value and short noise come back") {
  CHECK(deflated({}) == File{0x78, 0x01, 0x03, 0x00, 0x00, 0x00, 0x00, 0x01});
  for (int value = 0; value < 256; ++value) CHECK(comes_back({static_cast<std::uint8_t>(value)}));
  for (std::size_t size = 0; size < 600; ++size) CHECK(comes_back(noise(size)));
}

TEST_CASE("matches of every length come back, from one byte away and from further") {
  for (const std::size_t period : std::vector<std::size_t>{1, 2, 3, 4, 5, 7, 2401}) {
    for (std::size_t length = 0; length < 600; ++length)
      CHECK(comes_back(repeated(period, period + length)));
  }
}

TEST_CASE("matches from every distance come back, and none is sought beyond the window") {
  for (std::size_t distance = 1; distance < 700; ++distance)
    CHECK(comes_back(repeated(distance, distance + 40)));
  for (std::size_t power = 512; power <= 32768; power *= 2) {
    for (const std::size_t distance :
         {power - 1, power, power + 1, power + power / 2, power + power / 2 + 1}) {
      CAPTURE(distance);
      CHECK(comes_back(repeated(distance, 2 * distance + 300)));
    }
  }
  // Noise repeated a hundred times takes a hundredth; one byte too far back, it takes the whole.
  CHECK(deflated(repeated(4000, 400000)).size() < 4000 * 17 / 16 + 100 * 100);
  CHECK(deflated(repeated(32768, 65536)).size() < 50000);
  CHECK(deflated(repeated(32769, 65536)).size() > 65536);
}

TEST_CASE("the promised room is enough for the worst bytes, which are those with long codes") {
  File bytes = noise(100000);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(144 + byte % 112);
  CHECK(comes_back(bytes));
  CHECK(deflated(bytes).size() > 100000 * 9 / 8 - 2000);
}
