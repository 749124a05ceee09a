// The parts of a PNG file, each checked before the next is looked at, and its two checksums: by
// libdeflate or by their definitions.
#include "engine/files/png_chunks.hpp"

#ifdef TEXMAP_HAVE_LIBDEFLATE
#include <libdeflate.h>
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/files/exif.hpp"
#include "engine/files/file_error.hpp"

namespace texmap {

#ifdef TEXMAP_HAVE_LIBDEFLATE

std::uint32_t crc32(Bytes bytes) { return libdeflate_crc32(0, bytes.data(), bytes.size()); }
std::uint32_t adler32(Bytes bytes) { return libdeflate_adler32(1, bytes.data(), bytes.size()); }

#else

std::uint32_t crc32(Bytes bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t byte = 0; byte < made.size(); ++byte) {
      std::uint32_t crc = byte;
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
      made[byte] = crc;
    }
    return made;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) crc = (crc >> 8) ^ table[(crc ^ byte) & 0xFFU];
  return ~crc;
}

std::uint32_t adler32(Bytes bytes) {
  constexpr std::size_t before_overflow = 5552;  // bytes of 255 that keep both sums below 2^32
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  while (!bytes.empty()) {
    const Bytes part = bytes.first(std::min(bytes.size(), before_overflow));
    for (const std::uint8_t byte : part) {
      a += byte;
      b += a;
    }
    a %= 65521;
    b %= 65521;
    bytes = bytes.subspan(part.size());
  }
  return (b << 16) | a;
}

#endif

