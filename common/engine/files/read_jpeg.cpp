// From the bytes of a JPEG file to a picture. stb_image trusts the tables: bad ones make it write
// out of bounds. It also makes up missing pixels. So we first read the whole file.
#include "engine/files/read_jpeg.hpp"

#include <stb_image.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/color_profile.hpp"
#include "engine/files/exif.hpp"
#include "engine/files/file_error.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/pixel_order.hpp"
#include "number/compiler.hpp"

namespace texmap {
namespace {

constexpr int max_tables = 1024;
// Bounds the time that many small scans can take.
constexpr std::uint64_t max_block_visits = std::uint64_t{1} << 26;
constexpr int largest_constant = 32767;
constexpr int not_sent = 99;

[[noreturn]] TEXMAP_NOINLINE void refuse_jpeg(const char* why) {
  throw FileError(std::string("the JPEG file is damaged: ") + why);
}
/// Throws FileError `the JPEG file is damaged: otherwise` unless the condition holds.
void require_jpeg(bool holds, const char* otherwise) {
  if (!holds) refuse_jpeg(otherwise);
}

/// Takes so many bytes off the front of `data`. Errors: FileError, if there are fewer.
Bytes take(Bytes& data, std::size_t bytes) {
  require_jpeg(data.size() >= bytes, "a table or header ends too early");
  const Bytes taken = data.first(bytes);
  data = data.subspan(bytes);
  return taken;
}

/// A Huffman table of a JPEG file.
class JpegCodes {
 public:
  JpegCodes() = default;

  /// Takes a table off the front of `data`: how many codes of each length, then their symbols.
  ///
  /// Errors: FileError if the table is cut short, if its codes do not fit into their bits (all ones
  /// must stay unused), or for a symbol above `largest_symbol`.
  JpegCodes(Bytes& data, std::uint32_t largest_symbol) {
    const Bytes counts = take(data, 16);
    std::uint32_t symbols = 0;
    for (std::uint32_t length = 1; length <= 16; ++length) {
      const std::uint32_t codes = counts[length - 1];
      before_[length] = symbols;
      symbols += codes;
      limit_[length] = limit_[length - 1] + (codes << (16 - length));
      require_jpeg(limit_[length] <= 0xFFFF,
                   "a Huffman table has more codes than fit into their bits");
      // The decoder behind this takes place 255 for "not there".
      require_jpeg(symbols <= 255, "a Huffman table has too many symbols");
    }
    std::size_t i = 0;
    for (const std::uint8_t symbol : take(data, symbols)) {
      require_jpeg(symbol <= largest_symbol, "a Huffman table has a symbol that does not exist");
      symbol_[i++] = symbol;
    }
    for (std::uint32_t bits = 0; bits < short_codes_.size(); ++bits) {
      const Found found = search(bits << (16 - short_length), 1);
      if (found.length <= short_length) short_codes_[bits] = found;
    }
  }

  [[nodiscard]] bool is_there() const { return limit_[16] > 0; }

  /// A code found at the front of some bits; length 0 if there is none.
  struct Found {
    std::uint8_t length = 0, symbol = 0;
  };

  /// @param bits  the next 16 bits, the first one on top
  [[nodiscard]] Found find(std::uint32_t bits) const {
    const Found found = find_short(bits);
    return found.length != 0 ? found : search(bits, short_length + 1);
  }
  /// The same; nothing for codes of more than `short_length` bits, too.
  [[nodiscard]] Found find_short(std::uint32_t bits) const {
    return short_codes_[bits >> (16 - short_length)];
  }

 private:
  static constexpr std::uint32_t short_length = 10;  // nearly all codes of a usual file

  /// Tries codes of `length` bits and more.
  [[nodiscard]] Found search(std::uint32_t bits, std::uint32_t length) const {
    for (; length <= 16; ++length) {
      if (bits < limit_[length]) {
        const std::uint32_t place = (bits - limit_[length - 1]) >> (16 - length);
        return {static_cast<std::uint8_t>(length), symbol_[before_[length] + place]};
      }
    }
    return {};
  }

