// Compresses the rows of a picture: repetitions are collected for a block, which then gets the
// codes that are shortest for what it holds.
#include "engine/picture/codecs/deflate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "engine/picture/codecs/checksums.hpp"

namespace texmap {
namespace {

constexpr std::size_t window = 32768;       // how far back a repetition may refer
constexpr std::size_t shortest_match = 4;   // bytes; deflate allows 3, which saves nothing here
constexpr std::size_t longest_match = 258;  // bytes: 86 pixels
constexpr std::size_t tokens_a_block = 16384;
constexpr std::size_t hash_bits = 13;

// RFC 1951, section 3.2.5: symbols 0 to 255 are bytes, 256 ends a block, then come lengths.
constexpr std::size_t symbols = 288;  // two of which only the fixed codes have
constexpr std::size_t distances = 30;
constexpr std::size_t end_of_block = 256;

/// A number's highest bits choose its symbol, the others follow.
struct Split {
  std::uint32_t symbol = 0;
  std::uint32_t bits = 0;
  int count = 0;  // of these bits
};

constexpr Split split(std::uint32_t number, int highest_bits) {
  const int below = std::max(0, static_cast<int>(std::bit_width(number)) - highest_bits);
  const std::uint32_t first = static_cast<std::uint32_t>(below) << (highest_bits - 1);
  return {first + (number >> below), number & ((1U << below) - 1), below};
}

// The symbols of lengths, from 3 on; the longest has one of its own.
constexpr auto length_splits = [] {
  std::array<Split, longest_match - 2> splits;
  for (std::uint32_t i = 0; i < splits.size(); ++i) {
    splits[i] = split(i, 3);
    splits[i].symbol += end_of_block + 1;
  }
  splits.back() = {285, 0, 0};
  return splits;
}();

/// The bits of a symbol; the first to be written is the lowest.
struct Code {
  std::uint16_t bits = 0;
  std::uint8_t length = 0;
};

template <std::size_t n>
using Lengths = std::array<std::uint8_t, n>;

/// RFC 1951, section 3.2.2: codes of one length follow each other, and their highest bit is written
/// first.
template <std::size_t n>
constexpr std::array<Code, n> codes_of(const Lengths<n>& lengths) {
  std::array<std::uint32_t, 17> next{};
  for (const std::uint8_t length : lengths) next[length + 1U] += length > 0 ? 1U : 0U;
  for (std::size_t length = 1; length < next.size(); ++length)
    next[length] = (next[length - 1] + next[length]) << 1;
  std::array<Code, n> codes;
  for (std::size_t i = 0; i < n; ++i) {
    codes[i].length = lengths[i];
    if (lengths[i] == 0) continue;
    const std::uint32_t code = next[lengths[i]]++;
    std::uint32_t bits = 0;
    for (int bit = 0; bit < lengths[i]; ++bit) bits = bits << 1 | (code >> bit & 1U);
    codes[i].bits = static_cast<std::uint16_t>(bits);
  }
  return codes;
}

// RFC 1951, section 3.2.6.
constexpr auto fixed_lengths = [] {
  Lengths<symbols> lengths;
  for (std::size_t i = 0; i < symbols; ++i)
    lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
  return lengths;
}();
constexpr auto fixed_distance_lengths = [] {
  Lengths<distances> lengths;
  lengths.fill(5);
  return lengths;
}();

/// Lengths of the shortest codes for symbols that occur so often, at most `most` bits.
/// Source: Huffman, 1952. Longer ones are cut, and others made longer until all fit (Kraft, 1949).
template <std::size_t n>
Lengths<n> lengths_for(const std::array<std::uint32_t, n>& counts, std::size_t most) {
  Lengths<n> lengths{};
  std::array<std::uint16_t, n> leaves{};
  std::size_t used = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (counts[i] > 0) leaves[used++] = static_cast<std::uint16_t>(i);
  }
  if (used == 0) return lengths;
  std::sort(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(used),
            [&](std::uint16_t a, std::uint16_t b) {
              return counts[a] != counts[b] ? counts[a] < counts[b] : a < b;
            });

