// PNG files of 16 bits a channel, which the course reads and does not write.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/files/png_chunks.hpp"

namespace texmap::test {

/// An RGB file of one row: three numbers of 16 bits for each texel, not compressed.
inline std::vector<std::uint8_t> deep_png(const std::vector<std::uint16_t>& samples) {
  using File = std::vector<std::uint8_t>;
  const auto put = [](File& to, std::uint32_t number, int bytes) {
    while (bytes-- > 0) to.push_back(static_cast<std::uint8_t>(number >> 8 * bytes));
  };
  File file(png_signature.begin(), png_signature.end());
  const auto add_chunk = [&](std::string_view name, const File& data) {
    put(file, static_cast<std::uint32_t>(data.size()), 4);
    const std::size_t begin = file.size();
    file.insert(file.end(), name.begin(), name.end());
    file.insert(file.end(), data.begin(), data.end());
    put(file, crc32(Bytes(file).subspan(begin)), 4);
  };
  File header;
  put(header, static_cast<std::uint32_t>(samples.size() / 3), 4);
  put(header, 1, 4);
  header.insert(header.end(), {16, 2, 0, 0, 0});
  add_chunk("IHDR", header);
  File row = {0};
  for (const std::uint16_t sample : samples) put(row, sample, 2);
  const auto low = static_cast<std::uint8_t>(row.size()), high = std::uint8_t(row.size() >> 8);
  File stream = {0x78, 1, 1, low, high, std::uint8_t(~low), std::uint8_t(~high)};
  stream.insert(stream.end(), row.begin(), row.end());
  put(stream, adler32(row), 4);
  add_chunk("IDAT", stream);
  add_chunk("IEND", {});
  return file;
}

}  // namespace texmap::test
