// From a picture to a PNG file. libdeflate or stb_image_write compresses its rows.
#include "engine/files/save_png.hpp"

#ifdef TEXMAP_HAVE_LIBDEFLATE
#include <libdeflate.h>
#else
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include "engine/files/image_limits.hpp"
#include "engine/files/png_chunks.hpp"
#include "engine/files/stopwatch.hpp"
#include "engine/files/system.hpp"

namespace texmap {
namespace {

using File = std::vector<std::uint8_t>;

/// The pixels as PNG stores them, row by row: filter 0 as they are, filter 1 each byte less the one
/// a pixel to its left. Memory as it comes, for clearing it takes as long; libc++ 14 has no
/// make_unique_for_overwrite.
std::unique_ptr<std::uint8_t[]> filtered_rows(const Image& image, std::uint8_t filter) {
  static_assert(sizeof(Rgb8) == 3);
  const std::size_t size = 3 * static_cast<std::size_t>(image.width);
  std::unique_ptr<std::uint8_t[]> rows(
      new std::uint8_t[(size + 1) * static_cast<std::size_t>(image.height)]);
  std::uint8_t* to = rows.get();
  const auto* row = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
  for (int i = 0; i < image.height; ++i, row += size, to += size) {
    *to++ = filter;
    std::copy(row, row + size, to);
    for (std::size_t k = 3; filter == 1 && k < size; ++k)
      to[k] = static_cast<std::uint8_t>(row[k] - row[k - 3]);
  }
  return rows;
}

void append_big_endian(File& file, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) file.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// @param name  four letters
void append_chunk(File& file, std::string_view name, Bytes data) {
  append_big_endian(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = file.size();
  file.insert(file.end(), name.begin(), name.end());
  file.insert(file.end(), data.begin(), data.end());
  append_big_endian(file, crc32(Bytes(file).subspan(start)));
}

}  // namespace

#ifdef TEXMAP_HAVE_LIBDEFLATE

std::vector<std::uint8_t> deflate(Bytes bytes, Packing packing) {
  // Level 1 takes longer for pictures than level 2, which looks for fewer long repetitions.
  // Level 12 takes twice as long as 11, for 2 % of the bytes.
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(packing == Packing::close ? 11 : 2), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  // Memory as it comes: to clear it would take a tenth of the time.
  const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), bytes.size());
  const std::unique_ptr<std::uint8_t[]> room(new std::uint8_t[most]);
  const std::size_t size =
      libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), room.get(), most);
  return {room.get(), room.get() + size};
}

#else

std::vector<std::uint8_t> deflate(Bytes bytes, Packing packing) {
  int size = 0;
  const std::unique_ptr<std::uint8_t, decltype(&std::free)> stream(
      stbi_zlib_compress(const_cast<std::uint8_t*>(bytes.data()), static_cast<int>(bytes.size()),
                         &size, packing == Packing::close ? 64 : 5),
      std::free);
  if (!stream) throw std::bad_alloc();
  return {stream.get(), stream.get() + size};
}

#endif

std::vector<std::uint8_t> encode_png(const Image& image, Packing packing) {
  if (image.width < 0 || image.height < 0) throw FileError("its size is negative");
  const ImageSize size{static_cast<std::uint32_t>(image.width),
                       static_cast<std::uint32_t>(image.height)};
  check_image_size(size);
  if (image.pixels.size() != std::size_t{size.width} * size.height)
    throw FileError("the picture does not have as many pixels as its size says");

  File header;
  append_big_endian(header, size.width);
  append_big_endian(header, size.height);
  header.insert(header.end(), {8, 2, 0, 0, 0});  // bits a channel, RGB, and what PNG has one of
  File file(png_signature.begin(), png_signature.end());
  const std::size_t bytes = (3 * std::size_t{size.width} + 1) * size.height;
  const auto packed = [&](std::uint8_t filter, Packing how) {
    return deflate({filtered_rows(image, filter).get(), bytes}, how);
  };
  File stream = packed(1, Packing::fast);
  if (packing == Packing::close)  // the filter that is better for fast packing is for close, too
    stream = packed(packed(0, Packing::fast).size() < stream.size() ? 0 : 1, packing);
  append_chunk(file, "IHDR", header);
  append_chunk(file, "IDAT", stream);
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