  // Nodes are the leaves, then inner nodes in the order they are made: both in ascending weight.
  std::array<std::uint32_t, 2 * n> weights{};
  std::array<std::uint16_t, 2 * n> parents{};
  std::array<std::uint8_t, 2 * n> depths{};
  for (std::size_t i = 0; i < used; ++i) weights[i] = counts[leaves[i]];
  const std::size_t root = 2 * used - 2;
  std::size_t leaf = 0;
  std::size_t inner = used;
  for (std::size_t node = used; node <= root; ++node) {
    for (int child = 0; child < 2; ++child) {
      const bool is_leaf = leaf < used && (inner == node || weights[leaf] <= weights[inner]);
      const std::size_t taken = is_leaf ? leaf++ : inner++;
      weights[node] += weights[taken];
      parents[taken] = static_cast<std::uint16_t>(node);
    }
  }
  std::array<std::uint32_t, 17> of_length{};
  depths[root] = used == 1 ? 1 : 0;  // a single symbol still takes a bit
  for (std::size_t node = root + 1; node-- > 0;) {
    if (node < root) depths[node] = static_cast<std::uint8_t>(depths[parents[node]] + 1);
    if (node < used) ++of_length[std::min<std::size_t>(depths[node], most)];
  }

  // Kraft's sum, in units of the longest code.
  std::uint32_t sum = 0;
  for (std::size_t length = 1; length <= most; ++length)
    sum += of_length[length] << (most - length);
  for (; sum > 1U << most; --sum) {
    std::size_t length = most - 1;
    while (of_length[length] == 0) --length;
    --of_length[length];
    of_length[length + 1] += 2;
    --of_length[most];
  }
  std::size_t i = 0;
  for (std::size_t length = most; length > 0; --length) {
    for (std::uint32_t k = 0; k < of_length[length]; ++k)
      lengths[leaves[i++]] = static_cast<std::uint8_t>(length);
  }
  return lengths;
}

class BitWriter {
 public:
  explicit BitWriter(std::uint8_t* to) : to_(to) {}

  // At most 56 bits.
  void put(std::uint64_t bits, int count) {
    waiting_ |= bits << count_;
    count_ += count;
    // All eight bytes, in one instruction; those that are not full yet are written again.
    for (int i = 0; i < 8; ++i) to_[i] = static_cast<std::uint8_t>(waiting_ >> (8 * i));
    to_ += count_ / 8;
    waiting_ >>= count_ & ~7;
    count_ &= 7;
  }
  void put(Code code) { put(code.bits, code.length); }
  void fill_byte() { put(0, -count_ & 7); }
  [[nodiscard]] const std::uint8_t* end() const { return to_; }

 private:
  std::uint8_t* to_;
  std::uint64_t waiting_ = 0;
  int count_ = 0;  // bits that wait, at most 7
};

/// The lengths of a block's codes as RFC 1951, section 3.2.7, writes them: runs have symbols.
struct RunLengths {
  struct Run {
    std::uint8_t symbol, extra;
  };
  std::vector<Run> runs;
  std::array<std::uint32_t, 19> counts{};

  void add(std::uint8_t symbol, std::size_t extra = 0) {
    runs.push_back({symbol, static_cast<std::uint8_t>(extra)});
    ++counts[symbol];
  }
  void add_all(std::span<const std::uint8_t> lengths) {
    for (std::size_t i = 0; i < lengths.size();) {
      std::size_t end = i + 1;
      while (end < lengths.size() && lengths[end] == lengths[i]) ++end;
      if (lengths[i] > 0) add(lengths[i++]);
      while (end - i >= 3) {
        const std::size_t most = lengths[end - 1] > 0 ? 6 : 138;
        const std::size_t run = std::min(end - i, most);
        if (most == 6) {
          add(16, run - 3);
        } else if (run <= 10) {
          add(17, run - 3);
        } else {
          add(18, run - 11);
        }
        i += run;
      }
      for (; i < end; ++i) add(lengths[i]);
    }
  }
  static int extra_bits(std::uint8_t symbol) {
    return symbol == 16 ? 2 : symbol == 17 ? 3 : symbol == 18 ? 7 : 0;
  }
};

template <std::size_t n>
std::size_t bits_with(const std::array<std::uint32_t, n>& counts, const Lengths<n>& lengths) {
  std::size_t bits = 0;
  for (std::size_t i = 0; i < n; ++i) bits += std::size_t{counts[i]} * lengths[i];
  return bits;
}

/// Bytes and repetitions that will be written with the same codes.
class Block {
 public:
  Block() { tokens_.reserve(tokens_a_block); }

