// From the bytes of a PNG file to a picture. libdeflate or stb_image only inflates: stb_image's PNG
// decoder checks no checksums, inflates without a limit and takes twice the memory
// (docs/packages.md).
#include "engine/files/read_png.hpp"

#ifdef TEXMAP_HAVE_LIBDEFLATE
#include <libdeflate.h>
#else
#include <stb_image.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/files/color_profile.hpp"
#include "engine/files/exif.hpp"
#include "engine/files/png_chunks.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

// A picture is stored as one pass, or as seven, each with every so many of its columns and rows.
struct Pass {
  std::uint32_t first_column, first_row, column_step, row_step;
  std::size_t columns = 0, rows = 0, row_bytes = 0;  // row_bytes without the byte of the filter
};

std::vector<Pass> passes_of(const PngHeader& header) {
  std::vector<Pass> passes = {{0, 0, 1, 1}};
  if (header.interlaced) {  // Adam7
    passes = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  }
  const auto count = [](std::uint32_t size, std::uint32_t first, std::uint32_t step) {
    return size <= first ? 0 : (size - first + step - 1) / step;
  };
  for (Pass& pass : passes) {
    pass.columns = count(header.size.width, pass.first_column, pass.column_step);
    if (pass.columns == 0) continue;  // and no rows
    pass.rows = count(header.size.height, pass.first_row, pass.row_step);
    pass.row_bytes = (pass.columns * header.channels * header.bit_depth + 7) / 8;
  }
  return passes;
}

// How many bytes a zlib stream unpacks to, and where its checksum may begin.
struct Unpacked {
  std::ptrdiff_t made = -1;  // -1: it is damaged, or they are too many
  std::size_t first = 0, last = 0;
};
Unpacked unpack(Bytes stream, std::span<std::uint8_t> to) {
#ifdef TEXMAP_HAVE_LIBDEFLATE
  // RFC 1950, section 2.2: two bytes say that it is deflate, without a dictionary. The checksum is
  // compared later, so that an error can name it.
  const std::uint32_t header = big_endian_16(stream, 0);
  if (header % 31 != 0 || (header & 0x0F20U) != 0x0800U) return {};
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
      decompressor(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!decompressor) throw std::bad_alloc();
  std::size_t used = 0, made = 0;
  const libdeflate_result result = libdeflate_deflate_decompress_ex(
      decompressor.get(), stream.data() + 2, stream.size() - 6, to.data(), to.size(), &used, &made);
  if (result != LIBDEFLATE_SUCCESS) return {};
  return {static_cast<std::ptrdiff_t>(made), 2 + used, 2 + used};
#else
  return {stbi_zlib_decode_buffer(reinterpret_cast<char*>(to.data()), static_cast<int>(to.size()),
                                  reinterpret_cast<const char*>(stream.data()),
                                  static_cast<int>(stream.size())),
          2, stream.size() - 4};
#endif
}

// Inflates the rows, all still filtered, into exactly as many bytes as the header promises. Some
// files have unused bytes behind the stream, to be ignored.
void inflate(Bytes compressed, std::span<std::uint8_t> rows) {
  const auto [made, first, last] = unpack(compressed, rows);
  const std::string promised = std::to_string(rows.size());
  if (made < 0)
    damaged_png("its pixels do not unpack to the " + promised + " bytes they should be");
  if (static_cast<std::size_t>(made) != rows.size())
    damaged_png("its pixels end after " + std::to_string(made) + " of " + promised + " bytes");
  const std::uint32_t sum = adler32(rows);
  std::size_t at = first;
  while (at <= last && big_endian_32(compressed, at) != sum) ++at;
  if (at > last) damaged_png("the checksum of its pixels is wrong");
}

std::uint8_t paeth(int left, int above, int corner) {
  const int to_left = std::abs(above - corner);
  const int to_above = std::abs(left - corner);
  const int to_corner = std::abs(left + above - 2 * corner);
  if (to_left <= to_above && to_left <= to_corner) return static_cast<std::uint8_t>(left);
  return static_cast<std::uint8_t>(to_above <= to_corner ? above : corner);
}

// Undoes one row's filter. `pixel`: bytes of a pixel, at least 1. `above`: zeros for the first row.
void unfilter(int filter, std::span<std::uint8_t> row, Bytes above, std::size_t pixel) {
  const auto add = [&](const auto& guess) {
    const std::size_t first = std::min(pixel, row.size());
    for (std::size_t i = 0; i < first; ++i)
      row[i] = static_cast<std::uint8_t>(row[i] + guess(0, above[i], 0));
    for (std::size_t i = first; i < row.size(); ++i) {
      row[i] =
          static_cast<std::uint8_t>(row[i] + guess(row[i - pixel], above[i], above[i - pixel]));
    }
  };
  if (filter == 1) add([](int left, int, int) { return left; });
  if (filter == 2) add([](int, int up, int) { return up; });
  if (filter == 3) add([](int left, int up, int) { return (left + up) / 2; });
  if (filter == 4) add(paeth);
  if (filter > 4) damaged_png("a row has filter " + std::to_string(filter));
}