  std::array<Found, 1U << short_length> short_codes_{};  // by the bits that they begin
  std::array<std::uint8_t, 256> symbol_{};
  std::array<std::uint32_t, 17> limit_{};  // codes of this length, brought to 16 bits, are below it
  std::array<std::uint32_t, 17> before_{};  // symbols that have shorter codes
};

/// The entropy-coded bytes of a scan, read bit by bit up to the next marker. Errors: FileError.
class JpegBits {
 public:
  /// @param data  from the first byte after the header of the scan to the end of the file
  explicit JpegBits(Bytes data) : rest_(data) {}

  /// The next code's symbol.
  [[nodiscard]] std::uint32_t symbol(const JpegCodes& codes) {
    if (bits_ < 16) fill();
    const JpegCodes::Found found = codes.find(static_cast<std::uint32_t>(buffer_ >> 48));
    require_jpeg(found.length != 0, "its pixels have a code that does not exist");
    drop(found.length);
    return found.symbol;
  }

  /// The next `count` bits, 0 to 16, as a number.
  std::uint32_t number(std::uint32_t count) {
    if (bits_ < count) fill();
    const std::uint32_t bits = static_cast<std::uint32_t>(buffer_ >> 48) >> (16 - count);
    drop(count);
    return bits;
  }

  /// Skips varying coefficients of a block from `k` on, up to the first code that is long, is no
  /// coefficient's, or may be the last of the bits.
  ///
  /// @return  the coefficient that comes next, at most 64
  [[nodiscard]] std::uint32_t skip(const JpegCodes& codes, std::uint32_t k) {
    for (;;) {
      if (bits_ < 32) fill();
      const JpegCodes::Found found = codes.find_short(static_cast<std::uint32_t>(buffer_ >> 48));
      const std::uint32_t size = found.symbol & 15U;
      const std::uint32_t next = k + (found.symbol >> 4) + 1;
      if (size == 0 || next > 64 || bits_ < 32) return k;
      buffer_ <<= found.length + size;
      bits_ -= found.length + size;
      k = next;
    }
  }

  /// Takes restart marker `n` modulo 8, which must come right after the bits read so far.
  void take_restart(std::uint64_t n) {
    fill();  // stops at the marker; up to seven bits fill up the byte before it
    while (rest_.size() > 2 && rest_[0] == 0xFF && rest_[1] == 0xFF) rest_ = rest_.subspan(1);
    const bool is_there =
        bits_ < 8 && rest_.size() >= 2 && rest_[0] == 0xFF && rest_[1] == 0xD0 + n % 8;
    require_jpeg(is_there, "a restart marker is not where it should be");
    *this = JpegBits(rest_.subspan(2));
  }

  /// What follows the bits: from the marker that ends them.
  [[nodiscard]] Bytes after() {
    // Some cameras leave bytes behind the last pixel.
    for (fill(); bits_ > 0; fill()) bits_ = 0;
    return rest_;
  }

 private:
  // To 33 bits or more, or all up to the next marker.
  void fill() {
    while (bits_ <= 32 && !rest_.empty()) {
      if (rest_.size() >= 4) {  // nearly always four bytes without 0xFF
        const std::uint32_t four = big_endian_32(rest_, 0);
        if (((~four - 0x01010101U) & four & 0x80808080U) == 0) {
          buffer_ |= std::uint64_t{four} << (32 - bits_);
          bits_ += 32;
          rest_ = rest_.subspan(4);
          continue;
        }
      }
      std::size_t taken = 1;
      if (rest_[0] == 0xFF) {
        // A data byte 0xFF is followed by 0. Otherwise it begins a marker, and may be repeated.
        while (taken < rest_.size() && rest_[taken] == 0xFF) ++taken;
        if (taken == rest_.size() || rest_[taken] != 0) return;
        ++taken;
      }
      buffer_ |= std::uint64_t{rest_[0]} << (56 - bits_);
      bits_ += 8;
      rest_ = rest_.subspan(taken);
    }
  }

