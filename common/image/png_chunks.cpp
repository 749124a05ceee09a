// The parts of a PNG file, each checked before the next is looked at.
#include "png_chunks.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "checksums.hpp"
#include "image_error.hpp"
#include "image_limits.hpp"

namespace texmap {
namespace {

struct Chunk {
  std::string_view type;  // four letters
  Bytes data;
};

bool is_letter(std::uint8_t byte) { return (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z'); }

// The chunk at the front of `rest`, which is left without it.
Chunk take_chunk(Bytes& rest) {
  if (rest.size() < 12) throw Refusal("the PNG file is cut short: its end marker (IEND) is missing");
  const std::size_t length = big_endian_32(rest, 0);
  const Bytes type = rest.subspan(4, 4);
  if (!std::all_of(type.begin(), type.end(), is_letter)) throw Refusal("the PNG file is damaged: a chunk has no proper name");
  const std::string_view name(reinterpret_cast<const char*>(type.data()), type.size());
  if (length > rest.size() - 12) {
    throw Refusal("the PNG file is cut short: its " + std::string(name) + " chunk should have " + std::to_string(length) +
                  " bytes, and " + std::to_string(rest.size() - 12) + " are there");
  }
  if (crc32(rest.subspan(4, 4 + length)) != big_endian_32(rest, 8 + length)) {
    throw Refusal("the PNG file is damaged: the checksum of its " + std::string(name) + " chunk is wrong");
  }
  const Bytes data = rest.subspan(8, length);
  rest = rest.subspan(12 + length);
  return {name, data};
}

bool is_legal(std::uint32_t color_type, std::uint32_t bit_depth) {
  switch (color_type) {
    case 0:
      return bit_depth == 1 || bit_depth == 2 || bit_depth == 4 || bit_depth == 8 || bit_depth == 16;
    case 3:
      return bit_depth == 1 || bit_depth == 2 || bit_depth == 4 || bit_depth == 8;
    case 2:
    case 4:
    case 6:
      return bit_depth == 8 || bit_depth == 16;
    default:
      return false;
  }
}

PngHeader read_header(Bytes data) {
  if (data.size() != 13) throw Refusal("the PNG file is damaged: its header (IHDR) has not 13 bytes");
  const std::uint32_t interlace = data[12];
  const PngHeader header{big_endian_32(data, 0), big_endian_32(data, 4), data[8], data[9], interlace == 1};
  if (!is_legal(header.color_type, header.bit_depth)) {
    throw Refusal("the PNG file is damaged: color type " + std::to_string(header.color_type) + " with " +
                  std::to_string(header.bit_depth) + " bits does not exist");
  }
  if (data[10] != 0 || data[11] != 0 || interlace > 1) {
    throw Refusal("the PNG file is damaged: it asks for a compression, filter or interlace method that does not exist");
  }
  check_image_size(header.width, header.height);
  return header;
}

void check_palette(const PngHeader& header, Bytes data) {
  if (header.color_type == 0 || header.color_type == 4) {
    throw Refusal("the PNG file is damaged: a grey picture has a palette (PLTE)");
  }
  const std::size_t most = header.color_type == 3 ? std::size_t{1} << header.bit_depth : std::size_t{256};
  if (data.empty() || data.size() % 3 != 0 || data.size() / 3 > most) {
    throw Refusal("the PNG file is damaged: its palette (PLTE) must have 1 to " + std::to_string(most) +
                  " colors of 3 bytes, and has " + std::to_string(data.size()) + " bytes");
  }
}

void check_transparency(const PngHeader& header, std::size_t palette_colors, Bytes data) {
  const bool palette = header.color_type == 3;
  if (palette && palette_colors == 0) throw Refusal("the PNG file is damaged: transparency (tRNS) comes before the palette");
  if (header.color_type > 3) throw Refusal("the PNG file is damaged: a picture with alpha has transparency (tRNS) besides");
  const std::size_t most = palette ? palette_colors : std::size_t{2} * png_channels(header.color_type);
  if (data.empty() || data.size() > most || (!palette && data.size() != most)) {
    throw Refusal("the PNG file is damaged: its transparency (tRNS) has " + std::to_string(data.size()) + " bytes instead of " +
                  std::to_string(most));
  }
}

}  // namespace

bool looks_like_png(Bytes file) {
  return file.size() >= png_signature.size() && std::equal(png_signature.begin(), png_signature.end(), file.begin());
}

std::uint32_t png_channels(std::uint32_t color_type) {
  switch (color_type) {
    case 2:
      return 3;
    case 4:
      return 2;
    case 6:
      return 4;
    default:
      return 1;
  }
}

PngChunks read_png_chunks(Bytes file) {
  Bytes rest = file.subspan(png_signature.size());
  PngChunks found;
  bool transparency = false;
  bool image_data = false;
  bool image_data_ended = false;

  // The header comes first, and nothing is believed before it.
  const Chunk first = take_chunk(rest);
  if (first.type != "IHDR") throw Refusal("the PNG file is damaged: it does not begin with its header (IHDR)");
  found.header = read_header(first.data);
  found.header_bytes = first.data;

  while (true) {
    const Chunk chunk = take_chunk(rest);
    if (image_data && chunk.type != "IDAT") image_data_ended = true;

    if (chunk.type == "IEND") {
      if (!chunk.data.empty()) throw Refusal("the PNG file is damaged: its end marker (IEND) is not empty");
      break;
    }
    if (chunk.type == "IHDR") throw Refusal("the PNG file is damaged: it has two headers (IHDR)");
    if (chunk.type == "PLTE") {
      if (!found.palette.empty()) throw Refusal("the PNG file is damaged: it has two palettes (PLTE)");
      if (image_data) throw Refusal("the PNG file is damaged: its palette (PLTE) comes after the pixels");
      if (transparency) throw Refusal("the PNG file is damaged: its palette (PLTE) comes after the transparency (tRNS)");
      check_palette(found.header, chunk.data);
      found.palette = chunk.data;
    } else if (chunk.type == "tRNS") {
      if (transparency) throw Refusal("the PNG file is damaged: it has two transparencies (tRNS)");
      if (image_data) throw Refusal("the PNG file is damaged: its transparency (tRNS) comes after the pixels");
      check_transparency(found.header, found.palette.size() / 3, chunk.data);
      transparency = true;
    } else if (chunk.type == "IDAT") {
      if (image_data_ended) throw Refusal("the PNG file is damaged: its pixels (IDAT) are not in one piece");
      if (found.header.color_type == 3 && found.palette.empty()) {
        throw Refusal("the PNG file is damaged: its palette (PLTE) is missing");
      }
      image_data = true;
      found.compressed.insert(found.compressed.end(), chunk.data.begin(), chunk.data.end());
    } else if (chunk.type[0] >= 'A' && chunk.type[0] <= 'Z') {
      // A capital first letter says: whoever does not know this chunk cannot show the picture.
      throw Refusal("the PNG file needs a feature that this program does not know (chunk " + std::string(chunk.type) + ")");
    }
  }
  if (!image_data) throw Refusal("the PNG file is damaged: it has no pixels (IDAT)");
  return found;
}

}  // namespace texmap