// A channel of an unfiltered row, counted over all its pixels; in a row of a palette its number.
std::uint32_t sample_at(Bytes row, std::size_t i, std::size_t depth) {
  if (depth == 16) return big_endian_16(row, 2 * i);
  return row[i * depth / 8] >> (8 - depth - i * depth % 8) & ((1U << depth) - 1);
}

// The byte nearest to a channel of 16 bits.
std::uint8_t nearest_byte(std::uint32_t sample) {
  return static_cast<std::uint8_t>((sample + 128) / 257);
}

// How opaque a pixel of a row is: by its last channel, by its place in the palette, or not at all
// if it has the file's transparent color.
std::uint8_t alpha_of(const PngChunks& png, Bytes row, std::size_t i) {
  const std::size_t depth = png.header.bit_depth, channels = png.header.channels;
  if (png.header.color_type >= 4) {
    const std::uint32_t alpha = sample_at(row, (i + 1) * channels - 1, depth);
    return depth == 16 ? nearest_byte(alpha) : static_cast<std::uint8_t>(alpha);
  }
  if (png.header.color_type == 3) {
    const std::size_t color = sample_at(row, i, depth);
    return color < png.transparency.size() ? png.transparency[color] : 255;
  }
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const std::uint32_t key = big_endian_16(png.transparency, 2 * channel);
    if (sample_at(row, i * channels + channel, depth) != (key & ((1U << depth) - 1))) return 255;
  }
  return 0;
}

// Puts a row's pixels over black; true if one of them is not opaque.
bool put_over_black(const PngChunks& png, Bytes row, std::size_t columns, Rgb8* out,
                    std::size_t step) {
  bool any = false;
  for (std::size_t i = 0; i < columns; ++i) {
    const unsigned alpha = alpha_of(png, row, i);
    if (alpha == 255) continue;
    any = true;
    Rgb8& pixel = out[i * step];
    for (std::uint8_t* channel : {&pixel.r, &pixel.g, &pixel.b})
      *channel = static_cast<std::uint8_t>((*channel * alpha + 127) / 255);
  }
  return any;
}

// Makes pixels of an unfiltered row, each `step` places after the one before it.
void put_row(const PngChunks& png, Bytes row, std::size_t columns, Rgb8* out, std::size_t step) {
  const std::size_t depth = png.header.bit_depth;
  const std::size_t pixel = png.header.channels * depth / 8;
  const auto put = [&](const auto& color_of) {
    for (std::size_t i = 0; i < columns; ++i) out[i * step] = color_of(i);
  };
  if (pixel == sizeof(Rgb8) && step == 1) {
    std::memcpy(out, row.data(), row.size());
  } else if (png.header.channels == 1 && depth <= 8) {
    const unsigned largest = (1U << depth) - 1;
    put([&](std::size_t i) {
      const std::size_t sample = sample_at(row, i, depth);
      if (png.header.color_type != 3) {
        const auto grey = static_cast<std::uint8_t>(sample * (255 / largest));
        return Rgb8{grey, grey, grey};
      }
      if (3 * sample >= png.palette.size()) {
        damaged_png("a pixel has color " + std::to_string(sample) + " of a palette with " +
                    std::to_string(png.palette.size() / 3) + " colors");
      }
      const Bytes color = png.palette.subspan(3 * sample, 3);
      return Rgb8{color[0], color[1], color[2]};
    });
  } else {
    // Grey has its one channel three times.
    const std::size_t next = png.header.channels < 3 ? 0 : depth / 8;
    put([&](std::size_t i) {
      const std::uint8_t* const at = &row[i * pixel];
      if (depth == 8) return Rgb8{at[0], at[next], at[2 * next]};
      const auto byte = [at](std::size_t n) { return nearest_byte(at[n] * 256U + at[n + 1]); };
      return Rgb8{byte(0), byte(next), byte(2 * next)};
    });
  }
}

// The same for 16 bits a channel, all of which are kept. Grey has its one channel three times.
void put_row(const PngChunks& png, Bytes row, std::size_t columns, Rgb16* out, std::size_t step) {
  const std::size_t channels = png.header.channels, next = channels < 3 ? 0 : 1;
  for (std::size_t i = 0; i < columns; ++i) {
    const auto channel = [&](std::size_t n) {
      return static_cast<std::uint16_t>(sample_at(row, i * channels + n, 16));
    };
    out[i * step] = {channel(0), channel(next), channel(2 * next)};
  }
}