  void drop(std::uint32_t count) {
    if (count > bits_)
      throw FileError("the JPEG file is cut short or damaged: its pixels end too early");
    buffer_ <<= count;
    bits_ -= count;
  }

  Bytes rest_;
  std::uint64_t buffer_ = 0;  // the next bits, the first one on top
  std::uint32_t bits_ = 0;    // how many of them there are
};

void require_sense(bool holds) {
  require_jpeg(holds, "its pixels have a code that makes no sense");
}

// A color channel: what the header says of it, and its blocks of 8x8.
struct Channel {
  std::uint32_t id = 0;
  std::uint32_t across = 1, down = 1;         // sampling factors, 1 to 4: blocks of a unit
  std::uint32_t quantization = 0;             // table, 0 to 3
  std::uint64_t columns = 0, rows = 0;        // blocks that hold a part of the picture
  std::uint64_t stride = 0;                   // blocks from one row to the next
  std::vector<std::uint64_t> known_not_zero;  // coefficients of each block; progressive files only
  std::array<int, 64> lowest_bit{};  // of each coefficient the lowest sent so far, or not_sent

  // What changes from scan to scan.
  const JpegCodes* dc = nullptr;  // codes for the constant coefficient
  const JpegCodes* ac = nullptr;  // codes for the varying ones
  int constant = 0;               // of the block before
};

struct Scan {
  std::vector<Channel*> channels;
  std::uint32_t first = 0, last = 63;  // coefficients, 0 to 63
  int bit_before = 0;                  // not 0: one more bit of coefficients that were sent before
  int bit = 0;                         // the lowest that is sent, 0 to 13
};

// The file, read from the front, and what was found so far.
class Reader {
 public:
  Reader(Bytes file, int later_bytes) : rest_(file.subspan(2)), later_bytes_(later_bytes) {}

  PixelOrder order;
  std::string profile;  // what its user should know of it
  [[nodiscard]] bool is_cmyk() const { return channels_.size() == 4; }

  ImageSize read() {
    for (std::uint32_t marker = take_marker(); marker != 0xD9; marker = take_marker()) {
      if (marker >= 0xD0 && marker <= 0xD7) continue;  // a restart behind the last unit
      const Bytes data = take_segment();
      const bool comment = (marker >= 0xE0 && marker <= 0xEF) || marker == 0xFE;
      if (constexpr std::string_view exif("Exif\0\0", 6);
          marker == 0xE1 && order == PixelOrder{} && data.size() >= exif.size() &&
          std::equal(exif.begin(), exif.end(), data.begin()))
        order = order_of_exif(data.subspan(exif.size()));
      // two bytes follow: the number of the part, and that of all parts
      if (constexpr std::string_view icc("ICC_PROFILE\0\1", 13);
          marker == 0xE2 && data.size() > icc.size() &&
          std::equal(icc.begin(), icc.end(), data.begin()))
        profile = note_on_profile(data.subspan(icc.size() + 1));
      if (marker == 0xDB) {
        quantization_tables(data);
      } else if (marker == 0xC4) {
        huffman_tables(data);
      } else if (marker == 0xDD) {
        require_jpeg(data.size() == 2, "its restart interval does not have 2 bytes");
        restart_interval_ = big_endian_16(data, 0);
      } else if (marker >= 0xC0 && marker <= 0xCF) {
        frame(marker, data);
      } else if (marker == 0xDA) {
        scan(data);
      } else {
        require_jpeg(comment, "it has a segment of an unknown kind");
      }
    }
    require_jpeg(!channels_.empty(), "it has no picture in it");
    for (const Channel& channel : channels_)
      require_jpeg(channel.lowest_bit[0] != not_sent, "a color channel is missing");
    return size_;
  }

