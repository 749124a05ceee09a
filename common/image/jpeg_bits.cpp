// The bits of a JPEG scan, and the codes in them.
#include "jpeg_bits.hpp"

#include "image_error.hpp"

namespace texmap {

void JpegCodes::read(Bytes& data, std::uint32_t largest_symbol) {
  if (data.size() < 16) throw Refusal("the JPEG file is damaged: a Huffman table ends too early");
  *this = {};
  std::uint32_t code = 0;
  std::array<std::uint32_t, 257> length_of{};
  for (std::uint32_t length = 1; length <= 16; ++length) {
    const std::uint32_t codes = data[length - 1];
    code *= 2;
    shift_[length] = symbols_ - code;
    code += codes;
    if (code >= 1U << length) {
      throw Refusal("the JPEG file is damaged: a Huffman table has more codes than fit into their bits");
    }
    // The decoder behind this takes place 255 for "not there".
    if (symbols_ + codes > 255) throw Refusal("the JPEG file is damaged: a Huffman table has too many symbols");
    for (std::uint32_t i = 0; i < codes; ++i) length_of[symbols_++] = length;
    limit_[length] = code << (16 - length);
  }
  data = data.subspan(16);

  if (data.size() < symbols_) throw Refusal("the JPEG file is damaged: a Huffman table ends too early");
  std::size_t filled = 0;
  for (std::uint32_t i = 0; i < symbols_; ++i) {
    symbol_[i] = data[i];
    if (symbol_[i] > largest_symbol) {
      throw Refusal("the JPEG file is damaged: a Huffman table has a symbol that does not exist");
    }
    if (length_of[i] > fast_bits) continue;
    const std::size_t end = filled + (std::size_t{1} << (fast_bits - length_of[i]));
    while (filled < end) fast_[filled++] = {length_of[i], symbol_[i]};
  }
  data = data.subspan(symbols_);
}

JpegCodes::Found JpegCodes::find(std::uint32_t bits) const {
  const Found& fast = fast_[bits >> (16 - fast_bits)];
  if (fast.length != 0) return fast;
  for (std::uint32_t length = fast_bits + 1; length <= 16; ++length) {
    if (bits < limit_[length]) return {length, symbol_[(bits >> (16 - length)) + shift_[length]]};
  }
  return {};
}

void JpegBits::fill() {
  while (bits_ <= 56 && !rest_.empty()) {
    std::size_t taken = 1;
    if (rest_[0] == 0xFF) {
      // A byte of all ones is followed by a zero; followed by anything else it begins a marker, and it may be repeated.
      while (taken < rest_.size() && rest_[taken] == 0xFF) ++taken;
      if (taken == rest_.size() || rest_[taken] != 0) return;
      ++taken;
    }
    buffer_ |= std::uint64_t{rest_[0]} << (56 - bits_);
    bits_ += 8;
    rest_ = rest_.subspan(taken);
  }
}

void JpegBits::drop(std::uint32_t count) {
  if (count > bits_) throw Refusal("the JPEG file is cut short or damaged: its pixels end too early");
  buffer_ <<= count;
  bits_ -= count;
}

std::uint32_t JpegBits::symbol(const JpegCodes& codes) {
  if (bits_ < 16) fill();
  const JpegCodes::Found found = codes.find(static_cast<std::uint32_t>(buffer_ >> 48));
  if (found.length == 0) throw Refusal("the JPEG file is damaged: its pixels have a code that does not exist");
  drop(found.length);
  return found.symbol;
}

std::uint32_t JpegBits::number(std::uint32_t count) {
  if (bits_ < count) fill();
  const std::uint32_t bits = static_cast<std::uint32_t>(buffer_ >> 48) >> (16 - count);
  drop(count);
  return bits;
}

// Leaves out the fill bytes before a marker; false if anything else comes before it.
bool JpegBits::skip_to_marker() {
  if (rest_.size() < 2 || rest_[0] != 0xFF) return false;
  while (rest_.size() > 2 && rest_[1] == 0xFF) rest_ = rest_.subspan(1);
  return rest_[1] != 0 && rest_[1] != 0xFF;
}

void JpegBits::take_restart(std::uint64_t n) {
  // Up to seven bits fill up the last byte.
  fill();
  if (bits_ >= 8 || !skip_to_marker() || rest_[1] != 0xD0 + n % 8) {
    throw Refusal("the JPEG file is damaged: a restart marker is not where it should be");
  }
  rest_ = rest_.subspan(2);
  buffer_ = 0;
  bits_ = 0;
}

Bytes JpegBits::after() {
  // Some cameras leave bytes behind the last pixel.
  for (fill(); bits_ > 0; fill()) bits_ = 0;
  return rest_;
}

}  // namespace texmap