// The picture in the parts of a file. `note`: transparent pixels are put over black, and noted.
template <class Pixel>
Grid<Pixel> read_pixels(Bytes file, const PngChunks& png, std::string* note, int later_bytes) {
  const PngHeader& header = png.header;
  std::vector<std::uint8_t> joined;
  if (png.compressed.size() > 1) {
    joined.reserve(file.size());
    for (const Bytes piece : png.compressed)
      joined.insert(joined.end(), piece.begin(), piece.end());
  }
  const Bytes compressed = joined.empty() ? png.compressed[0] : joined;

  const std::vector<Pass> passes = passes_of(header);
  std::size_t promised = 0;
  for (const Pass& pass : passes) promised += pass.rows * (1 + pass.row_bytes);
  // One pass needs no memory of its own: its rows lie at the end of the picture's memory, and the
  // pixels of a row end before the next row begins.
  const std::size_t area = std::size_t{header.size.width} * header.size.height;
  const std::size_t own_room = header.interlaced ? promised : 0;
  const std::size_t shared_room =
      header.interlaced ? area : std::max(area, promised / sizeof(Pixel) + 1);
  const std::size_t turned_room = png.order == PixelOrder{} ? 0 : area;
  check_memory(2 * file.size() + own_room + (shared_room + turned_room) * sizeof(Pixel),
               area * static_cast<std::size_t>(later_bytes));
  // Two bytes of header, four of checksum, and deflate makes at most 1032 bytes out of one.
  if (compressed.size() < 6 || promised / 1032 > compressed.size())
    damaged_png("it has too few bytes for its size in pixels");

  Grid<Pixel> image;
  image.width = static_cast<int>(header.size.width);
  image.height = static_cast<int>(header.size.height);
  image.pixels.resize(shared_room);
  std::vector<std::uint8_t> own(own_room);
  const std::span<std::uint8_t> shared(reinterpret_cast<std::uint8_t*>(image.pixels.data()),
                                       shared_room * sizeof(Pixel));
  std::span<std::uint8_t> rest = header.interlaced ? own : shared.last(promised);
  inflate(compressed, rest);

  [[maybe_unused]] const bool may_show_black =
      note != nullptr && (header.color_type >= 4 || !png.transparency.empty());
  bool shows_black = false;
  const std::size_t pixel = std::max(1U, header.channels * header.bit_depth / 8);
  for (const Pass& pass : passes) {
    std::vector<std::uint8_t> row(pass.row_bytes);
    std::vector<std::uint8_t> above(pass.row_bytes);
    for (std::size_t r = 0; r < pass.rows; ++r) {
      std::copy_n(&rest[1], pass.row_bytes, row.begin());
      unfilter(rest[0], row, above, pixel);
      rest = rest.subspan(1 + pass.row_bytes);
      Pixel* const first = &image.at(static_cast<int>(pass.first_column),
                                     static_cast<int>(pass.first_row + r * pass.row_step));
      put_row(png, row, pass.columns, first, pass.column_step);
      if constexpr (std::is_same_v<Pixel, Rgb8>) {
        if (may_show_black && put_over_black(png, row, pass.columns, first, pass.column_step))
          shows_black = true;
      }
      row.swap(above);
    }
  }
  image.pixels.resize(area);
  if (shows_black) add_note(*note, "has transparent texels: they are drawn over black");
  if (png.order == PixelOrder{}) return image;
  return png.order.picture(image.width, image.height,
                           [&](int column, int row) { return image.at(column, row); });
}

// What the user should know of colors that are not sRGB's.
std::string note_on_colors(const PngChunks& png) {
  if (!png.color_code.empty()) {
    const int primaries = png.color_code[0], curve = png.color_code[1];
    if (png.color_code[3] != 1) return not_in_srgb("the range of video (cICP)");
    return primaries == 1 && curve == 13  // BT.709's, which are sRGB's, and sRGB's curve
               ? ""
               : not_in_srgb(text("the space of the numbers %d and %d (cICP)", primaries, curve));
  }
  if (png.gamma != 0 && (png.gamma < 40000 || png.gamma > 51000)) {
    return text("is encoded by gamma %.3g: it is drawn as if by sRGB's curve, which is near 2.2",
                1e5 / png.gamma);
  }
  constexpr std::array<int, 8> of_srgb = {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
  for (std::size_t i = 0; 4 * i < png.primaries.size(); ++i) {
    if (std::abs(std::int64_t{big_endian_32(png.primaries, 4 * i)} - of_srgb[i]) > 1000)
      return not_in_srgb("a space with primaries of its own (cHRM)");
  }
  if (png.profile.size() < 6) return {};
  std::vector<std::uint8_t> profile(1 << 16);  // larger ones are not looked at
  const std::ptrdiff_t size = unpack(png.profile, profile).made;
  return size < 0 ? "" : note_on_profile(Bytes(profile).first(static_cast<std::size_t>(size)));
}

}  // namespace

bool looks_like_png(Bytes file) {
  return file.size() >= png_signature.size() &&
         std::equal(png_signature.begin(), png_signature.end(), file.begin());
}

Image read_png(Bytes file, std::string* note, DeepImage* deep, int later_bytes) {
  const PngChunks png = read_png_chunks(file);
  if (note != nullptr) {
    *note = png.order == PixelOrder{} ? "" : turned_by_exif;
    if (deep == nullptr) add_note(*note, note_on_colors(png));
  }
  if (deep != nullptr && png.header.bit_depth == 16) {
    *deep = read_pixels<Rgb16>(file, png, nullptr, later_bytes);
    return {};
  }
  return read_pixels<Rgb8>(file, png, deep == nullptr ? note : nullptr, later_bytes);
}

}  // namespace texmap