 private:
  // The file as a row of segments.

  std::uint32_t take_marker() {
    // Some files have bytes between segments. The decoder skips them, but not behind the frame.
    while (channels_.empty() && !rest_.empty() && rest_[0] != 0xFF) rest_ = rest_.subspan(1);
    require_jpeg(rest_.empty() || rest_[0] == 0xFF,
                 "a segment does not begin where the one before it ends");
    while (!rest_.empty() && rest_[0] == 0xFF) rest_ = rest_.subspan(1);
    if (rest_.empty()) throw FileError("the JPEG file is cut short: its end marker is missing");
    return take(rest_, 1)[0];
  }

  Bytes take_segment() {
    const std::size_t length = rest_.size() < 2 ? 2 : big_endian_16(rest_, 0);
    require_jpeg(length >= 2, "a segment is shorter than its own length");
    if (length > rest_.size()) throw FileError("the JPEG file is cut short inside a segment");
    return take(rest_, length).subspan(2);
  }

  // Tables.

  void quantization_tables(Bytes data) {
    while (!data.empty()) {
      const std::uint32_t kind = take(data, 1)[0];
      require_jpeg(kind >> 4 <= 1 && (kind & 15) <= 3,
                   "a quantisation table has a number that does not exist");
      take(data, kind >> 4 == 1 ? 128 : 64);
      has_quantization_[kind & 15] = true;
    }
  }

  void huffman_tables(Bytes data) {
    while (!data.empty()) {
      const std::uint32_t kind = take(data, 1)[0];
      require_jpeg(kind >> 4 <= 1 && (kind & 15) <= 3,
                   "a Huffman table has a number that does not exist");
      if (++tables_ > max_tables) {
        throw FileError("the JPEG file has more than " + std::to_string(max_tables) +
                        " Huffman tables");
      }
      codes_[kind >> 4][kind & 15] = JpegCodes(data, kind >> 4 == 0 ? 15 : 255);
    }
  }

  // The picture.

  void frame(std::uint32_t marker, Bytes data) {
    if (marker > 0xC2) {
      throw FileError(
          "the JPEG file is of a rare kind (lossless, hierarchical or arithmetic); save it as a "
          "usual JPEG or as PNG");
    }
    require_jpeg(channels_.empty(), "it has two pictures in it");
    progressive_ = marker == 0xC2;
    const Bytes header = take(data, 6);
    if (header[0] != 8) {
      throw FileError("the JPEG file has " + std::to_string(header[0]) +
                      " bits a channel, and only 8 can be read");
    }
    size_ = {big_endian_16(header, 3), big_endian_16(header, 1)};
    check_image_size(size_);
    const std::size_t channels = header[5];
    if (channels != 1 && channels != 3 && channels != 4) {
      throw FileError("the JPEG file is damaged: it has " + std::to_string(channels) +
                      " color channels instead of 1, 3 or 4");
    }
    require_jpeg(data.size() == 3 * channels, "a header has the wrong length");
    while (!data.empty()) channel(take(data, 3));
    lay_out_blocks();
  }

  void channel(Bytes data) {
    Channel channel;
    channel.id = data[0];
    channel.across = data[1] >> 4;
    channel.down = data[1] & 15;
    channel.quantization = data[2];
    channel.lowest_bit.fill(not_sent);
    require_jpeg(
        channel.across >= 1 && channel.across <= 4 && channel.down >= 1 && channel.down <= 4,
        "a color channel has a sampling factor outside 1 to 4");
    require_jpeg(channel.quantization <= 3,
                 "a color channel names a quantisation table that does not exist");
    require_jpeg(find(channel.id) == nullptr, "two color channels have the same number");
    channels_.push_back(channel);
  }

  Channel* find(std::uint32_t id) {
    for (Channel& channel : channels_)
      if (channel.id == id) return &channel;
    return nullptr;
  }