  [[nodiscard]] bool is_full() const { return tokens_.size() == tokens_a_block; }

  void add(std::uint8_t byte) {
    tokens_.push_back(byte);
    ++counts_[byte];
  }
  void add_match(std::size_t length, std::size_t distance) {
    const std::size_t from_3 = length - 3;
    tokens_.push_back(
        static_cast<std::uint32_t>(is_match | from_3 << distance_bits | (distance - 1)));
    ++counts_[length_splits[from_3].symbol];
    ++distance_counts_[split(static_cast<std::uint32_t>(distance - 1), 2).symbol];
  }

  /// Writes the block with codes of its own or with the fixed ones, whichever takes fewer bits,
  /// and empties it.
  void put(BitWriter& out, bool is_last) {
    ++counts_[end_of_block];
    Lengths<symbols> lengths = lengths_for(counts_, 15);
    Lengths<distances> distance_lengths = lengths_for(distance_counts_, 15);
    const auto used = [](const auto& all, std::size_t least) {
      std::size_t size = all.size();
      while (size > least && all[size - 1] == 0) --size;
      return size;
    };
    const std::size_t all_symbols = used(lengths, 257);
    const std::size_t all_distances = used(distance_lengths, 1);
    RunLengths runs;
    runs.add_all({lengths.data(), all_symbols});
    runs.add_all({distance_lengths.data(), all_distances});
    const Lengths<19> run_lengths = lengths_for(runs.counts, 7);
    constexpr std::array<std::size_t, 19> order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                   11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::size_t all_runs = order.size();
    while (all_runs > 4 && run_lengths[order[all_runs - 1]] == 0) --all_runs;

    std::size_t own = 14 + 3 * all_runs + bits_with(runs.counts, run_lengths) +
                      bits_with(counts_, lengths) + bits_with(distance_counts_, distance_lengths);
    for (const RunLengths::Run& run : runs.runs)
      own += static_cast<std::size_t>(RunLengths::extra_bits(run.symbol));
    const std::size_t fixed =
        bits_with(counts_, fixed_lengths) + bits_with(distance_counts_, fixed_distance_lengths);
    out.put(is_last ? 1 : 0, 1);
    if (own < fixed) {
      out.put(2, 2);
      out.put(all_symbols - 257, 5);
      out.put(all_distances - 1, 5);
      out.put(all_runs - 4, 4);
      for (std::size_t i = 0; i < all_runs; ++i) out.put(run_lengths[order[i]], 3);
      const std::array<Code, 19> codes = codes_of(run_lengths);
      for (const RunLengths::Run& run : runs.runs) {
        out.put(codes[run.symbol]);
        out.put(run.extra, RunLengths::extra_bits(run.symbol));
      }
    } else {
      out.put(1, 2);
      lengths = fixed_lengths;
      distance_lengths = fixed_distance_lengths;
    }
    put_tokens(out, codes_of(lengths), codes_of(distance_lengths));
    tokens_.clear();
    counts_ = {};
    distance_counts_ = {};
  }

 private:
  static constexpr int distance_bits = 15;
  static constexpr std::size_t is_match = std::size_t{1} << 31;

  void put_tokens(BitWriter& out, const std::array<Code, symbols>& codes,
                  const std::array<Code, distances>& distance_codes) const {
    for (const std::uint32_t token : tokens_) {
      if (token < end_of_block) {
        out.put(codes[token]);
        continue;
      }
      const Split& length = length_splits[token >> distance_bits & 255U];
      const Split distance = split(token & ((1U << distance_bits) - 1), 2);
      const Code length_code = codes[length.symbol];
      const Code distance_code = distance_codes[distance.symbol];
      // At most 15 + 5 + 15 + 13 bits, in one go.
      std::uint64_t bits = distance.bits;
      bits = bits << distance_code.length | distance_code.bits;
      bits = bits << length.count | length.bits;
      bits = bits << length_code.length | length_code.bits;
      out.put(bits, length_code.length + length.count + distance_code.length + distance.count);
    }
    out.put(codes[end_of_block]);
  }

