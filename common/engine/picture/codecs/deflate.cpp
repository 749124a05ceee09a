// Compresses the rows of a picture as fast as they are drawn: repetitions are looked for a period
// away, and where the same four bytes were last.
#include "engine/picture/codecs/deflate.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/codecs/deflate_block.hpp"
#include "engine/picture/codecs/deflate_close.hpp"

namespace texmap {
namespace {

using namespace rfc1951;

constexpr std::size_t shortest_match = 4;  // bytes; deflate allows 3, which saves nothing here
constexpr std::size_t tokens_a_block = 16384;
constexpr std::size_t hash_bits = 13;

struct Match {
  std::size_t length = 0;  // 0: none
  std::size_t distance = 0;
};

/// Finds repetitions: at the last place of the same four bytes, and a period away.
class Places {
 public:
  Places(Bytes bytes, std::size_t period)
      : bytes_(bytes), period_(period), places_(std::size_t{1} << hash_bits) {}

  [[nodiscard]] bool has_four(std::size_t at) const { return at + shortest_match <= bytes_.size(); }

  /// Remembers a place.
  void enter(std::size_t at) {
    place_of(four_bytes(bytes_.data() + at)) = static_cast<std::uint32_t>(at);
  }

  /// The longer repetition at a place, which is remembered.
  Match find(std::size_t at) {
    const std::uint8_t* const here = bytes_.data() + at;
    const std::size_t most = std::min(longest_match, bytes_.size() - at);
    const std::uint32_t four = four_bytes(here);
    Match best;
    const auto try_place = [&](std::size_t place) {
      const std::uint8_t* const there = bytes_.data() + place;
      if (four_bytes(there) != four) return;
      const std::size_t length = same_bytes(there, here, shortest_match, most);
      if (length > best.length) best = {length, at - place};
    };
    if (period_ - 1 < window && period_ <= at) try_place(at - period_);
    std::uint32_t& before = place_of(four);
    // The subtraction wraps around where `before` is `at` itself: an unused place says 0.
    if (at - before - 1 < window) try_place(before);
    before = static_cast<std::uint32_t>(at);
    return best;
  }

 private:
  std::uint32_t& place_of(std::uint32_t four) {
    return places_[(four * 2654435761U) >> (32 - hash_bits)];
  }

  Bytes bytes_;
  std::size_t period_;
  std::vector<std::uint32_t> places_;
};

void put_blocks(BitWriter& out, Bytes bytes, std::size_t period) {
  Places places(bytes, period);
  Block block(tokens_a_block);
  const auto empty_if_full = [&] {
    if (block.size() == tokens_a_block) block.put(out, false);
  };
  std::size_t at = 0;
  const auto put_byte = [&] {
    empty_if_full();
    block.add(bytes[at++]);
  };
  while (places.has_four(at)) {
    const Match match = places.find(at);
    if (match.length == 0) {
      put_byte();
      continue;
    }
    empty_if_full();
    block.add_match(match.length, match.distance);
    at += match.length;
    // Of a match, its last pixel is remembered, its first byte last: where all bytes are equal, the
    // next two matches then refer back by a whole pixel.
    for (std::size_t back = 1; back <= 3; ++back) {
      if (places.has_four(at - back)) places.enter(at - back);
    }
  }
  while (at < bytes.size()) put_byte();
  block.put(out, true);
}

}  // namespace

std::size_t deflate(Bytes bytes, std::span<std::uint8_t> room, Packing packing,
                    std::size_t period) {
  BitWriter out(room.data());
  // zlib: deflate with a window of 32 KiB, and how hard it was tried
  out.put(packing == Packing::close ? 0xDA78 : 0x0178, 16);
  if (packing == Packing::close) {
    put_closely(out, bytes);
  } else {
    put_blocks(out, bytes, period);
  }
  out.fill_byte();
  const std::uint32_t checksum = adler32(bytes);
  for (const int shift : {24, 16, 8, 0}) out.put((checksum >> shift) & 0xFFU, 8);
  return static_cast<std::size_t>(out.end() - room.data());
}

}  // namespace texmap
