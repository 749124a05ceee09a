// The bits of a JPEG scan, and the codes in them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "bytes.hpp"

namespace texmap {

/// A Huffman table of a JPEG file, made for looking up codes.
class JpegCodes {
 public:
  /// Takes a table off the front of `data`: how many codes of each length 1 to 16, then their symbols.
  ///
  /// Errors: Refusal, if it is cut short, if the codes do not fit into their bits with the one of all ones left free, or if a
  /// symbol is larger than `largest_symbol`.
  void read(Bytes& data, std::uint32_t largest_symbol);

  [[nodiscard]] bool is_there() const { return symbols_ > 0; }

  /// A code found at the front of some bits; length 0 if there is none.
  struct Found {
    std::uint32_t length = 0;
    std::uint32_t symbol = 0;
  };

  /// @param bits  the next 16 bits, the first one on top
  [[nodiscard]] Found find(std::uint32_t bits) const;

 private:
  static constexpr std::uint32_t fast_bits = 9;

  std::uint32_t symbols_ = 0;
  std::array<std::uint8_t, 256> symbol_{};
  std::array<std::uint32_t, 17> limit_{};                  // codes of this length, brought to 16 bits, are below it
  std::array<std::uint32_t, 17> shift_{};                  // from a code of this length to the place of its symbol, modulo 2^32
  std::array<Found, std::size_t{1} << fast_bits> fast_{};  // by the first bits; length 0 for longer codes
};

/// The entropy-coded bytes of a scan, read bit by bit up to the next marker.
class JpegBits {
 public:
  /// @param data  from the first byte after the header of the scan to the end of the file
  explicit JpegBits(Bytes data) : rest_(data) {}

  /// The next code's symbol. Errors: Refusal, if the bits are no code of the table or end before it does.
  [[nodiscard]] std::uint32_t symbol(const JpegCodes& codes);

  /// The next `count` bits, 0 to 16, as a number. Errors: Refusal, if there are fewer.
  std::uint32_t number(std::uint32_t count);

  /// Takes restart marker `n` modulo 8. Errors: Refusal, unless it comes right after the bits read so far.
  void take_restart(std::uint64_t n);

  /// What follows the bits: from the marker that ends them.
  [[nodiscard]] Bytes after();

 private:
  void fill();
  void drop(std::uint32_t count);
  bool skip_to_marker();

  Bytes rest_;
  std::uint64_t buffer_ = 0;  // the next bits, the first one on top
  std::uint32_t bits_ = 0;    // how many of them there are
};

}  // namespace texmap