  void lay_out_blocks() {
    std::uint32_t across = 1;
    std::uint32_t down = 1;
    for (const Channel& channel : channels_) {
      across = std::max(across, channel.across);
      down = std::max(down, channel.down);
    }
    const auto divide_up = [](std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; };
    units_in_a_row_ = divide_up(size_.width, std::uint64_t{8} * across);
    units_ = units_in_a_row_ * divide_up(size_.height, std::uint64_t{8} * down);
    std::uint64_t blocks = 0;
    for (Channel& channel : channels_) {
      require_jpeg(across % channel.across == 0 && down % channel.down == 0,
                   "the sampling factors of its color channels do not divide each other");
      channel.columns =
          divide_up(divide_up(std::uint64_t{size_.width} * channel.across, across), 8);
      channel.rows = divide_up(divide_up(std::uint64_t{size_.height} * channel.down, down), 8);
      channel.stride = units_in_a_row_ * channel.across;
      blocks += units_ * channel.across * channel.down;
    }
    // The decoder needs a byte for each of 64 samples (three if progressive) and the pixels.
    // Copying the pixels then takes twice their size, 768 MiB at most.
    const std::uint64_t pixels = sizeof(Rgb8) * std::uint64_t{size_.width} * size_.height;
    check_memory(blocks * 64 * (progressive_ ? 3 : 1) + pixels,
                 std::uint64_t{size_.width} * size_.height * static_cast<unsigned>(later_bytes_));
    if (!progressive_) return;
    for (Channel& channel : channels_) {
      channel.known_not_zero.resize(
          static_cast<std::size_t>(units_ * channel.across * channel.down));
    }
  }

  // Scans: each says what it sends, and then come its codes.

  void scan(Bytes data) {
    require_jpeg(!channels_.empty(), "its pixels come before its header");
    const std::size_t channels = take(data, 1)[0];
    require_jpeg(channels >= 1 && channels <= channels_.size() && data.size() == 2 * channels + 3,
                 "a scan's header has the wrong length");
    const Bytes named = take(data, 2 * channels);
    Scan scan{{}, data[0], data[1], data[2] >> 4, data[2] & 15};
    check_spectrum(channels, scan);
    if (!progressive_) scan.last = 63;
    for (std::size_t i = 0; i < channels; ++i) {
      Channel* const channel = find(named[2 * i]);
      require_jpeg(channel != nullptr, "a scan names a color channel that does not exist");
      set_tables(*channel, scan, named[2 * i + 1]);
      for (std::uint32_t k = scan.first; k <= scan.last; ++k) send(*channel, k, scan);
      scan.channels.push_back(channel);
    }
    check_codes(scan);
  }

  void check_spectrum(std::size_t channels, const Scan& scan) const {
    const auto [ignored, first, last, bit_before, bit] = scan;
    if (!progressive_) {
      require_jpeg(first == 0 && bit_before == 0 && bit == 0,
                   "a scan asks for something that only progressive files have");
      return;
    }
    const bool constant_part = first == 0 && last == 0;
    const bool varying_part = first >= 1 && first <= last && last <= 63 && channels == 1;
    require_jpeg(constant_part || varying_part,
                 "a scan covers frequencies that do not exist or do not go together");
    require_jpeg(bit <= 13 && (bit_before == 0 || bit_before == bit + 1),
                 "a scan covers bits that do not follow each other");
  }

  void set_tables(Channel& channel, const Scan& scan, std::uint32_t tables) const {
    require_jpeg(tables >> 4 <= 3 && (tables & 15) <= 3,
                 "a scan names a Huffman table that does not exist");
    channel.dc = &codes_[0][tables >> 4];
    channel.ac = &codes_[1][tables & 15];
    const bool needs_dc = scan.first == 0 && scan.bit_before == 0;
    const bool needs_ac = scan.last > 0;
    require_jpeg((!needs_dc || channel.dc->is_there()) && (!needs_ac || channel.ac->is_there()),
                 "a Huffman table is missing");
    require_jpeg(has_quantization_[channel.quantization], "a quantisation table is missing");
  }

