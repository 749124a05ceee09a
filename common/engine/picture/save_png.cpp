// From a picture to a PNG file.
#include "engine/picture/save_png.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/measure/stopwatch.hpp"
#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/codecs/png_chunks.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

// The pixels as PNG stores them: each row begins with the number of its filter. Filter 1 in every
// row is each byte minus the one a pixel to its left; to try all five for each row saves nothing
// (docs/packages.md).
void filter_rows(const Image& image, std::uint8_t* to) {
  static_assert(sizeof(Rgb8) == 3);
  const std::size_t size = 3 * static_cast<std::size_t>(image.width);
  const auto* row = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
  for (int i = 0; i < image.height; ++i, row += size, to += size) {
    *to++ = 1;
    std::copy(row, row + 3, to);
    for (std::size_t k = 3; k < size; ++k) to[k] = static_cast<std::uint8_t>(row[k] - row[k - 3]);
  }
}

void append_big_endian(std::vector<std::uint8_t>& file, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) file.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// @param name  four letters
void append_chunk(std::vector<std::uint8_t>& file, std::string_view name, Bytes data) {
  append_big_endian(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = file.size();
  file.insert(file.end(), name.begin(), name.end());
  file.insert(file.end(), data.begin(), data.end());
  append_big_endian(file, crc32(Bytes(file).subspan(start)));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, Packing packing) {
  if (image.width < 0 || image.height < 0) throw FileError("its size is negative");
  const ImageSize size{static_cast<std::uint32_t>(image.width),
                       static_cast<std::uint32_t>(image.height)};
  check_image_size(size);
  if (image.pixels.size() != std::size_t{size.width} * size.height)
    throw FileError("the picture does not have as many pixels as its size says");

  const std::size_t row_bytes = 3 * std::size_t{size.width} + 1;
  const std::size_t all_bytes = row_bytes * size.height;
  // Memory as it comes: to clear it would take as long as to filter the rows.
  const auto rows = std::make_unique_for_overwrite<std::uint8_t[]>(all_bytes);
  filter_rows(image, rows.get());
  const std::size_t most = most_deflated_bytes(all_bytes);
  const auto room = std::make_unique_for_overwrite<std::uint8_t[]>(most);
  const std::size_t deflated =
      deflate({rows.get(), all_bytes}, {room.get(), most}, packing, row_bytes);

  std::vector<std::uint8_t> file(png_signature.begin(), png_signature.end());
  file.reserve(deflated + 64);
  std::vector<std::uint8_t> header;
  append_big_endian(header, size.width);
  append_big_endian(header, size.height);
  header.insert(header.end(), {8, 2, 0, 0, 0});  // bits a channel, RGB, and what PNG has one of
  append_chunk(file, "IHDR", header);
  append_chunk(file, "IDAT", {room.get(), deflated});
  append_chunk(file, "IEND", {});
  return file;
}

void check_output(const std::filesystem::path& path) {
  with_name("cannot write", path, [&] { check_writable(path); });
}

SavingTime save_png(const Image& image, const std::filesystem::path& path) {
  SavingTime time;
  with_name("cannot write", path, [&] {
    const Stopwatch encoding;
    const std::vector<std::uint8_t> bytes = encode_png(image);
    time.encode = encoding.milliseconds();
    const Stopwatch writing;
    write_file_atomically(path, bytes);
    time.write = writing.milliseconds();
  });
  return time;
}

}  // namespace texmap
