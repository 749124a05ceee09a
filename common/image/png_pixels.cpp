// The rows of a PNG picture: out of the compressed stream, and checked to the last byte.
#include "png_pixels.hpp"

#include <stb_image.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <string>

#include "checksums.hpp"
#include "image_error.hpp"

namespace texmap {
namespace {

// A picture is stored as one pass, or as seven, each with every so many of its columns and rows.
struct Pass {
  std::uint32_t first_column, first_row, column_step, row_step;
};
constexpr std::array<Pass, 1> whole_picture = {{{0, 0, 1, 1}}};
constexpr std::array<Pass, 7> adam7 = {
    {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};

std::span<const Pass> passes(const PngHeader& header) {
  if (header.interlaced) return adam7;
  return whole_picture;
}

std::uint32_t count(std::uint32_t size, std::uint32_t first, std::uint32_t step) {
  return size <= first ? 0 : (size - first + step - 1) / step;
}

struct PassSize {
  std::uint32_t columns, rows;
  std::uint64_t row_bytes;  // without the filter byte
};

PassSize pass_size(const PngHeader& header, const Pass& pass) {
  const std::uint32_t columns = count(header.width, pass.first_column, pass.column_step);
  const std::uint32_t rows = count(header.height, pass.first_row, pass.row_step);
  if (columns == 0 || rows == 0) return {0, 0, 0};
  const std::uint64_t bits = std::uint64_t{columns} * png_channels(header.color_type) * header.bit_depth;
  return {columns, rows, (bits + 7) / 8};
}

LargeArray<std::uint8_t> inflate(const PngChunks& png) {
  const std::size_t promised = promised_bytes(png.header);
  const std::size_t given = png.compressed.size();
  // Two bytes of header, four of checksum, and deflate makes at most 1032 bytes out of one.
  if (given < 6 || promised / 1032 > given)
    throw Refusal("the PNG file is damaged: it has too few bytes for its size in pixels");

  LargeArray<std::uint8_t> rows(promised);
  const int made = stbi_zlib_decode_buffer(reinterpret_cast<char*>(rows.data()), static_cast<int>(promised),
                                           reinterpret_cast<const char*>(png.compressed.data()), static_cast<int>(given));
  if (made < 0) {
    throw Refusal("the PNG file is damaged: its pixels do not unpack to the " + std::to_string(promised) +
                  " bytes they should be");
  }
  if (static_cast<std::size_t>(made) != promised) {
    throw Refusal("the PNG file is damaged: its pixels end after " + std::to_string(made) + " of " + std::to_string(promised) +
                  " bytes");
  }
  if (adler32(rows) != big_endian_32(png.compressed, given - 4)) {
    throw Refusal("the PNG file is damaged: the checksum of its pixels is wrong");
  }
  return rows;
}

std::uint8_t paeth(int left, int above, int corner) {
  const int to_left = std::abs(above - corner);
  const int to_above = std::abs(left - corner);
  const int to_corner = std::abs(left + above - 2 * corner);
  if (to_left <= to_above && to_left <= to_corner) return static_cast<std::uint8_t>(left);
  return static_cast<std::uint8_t>(to_above <= to_corner ? above : corner);
}

// Undoes the filter of one row. `pixel` is the bytes of a pixel, at least 1; above the first row there is one of zeros.
void unfilter(int filter, std::span<std::uint8_t> row, Bytes above, std::size_t pixel) {
  const auto add = [&](const auto& guess) {
    const std::size_t first = std::min(pixel, row.size());
    for (std::size_t i = 0; i < first; ++i) row[i] = static_cast<std::uint8_t>(row[i] + guess(0, above[i], 0));
    for (std::size_t i = first; i < row.size(); ++i) {
      row[i] = static_cast<std::uint8_t>(row[i] + guess(row[i - pixel], above[i], above[i - pixel]));
    }
  };
  if (filter == 1) add([](int left, int, int) { return left; });
  if (filter == 2) add([](int, int up, int) { return up; });
  if (filter == 3) add([](int left, int up, int) { return (left + up) / 2; });
  if (filter == 4) add(paeth);
}

void check_filters(const PngHeader& header, Bytes rows) {
  std::size_t place = 0;
  for (const Pass& pass : passes(header)) {
    const PassSize size = pass_size(header, pass);
    for (std::uint32_t row = 0; row < size.rows; ++row) {
      if (rows[place] > 4) throw Refusal("the PNG file is damaged: a row has filter " + std::to_string(rows[place]));
      place += 1 + size.row_bytes;
    }
  }
}

// The largest palette index of an unfiltered row; the bits after its last pixel mean nothing.
std::uint32_t largest_index(Bytes row, std::uint32_t columns, std::uint32_t bit_depth) {
  const std::uint32_t in_a_byte = 8 / bit_depth;
  const std::uint32_t mask = (1U << bit_depth) - 1;
  std::uint32_t largest = 0;
  for (std::uint32_t column = 0; column < columns; ++column) {
    const std::uint32_t shift = 8 - bit_depth * (column % in_a_byte + 1);
    const std::uint32_t index = (std::uint32_t{row[column / in_a_byte]} >> shift) & mask;
    if (index > largest) largest = index;
  }
  return largest;
}

void check_palette_indices(const PngHeader& header, std::size_t colors, LargeArray<std::uint8_t> rows) {
  std::size_t place = 0;
  for (const Pass& pass : passes(header)) {
    const PassSize size = pass_size(header, pass);
    const std::vector<std::uint8_t> zeros(size.row_bytes);
    Bytes above = zeros;
    for (std::uint32_t r = 0; r < size.rows; ++r) {
      const std::span<std::uint8_t> row = std::span(rows).subspan(place + 1, size.row_bytes);
      unfilter(rows[place], row, above, 1);
      const std::uint32_t largest = largest_index(row, size.columns, header.bit_depth);
      if (largest >= colors) {
        throw Refusal("the PNG file is damaged: a pixel has color " + std::to_string(largest) + " of a palette with " +
                      std::to_string(colors) + " colors");
      }
      above = row;
      place += 1 + size.row_bytes;
    }
  }
}

}  // namespace

std::uint64_t promised_bytes(const PngHeader& header) {
  std::uint64_t bytes = 0;
  for (const Pass& pass : passes(header)) {
    const PassSize size = pass_size(header, pass);
    bytes += size.rows * (1 + size.row_bytes);
  }
  return bytes;
}

std::uint64_t png_decoding_bytes(const PngHeader& header) {
  const std::uint64_t area = std::uint64_t{header.width} * header.height;
  const std::uint64_t sample = header.bit_depth == 16 ? 2 : 1;
  const std::uint64_t decoded = area * sample * (png_channels(header.color_type) + (header.color_type < 3 ? 1 : 0));
  const std::uint64_t rows = promised_bytes(header);
  // The decoder underestimates the rows of an interlaced picture and then doubles their room; it holds a pass besides.
  const std::uint64_t unpacked = header.interlaced ? 2 * rows + decoded + decoded / 2 : rows + decoded;
  const std::uint64_t converted = decoded + area * sample * 3;
  return header.color_type == 3 ? unpacked + 3 * area : std::max(unpacked, converted);
}

LargeArray<std::uint8_t> read_png_pixels(const PngChunks& png) {
  LargeArray<std::uint8_t> rows = inflate(png);
  check_filters(png.header, rows);
  // stb_image would show whatever happens to lie in memory behind a palette that is too short.
  const std::size_t colors = png.palette.size() / 3;
  if (png.header.color_type == 3 && colors < std::size_t{1} << png.header.bit_depth) {
    check_palette_indices(png.header, colors, rows);
  }
  return rows;
}

bool is_plain(const PngHeader& header) { return header.bit_depth == 8 && !header.interlaced; }

Image image_of_png_rows(const PngChunks& png, LargeArray<std::uint8_t> rows) {
  const std::size_t pixel = png_channels(png.header.color_type);
  Image image(static_cast<int>(png.header.width), static_cast<int>(png.header.height));
  const std::size_t columns = png.header.width;
  const std::vector<std::uint8_t> zeros(columns * pixel);
  Bytes above = zeros;
  for (std::size_t r = 0; r < png.header.height; ++r) {
    const std::size_t place = r * (1 + columns * pixel);
    const std::span<std::uint8_t> row = std::span(rows).subspan(place + 1, columns * pixel);
    unfilter(rows[place], row, above, pixel);
    above = row;
    Rgb8* const out = &image.pixels[r * columns];
    const auto fill = [&](const auto& color_of) {
      for (std::size_t i = 0; i < columns; ++i) out[i] = color_of(&row[i * pixel]);
    };
    if (png.header.color_type == 3) {
      fill([&](const std::uint8_t* at) {
        const Bytes color = png.palette.subspan(std::size_t{3} * *at, 3);
        return Rgb8{color[0], color[1], color[2]};
      });
    } else if (pixel < 3) {
      fill([](const std::uint8_t* at) { return Rgb8{at[0], at[0], at[0]}; });
    } else {
      fill([](const std::uint8_t* at) { return Rgb8{at[0], at[1], at[2]}; });
    }
  }
  return image;
}

}  // namespace texmap