  // Each coefficient is sent once, and then made finer bit by bit; the constant one comes first.
  static void send(Channel& channel, std::uint32_t k, const Scan& scan) {
    int& lowest = channel.lowest_bit[k];
    const bool constant_is_there = k == 0 || channel.lowest_bit[0] != not_sent;
    const bool in_order = scan.bit_before == 0 ? lowest == not_sent : lowest == scan.bit_before;
    require_jpeg(constant_is_there && in_order, "its scans repeat each other or are out of order");
    lowest = scan.bit;
  }

  // Reads all codes of a scan and drops them: after that we know that all are there and valid.
  void check_codes(const Scan& scan) {
    // One channel alone is sent block by block, several in units that hold blocks of each.
    const bool alone = scan.channels.size() == 1;
    const Channel& only = *scan.channels[0];
    const std::uint64_t units = alone ? only.columns * only.rows : units_;
    const std::uint64_t units_in_a_row = alone ? only.columns : units_in_a_row_;
    for (const Channel* channel : scan.channels)
      block_visits_ += units * (alone ? 1 : channel->across * channel->down);
    if (block_visits_ > max_block_visits)
      throw FileError("the JPEG file has too many scans for its size in pixels");

    bits_ = JpegBits(rest_);
    empty_blocks_ = 0;
    for (std::uint64_t unit = 0; unit < units; ++unit) {
      if (restart_interval_ != 0 && unit != 0 && unit % restart_interval_ == 0) {
        bits_.take_restart(unit / restart_interval_ - 1);
        for (Channel* channel : scan.channels) channel->constant = 0;
        empty_blocks_ = 0;
      }
      const std::uint64_t column = unit % units_in_a_row;
      const std::uint64_t row = unit / units_in_a_row;
      for (Channel* channel : scan.channels) {
        const std::uint32_t across = alone ? 1 : channel->across;
        const std::uint32_t down = alone ? 1 : channel->down;
        for (std::uint32_t y = 0; y < down; ++y) {
          for (std::uint32_t x = 0; x < across; ++x)
            block(scan, *channel, column * across + x, row * down + y);
        }
      }
    }
    rest_ = bits_.after();
  }

  void block(const Scan& scan, Channel& channel, std::uint64_t column, std::uint64_t row) {
    if (scan.first == 0 && scan.bit_before != 0) {
      bits_.number(1);
    } else if (scan.first == 0) {
      constant(channel);
    }
    if (scan.last == 0) return;
    std::uint64_t unused = 0;
    std::uint64_t& not_zero =
        progressive_
            ? channel.known_not_zero[static_cast<std::size_t>(row * channel.stride + column)]
            : unused;
    if (scan.bit_before != 0) {
      refine(scan, *channel.ac, not_zero);
    } else {
      spectrum(scan, *channel.ac, not_zero);
    }
  }

  // The constant coefficient, sent as the difference to the block before.
  void constant(Channel& channel) {
    const std::uint32_t size = bits_.symbol(*channel.dc);
    if (size == 0) return;
    const int bits = static_cast<int>(bits_.number(size));
    const int half = 1 << (size - 1);
    channel.constant += bits >= half ? bits : bits - 2 * half + 1;
    require_sense(std::abs(channel.constant) <= largest_constant);
  }

  // The first bits of varying coefficients. A code can end this block and, if progressive, more.
  void spectrum(const Scan& scan, const JpegCodes& codes, std::uint64_t& not_zero) {
    if (empty_blocks_ > 0) {
      --empty_blocks_;
      return;
    }
    for (std::uint32_t k = std::max(scan.first, 1U); k <= scan.last; ++k) {
      if (!progressive_) k = bits_.skip(codes, k);
      if (k > scan.last) return;
      const std::uint32_t code = bits_.symbol(codes);
      const std::uint32_t run = code >> 4;
      const std::uint32_t size = code & 15;
      if (size == 0 && run != 15) {
        if (progressive_) empty_blocks_ = (1U << run) - 1 + bits_.number(run);
        return;
      }
      k += run;
      require_sense(k <= scan.last && static_cast<int>(size) + scan.bit <= 15);
      if (size == 0) continue;
      bits_.number(size);
      not_zero |= std::uint64_t{1} << k;
    }
  }