  std::vector<std::uint32_t> tokens_;
  std::array<std::uint32_t, symbols> counts_{};
  std::array<std::uint32_t, distances> distance_counts_{};
};

std::uint32_t four_bytes(const std::uint8_t* from) {
  return from[0] | std::uint32_t{from[1]} << 8 | std::uint32_t{from[2]} << 16 |
         std::uint32_t{from[3]} << 24;
}

std::uint64_t eight_bytes(const std::uint8_t* from) {
  return four_bytes(from) | std::uint64_t{four_bytes(from + 4)} << 32;
}

// How many bytes two places have in common, of which the first four are known to be.
std::size_t match_length(const std::uint8_t* a, const std::uint8_t* b, std::size_t most) {
  std::size_t length = shortest_match;
  for (; length + 8 <= most; length += 8) {
    const std::uint64_t apart = eight_bytes(a + length) ^ eight_bytes(b + length);
    if (apart != 0) return length + static_cast<std::size_t>(std::countr_zero(apart)) / 8;
  }
  while (length < most && a[length] == b[length]) ++length;
  return length;
}

struct Match {
  std::size_t length = 0;  // 0: none
  std::size_t distance = 0;
};

/// Finds repetitions among the last places of each four bytes.
/// @tparam ways  places that are remembered for each hash
template <std::size_t ways>
class Places {
 public:
  Places(Bytes bytes, std::size_t period)
      : bytes_(bytes), period_(period), places_(std::size_t{1} << hash_bits) {}

  [[nodiscard]] bool has_four(std::size_t at) const { return at + shortest_match <= bytes_.size(); }

  /// Remembers a place.
  void enter(std::size_t at) { enter(slot(four_bytes(bytes_.data() + at)), at); }

  /// The longest repetition at a place, which is remembered.
  Match find(std::size_t at) {
    const std::uint8_t* const here = bytes_.data() + at;
    const std::size_t most = std::min(longest_match, bytes_.size() - at);
    const std::uint32_t four = four_bytes(here);
    Match best;
    const auto try_place = [&](std::size_t place) {
      const std::uint8_t* const there = bytes_.data() + place;
      if (four_bytes(there) != four) return;
      const std::size_t length = match_length(there, here, most);
      if (length > best.length) best = {length, at - place};
    };
    if (period_ - 1 < window && period_ <= at) try_place(at - period_);
    Slot& before = slot(four);
    for (const std::uint32_t place : before) {
      // The subtraction wraps around where `place` is `at` itself: an unused place says 0.
      if (at - place - 1 < window) try_place(place);
    }
    enter(before, at);
    return best;
  }

 private:
  using Slot = std::array<std::uint32_t, ways>;  // the latest first

  Slot& slot(std::uint32_t four) { return places_[(four * 2654435761U) >> (32 - hash_bits)]; }

  static void enter(Slot& slot, std::size_t at) {
    std::copy_backward(slot.begin(), slot.end() - 1, slot.end());
    slot[0] = static_cast<std::uint32_t>(at);
  }

  Bytes bytes_;
  std::size_t period_;
  std::vector<Slot> places_;
};

/// @tparam close  a repetition gives way to a longer one that begins at the next byte, and all its
///                places are remembered
template <std::size_t ways, bool close>
void put_blocks(BitWriter& out, Bytes bytes, std::size_t period) {
  Places<ways> places(bytes, period);
  Block block;
  std::size_t at = 0;
  const auto put_byte = [&] {
    if (block.is_full()) block.put(out, false);
    block.add(bytes[at++]);
  };
  while (places.has_four(at)) {
    Match match = places.find(at);
    if (match.length == 0) {
      put_byte();
      continue;
    }
    if constexpr (close) {
      while (match.length < longest_match && places.has_four(at + 1)) {
        const Match next = places.find(at + 1);
        if (next.length <= match.length) break;
        put_byte();
        match = next;
      }
    }
    if (block.is_full()) block.put(out, false);
    block.add_match(match.length, match.distance);
    at += match.length;
    if constexpr (close) {
      for (std::size_t back = match.length - 2; back > 3; --back) {
        if (places.has_four(at - back)) places.enter(at - back);
      }
    }
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
    put_blocks<64, true>(out, bytes, period);
  } else {
    put_blocks<1, false>(out, bytes, period);
  }
  out.fill_byte();
  const std::uint32_t checksum = adler32(bytes);
  for (const int shift : {24, 16, 8, 0}) out.put((checksum >> shift) & 0xFFU, 8);
  return static_cast<std::size_t>(out.end() - room.data());
}

}  // namespace texmap
