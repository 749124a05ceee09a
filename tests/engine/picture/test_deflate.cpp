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
using texmap::Packing;
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
File deflated(Bytes bytes, Packing packing = Packing::fast, std::size_t period = 0) {
  constexpr std::uint8_t untouched = 0xA5;
  const std::size_t room = texmap::most_deflated_bytes(bytes.size());
  File stream(room + 16, untouched);
  const std::size_t size = texmap::deflate(bytes, {stream.data(), room}, packing, period);
  REQUIRE(size <= room);
  for (std::size_t i = room; i < stream.size(); ++i) REQUIRE(stream[i] == untouched);
  stream.resize(size);
  return stream;
}

// Whether stb_image unpacks the stream to these bytes, and the stream ends with their checksum.
bool comes_back(const File& bytes, Packing packing, std::size_t period) {
  const File stream = deflated(bytes, packing, period);
  File again(bytes.size() + 1);
  const int made = stbi_zlib_decode_buffer(
      reinterpret_cast<char*>(again.data()), static_cast<int>(again.size()),
      reinterpret_cast<const char*>(stream.data()), static_cast<int>(stream.size()));
  if (made != static_cast<int>(bytes.size())) return false;
  again.resize(bytes.size());
  return again == bytes &&
         texmap::big_endian_32(stream, stream.size() - 4) == adler32_by_definition(bytes);
}

bool comes_back(const File& bytes) {
  return comes_back(bytes, Packing::fast, 0) && comes_back(bytes, Packing::fast, 7) &&
         comes_back(bytes, Packing::close, 0) && comes_back(bytes, Packing::close, 7);
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
  for (const std::size_t size : std::vector<std::size_t>{1, 20, 60, 1000, 100000}) {
    File bytes = noise(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(144 + byte % 112);
    CHECK(comes_back(bytes));
  }
  // Too few to pay for codes of their own.
  const File few = {144, 160, 180, 200, 220, 240, 250, 255};
  CHECK(deflated(few).size() == 2 + (3 + 8 * 9 + 7 + 7) / 8 + 4);
  CHECK(deflated(noise(100000)).size() < 100000 * 102 / 100);
}

TEST_CASE("bytes of very different frequencies come back: their codes would be too long") {
  // Each byte half as often as the one before, or 0.618 times, in blocks of 16384 bytes and more.
  for (const int percent : {50, 62, 75}) {
    const File dice = noise(60000, 7);
    File bytes;
    bytes.reserve(dice.size() / 2);
    for (std::size_t i = 0; i < dice.size() / 2; ++i) {
      std::uint32_t left = std::uint32_t{dice[2 * i]} << 8 | dice[2 * i + 1];
      std::uint8_t byte = 0;
      const auto part = static_cast<std::uint32_t>(percent);
      for (std::uint32_t all = 65536; byte < 40 && left < all * part / 100; ++byte)
        all = all * part / 100;
      bytes.push_back(byte);
    }
    CHECK(comes_back(bytes));
    CHECK(deflated(bytes, Packing::close).size() <= deflated(bytes).size());
  }
}

TEST_CASE("close packing finds what fast packing misses, and a period what is at its distance") {
  File rows;
  const File first = noise(3000);
  for (std::uint8_t row = 0; row < 20; ++row) {  // each row the first with other bytes in between
    rows.insert(rows.end(), first.begin(), first.end());
    for (std::size_t i = row; i < first.size(); i += 23) rows[row * 3000U + i] ^= 0x55U;
  }
  CHECK(deflated(rows, Packing::close).size() < deflated(rows).size());
  CHECK(deflated(rows, Packing::fast, 3000).size() < deflated(rows).size());
}