  // One more bit of each coefficient that is not zero, and some that have just become so.
  void refine(const Scan& scan, const JpegCodes& codes, std::uint64_t& not_zero) {
    std::uint32_t k = scan.first;
    while (k <= scan.last && empty_blocks_ == 0) {
      const std::uint32_t code = bits_.symbol(codes);
      std::uint32_t run = code >> 4;
      const std::uint32_t size = code & 15;
      require_sense(size <= 1);
      if (size == 0 && run != 15) {
        empty_blocks_ = (1U << run) + bits_.number(run);  // this block included
        break;
      }
      bits_.number(size);
      for (bool placed = false; k <= scan.last && !placed; ++k) {
        const std::uint64_t here = std::uint64_t{1} << k;
        if ((not_zero & here) != 0) {
          bits_.number(1);
        } else if (run > 0) {
          --run;
        } else {
          placed = true;
          if (size == 1) not_zero |= here;
        }
      }
    }
    if (empty_blocks_ == 0) return;
    --empty_blocks_;
    for (; k <= scan.last; ++k) {
      if ((not_zero >> k & 1) != 0) bits_.number(1);
    }
  }

  Bytes rest_;
  int later_bytes_;
  ImageSize size_;
  std::vector<Channel> channels_;
  bool progressive_ = false;
  std::array<bool, 4> has_quantization_{};
  std::array<std::array<JpegCodes, 4>, 2>
      codes_;  // for constant coefficients, and for varying ones
  int tables_ = 0;
  std::uint64_t restart_interval_ = 0;  // units between two restart markers, 0 for none
  std::uint64_t units_ = 0;             // of a scan with several channels
  std::uint64_t units_in_a_row_ = 0;
  std::uint64_t block_visits_ = 0;
  JpegBits bits_{{}};               // of the scan that is read
  std::uint32_t empty_blocks_ = 0;  // that the scan has already said to come
};

}  // namespace

bool looks_like_jpeg(Bytes file) {
  return file.size() >= 3 && file[0] == 0xFF && file[1] == 0xD8 && file[2] == 0xFF;
}

Image read_jpeg(Bytes file, std::string* note, int later_bytes, bool has_colors) {
  Reader reader(file, later_bytes);
  const ImageSize size = reader.read();
  // With a fourth byte a pixel the decoder turns eight pixels at once into colors. A large picture
  // does without, for its memory.
  const std::size_t area = std::size_t{size.width} * size.height;
  const int bytes = area <= (std::size_t{1} << 24) ? 4 : 3;
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels,
                            bytes),
      stbi_image_free);
  if (!pixels) {
    const char* const reason = stbi_failure_reason();
    const std::string why = reason != nullptr ? reason : "no reason given";
    if (why == "outofmem") throw std::bad_alloc();
    throw FileError("the decoder refuses it (" + why + ")");
  }
  if (size != ImageSize{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)})
    throw FileError("the file is damaged: it states two different sizes");

  const PixelOrder order = reader.order;
  const stbi_uc* from = pixels.get();
  Image image = order.picture(width, height, [&](int, int) {
    const Rgb8 pixel{from[0], from[1], from[2]};
    from += bytes;
    return pixel;
  });
  if (note != nullptr) {
    if (order != PixelOrder{}) add_note(*note, turned_by_exif);
    if (has_colors) add_note(*note, reader.is_cmyk() ? not_in_srgb("CMYK") : reader.profile);
  }
  return image;
}

}  // namespace texmap
