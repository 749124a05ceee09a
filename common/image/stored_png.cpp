// A PNG file with nothing to unpack in it.
#include "stored_png.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace texmap {
namespace {

constexpr std::size_t longest_block = 65535;  // bytes that a stored block of deflate can hold

using File = std::vector<std::uint8_t>;

void add(File& file, Bytes bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); }

void add_big_endian_32(File& file, std::size_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) file.push_back(static_cast<std::uint8_t>((number >> shift) & 0xFFU));
}

void begin_chunk(File& file, std::string_view type, std::size_t length) {
  add_big_endian_32(file, length);
  file.insert(file.end(), type.begin(), type.end());
}

void end_chunk(File& file) { add_big_endian_32(file, 0); }

void add_chunk(File& file, std::string_view type, Bytes data) {
  begin_chunk(file, type, data.size());
  add(file, data);
  end_chunk(file);
}

void add_stored_block(File& file, Bytes block, bool last) {
  const std::size_t length = block.size();
  file.push_back(last ? 1 : 0);
  for (const std::size_t number : {length, ~length}) {
    file.push_back(static_cast<std::uint8_t>(number & 0xFFU));
    file.push_back(static_cast<std::uint8_t>((number >> 8) & 0xFFU));
  }
  add(file, block);
}

}  // namespace

std::vector<std::uint8_t> stored_png(const PngChunks& png, Bytes rows) {
  const std::size_t blocks = (rows.size() + longest_block - 1) / longest_block;
  const std::size_t stream = 2 + 5 * blocks + rows.size() + 4;
  File file(png_signature.begin(), png_signature.end());
  file.reserve(stream + png.palette.size() + 100);
  add_chunk(file, "IHDR", png.header_bytes);
  if (!png.palette.empty()) add_chunk(file, "PLTE", png.palette);
  begin_chunk(file, "IDAT", stream);
  file.insert(file.end(), {0x78, 0x01});  // zlib: deflate with a window of 32 KiB
  for (std::size_t block = 0; block < blocks; ++block) {
    const Bytes left = rows.subspan(block * longest_block);
    add_stored_block(file, left.first(std::min(left.size(), longest_block)), block + 1 == blocks);
  }
  add_big_endian_32(file, 0);
  end_chunk(file);
  add_chunk(file, "IEND", {});
  return file;
}

}  // namespace texmap