namespace {

void require(bool holds, const char* otherwise) {
  if (!holds) damaged_png(otherwise);
}

struct Chunk {
  std::string_view type;  // four letters
  Bytes data;
};

bool is_letter(std::uint8_t byte) {
  return (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z');
}

// The chunk at the front of `rest`, which is left without it.
Chunk take_chunk(Bytes& rest) {
  if (rest.size() < 12)
    throw FileError("the PNG file is cut short: its end marker (IEND) is missing");
  const std::size_t length = big_endian_32(rest, 0);
  const Bytes type = rest.subspan(4, 4);
  require(std::all_of(type.begin(), type.end(), is_letter), "a chunk has no proper name");
  const std::string name(type.begin(), type.end());
  if (length > rest.size() - 12) {
    throw FileError("the PNG file is cut short: its " + name + " chunk should have " +
                    std::to_string(length) + " bytes, and " + std::to_string(rest.size() - 12) +
                    " are there");
  }
  if (crc32(rest.subspan(4, 4 + length)) != big_endian_32(rest, 8 + length))
    damaged_png("the checksum of its " + name + " chunk is wrong");
  const Bytes data = rest.subspan(8, length);
  rest = rest.subspan(12 + length);
  return {{reinterpret_cast<const char*>(type.data()), 4}, data};
}

struct ColorType {
  std::uint32_t channels = 0;
  std::uint32_t bit_depths = 0;  // the sum of those that are legal
};
constexpr std::array<ColorType, 7> color_types = {
    {{1, 1 + 2 + 4 + 8 + 16}, {}, {3, 8 + 16}, {1, 1 + 2 + 4 + 8}, {2, 8 + 16}, {}, {4, 8 + 16}}};

PngHeader read_header(Bytes data) {
  require(data.size() == 13, "its header (IHDR) has not 13 bytes");
  PngHeader header{{big_endian_32(data, 0), big_endian_32(data, 4)}, data[8], data[9]};
  const ColorType type =
      header.color_type < color_types.size() ? color_types[header.color_type] : ColorType{};
  if (!std::has_single_bit(header.bit_depth) || (header.bit_depth & type.bit_depths) == 0) {
    damaged_png("color type " + std::to_string(header.color_type) + " with " +
                std::to_string(header.bit_depth) + " bits does not exist");
  }
  require(data[10] == 0 && data[11] == 0 && data[12] <= 1,
          "it asks for a compression, filter or interlace method that does not exist");
  header.interlaced = data[12] == 1;
  header.channels = type.channels;
  check_image_size(header.size);
  return header;
}

void check_palette(const PngHeader& header, Bytes data) {
  require(header.color_type != 0 && header.color_type != 4, "a grey picture has a palette (PLTE)");
  const std::size_t most = std::size_t{1} << (header.color_type == 3 ? header.bit_depth : 8);
  if (data.empty() || data.size() % 3 != 0 || data.size() / 3 > most) {
    damaged_png("its palette (PLTE) must have 1 to " + std::to_string(most) +
                " colors of 3 bytes, and has " + std::to_string(data.size()) + " bytes");
  }
}

void check_transparency(const PngHeader& header, std::size_t palette_colors, Bytes data) {
  const bool palette = header.color_type == 3;
  require(!palette || palette_colors > 0, "transparency (tRNS) comes before the palette");
  require(header.color_type <= 3, "a picture with an alpha channel also has transparency (tRNS)");
  const std::size_t most = palette ? palette_colors : std::size_t{2} * header.channels;
  if (data.empty() || data.size() > most || (!palette && data.size() != most)) {
    damaged_png("its transparency (tRNS) has " + std::to_string(data.size()) +
                " bytes instead of " + std::to_string(most));
  }
}

}  // namespace

void damaged_png(const std::string& how) { throw FileError("the PNG file is damaged: " + how); }

PngChunks read_png_chunks(Bytes file) {
  Bytes rest = file.subspan(png_signature.size());
  PngChunks found;
  bool image_data_ended = false, is_srgb = false;

  // The header comes first, and nothing is believed before it.
  const Chunk first = take_chunk(rest);
  require(first.type == "IHDR", "it does not begin with its header (IHDR)");
  found.header = read_header(first.data);

  while (true) {
    const auto [type, data] = take_chunk(rest);
    const bool image_data = !found.compressed.empty();
    if (image_data && type != "IDAT") image_data_ended = true;

    if (type == "IEND") {
      require(data.empty(), "its end marker (IEND) is not empty");
      require(image_data, "it has no pixels (IDAT)");
      if (!found.color_code.empty()) found.profile = {};
      if (is_srgb || !found.color_code.empty() || !found.profile.empty()) {
        found.primaries = {};
        found.gamma = 0;
      }
      return found;
    }
    require(type != "IHDR", "it has two headers (IHDR)");
    if (type == "PLTE") {
      require(found.palette.empty(), "it has two palettes (PLTE)");
      require(!image_data, "its palette (PLTE) comes after the pixels");
      require(found.transparency.empty(), "its palette (PLTE) comes after the transparency (tRNS)");
      check_palette(found.header, data);
      found.palette = data;
    } else if (type == "tRNS") {
      require(found.transparency.empty(), "it has two transparencies (tRNS)");
      require(!image_data, "its transparency (tRNS) comes after the pixels");
      check_transparency(found.header, found.palette.size() / 3, data);
      found.transparency = data;
    } else if (type == "eXIf") {
      if (found.order == PixelOrder{}) found.order = order_of_exif(data);
    } else if (type == "iCCP") {  // a name, a 0, the method, the stream
      const auto end = std::find(data.begin(), data.end(), std::uint8_t{0});
      if (data.end() - end > 2)
        found.profile = data.last(static_cast<std::size_t>(data.end() - end - 2));
    } else if (type == "gAMA" && data.size() == 4) {
      found.gamma = big_endian_32(data, 0);
    } else if (type == "cHRM" && data.size() == 32) {
      found.primaries = data;
    } else if (type == "cICP" && data.size() == 4) {
      found.color_code = data;
    } else if (type == "sRGB") {
      is_srgb = true;
    } else if (type == "IDAT") {
      require(!image_data_ended, "its pixels (IDAT) are not in one piece");
      require(found.header.color_type != 3 || !found.palette.empty(),
              "its palette (PLTE) is missing");
      found.compressed.push_back(data);
    } else if (type[0] >= 'A' && type[0] <= 'Z') {
      // A capital first letter says: whoever does not know this chunk cannot show the picture.
      throw FileError("the PNG file needs a feature that this program does not know (chunk " +
                      std::string(type) + ")");
    }
  }
}

}  // namespace texmap
