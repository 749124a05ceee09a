// Huffman codes of a JPEG file and the bits they are read from. Inline, because a photograph has
// millions of codes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/picture/codecs/bytes.hpp"
#include "engine/system/file_error.hpp"

namespace texmap {

/// Throws FileError `the JPEG file is damaged: otherwise` unless the condition holds.
inline void require_jpeg(bool holds, const char* otherwise) {
  if (!holds) throw FileError(std::string("the JPEG file is damaged: ") + otherwise);
}

/// Takes so many bytes off the front of `data`. Errors: FileError, if there are fewer.
inline Bytes take(Bytes& data, std::size_t bytes) {
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
    for (std::uint32_t bits = 0; bits < fast_.size(); ++bits) {
      const Found found = search(bits << (16 - fast_bits));
      if (found.length <= fast_bits) fast_[bits] = found;
    }
  }

  [[nodiscard]] bool is_there() const { return limit_[16] > 0; }

  /// A code found at the front of some bits; length 0 if there is none.
  struct Found {
    std::uint8_t length = 0, symbol = 0;
  };

  /// @param bits  the next 16 bits, the first one on top
  [[nodiscard]] Found find(std::uint32_t bits) const {
    const Found fast = fast_[bits >> (16 - fast_bits)];
    return fast.length != 0 ? fast : search(bits);
  }

 private:
  [[nodiscard]] Found search(std::uint32_t bits) const {
    for (std::uint32_t length = 1; length <= 16; ++length) {
      if (bits < limit_[length]) {
        const std::uint32_t place = (bits - limit_[length - 1]) >> (16 - length);
        return {static_cast<std::uint8_t>(length), symbol_[before_[length] + place]};
      }
    }
    return {};
  }

  static constexpr std::uint32_t fast_bits = 9;
  std::array<std::uint8_t, 256> symbol_{};
  std::array<std::uint32_t, 17> limit_{};  // codes of this length, brought to 16 bits, are below it
  std::array<std::uint32_t, 17> before_{};                 // symbols that have shorter codes
  std::array<Found, std::size_t{1} << fast_bits> fast_{};  // length 0 for longer codes
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
  void fill() {
    if (bits_ <= 32 && rest_.size() >= 4) {
      const std::uint32_t four = big_endian_32(rest_, 0);
      if (((~four - 0x01010101U) & four & 0x80808080U) == 0) {  // no byte of all ones
        buffer_ |= std::uint64_t{four} << (32 - bits_);
        bits_ += 32;
        rest_ = rest_.subspan(4);
        return;
      }
    }
    while (bits_ <= 56 && !rest_.empty()) {
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

}  // namespace texmap
