// The blocks of a deflate stream: bytes and repetitions are collected, and then get the codes that
// are shortest for what the block holds.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace texmap::rfc1951 {

inline constexpr std::size_t window = 32768;       // how far back a repetition may refer
inline constexpr std::size_t longest_match = 258;  // bytes: 86 pixels

// RFC 1951, section 3.2.5: symbols 0 to 255 are bytes, 256 ends a block, then come lengths.
inline constexpr std::size_t symbols = 288;  // two of which only the fixed codes have
inline constexpr std::size_t distances = 30;
inline constexpr std::size_t end_of_block = 256;

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
inline constexpr auto length_splits = [] {
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
inline constexpr auto fixed_lengths = [] {
  Lengths<symbols> lengths;
  for (std::size_t i = 0; i < symbols; ++i)
    lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
  return lengths;
}();
inline constexpr auto fixed_distance_lengths = [] {
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

// The order in which a block names the codes of its codes' lengths.
inline constexpr std::array<std::size_t, 19> run_order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                          11, 4,  12, 3, 13, 2, 14, 1, 15};

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
  [[nodiscard]] std::size_t extra_bits_of_all() const {
    return std::size_t{2} * counts[16] + std::size_t{3} * counts[17] + std::size_t{7} * counts[18];
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

inline std::uint32_t four_bytes(const std::uint8_t* from) {
  return from[0] | std::uint32_t{from[1]} << 8 | std::uint32_t{from[2]} << 16 |
         std::uint32_t{from[3]} << 24;
}

inline std::uint64_t eight_bytes(const std::uint8_t* from) {
  return four_bytes(from) | std::uint64_t{four_bytes(from + 4)} << 32;
}

/// How many bytes two places have in common.
/// @param length  so many are known to be
inline std::size_t same_bytes(const std::uint8_t* a, const std::uint8_t* b, std::size_t length,
                              std::size_t most) {
  for (; length + 8 <= most; length += 8) {
    const std::uint64_t apart = eight_bytes(a + length) ^ eight_bytes(b + length);
    if (apart != 0) return length + static_cast<std::size_t>(std::countr_zero(apart)) / 8;
  }
  while (length < most && a[length] == b[length]) ++length;
  return length;
}

/// The codes of a block as it is written, and its bits without those that follow symbols.
struct BlockCodes {
  Lengths<symbols> lengths;
  Lengths<distances> distance_lengths;
  std::size_t all_symbols = 0;
  std::size_t all_distances = 0;
  RunLengths runs{};
  Lengths<19> run_lengths{};
  std::size_t all_runs = 0;
  bool own = false;  ///< false: the fixed codes take fewer
  std::size_t bits = 0;
};

/// Bytes and repetitions that will be written with the same codes.
class Block {
 public:
  explicit Block(std::size_t tokens) { tokens_.reserve(tokens); }

  [[nodiscard]] std::size_t size() const { return tokens_.size(); }
  [[nodiscard]] const std::array<std::uint32_t, symbols>& counts() const { return counts_; }
  [[nodiscard]] const std::array<std::uint32_t, distances>& distance_counts() const {
    return distance_counts_;
  }

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
  /// Adds what another block holds.
  void append(const Block& other) {
    tokens_.insert(tokens_.end(), other.tokens_.begin(), other.tokens_.end());
    for (std::size_t i = 0; i < symbols; ++i) counts_[i] += other.counts_[i];
    for (std::size_t i = 0; i < distances; ++i) distance_counts_[i] += other.distance_counts_[i];
  }
  void clear() {
    tokens_.clear();
    counts_ = {};
    distance_counts_ = {};
  }

  /// Codes of its own or the fixed ones, whichever take fewer bits. The end of the block counts.
  [[nodiscard]] BlockCodes codes() const {
    std::array<std::uint32_t, symbols> counts = counts_;
    ++counts[end_of_block];
    BlockCodes codes{lengths_for(counts, 15), lengths_for(distance_counts_, 15)};
    const auto used = [](const auto& all, std::size_t least) {
      std::size_t size = all.size();
      while (size > least && all[size - 1] == 0) --size;
      return size;
    };
    codes.all_symbols = used(codes.lengths, 257);
    codes.all_distances = used(codes.distance_lengths, 1);
    codes.runs.add_all({codes.lengths.data(), codes.all_symbols});
    codes.runs.add_all({codes.distance_lengths.data(), codes.all_distances});
    codes.run_lengths = lengths_for(codes.runs.counts, 7);
    codes.all_runs = run_order.size();
    while (codes.all_runs > 4 && codes.run_lengths[run_order[codes.all_runs - 1]] == 0)
      --codes.all_runs;

    const std::size_t own = 14 + 3 * codes.all_runs +
                            bits_with(codes.runs.counts, codes.run_lengths) +
                            codes.runs.extra_bits_of_all() + bits_with(counts, codes.lengths) +
                            bits_with(distance_counts_, codes.distance_lengths);
    const std::size_t fixed =
        bits_with(counts, fixed_lengths) + bits_with(distance_counts_, fixed_distance_lengths);
    codes.own = own < fixed;
    if (!codes.own) {
      codes.lengths = fixed_lengths;
      codes.distance_lengths = fixed_distance_lengths;
    }
    codes.bits = 3 + std::min(own, fixed);
    return codes;
  }

  /// Writes the block and empties it.
  void put(BitWriter& out, bool is_last) {
    const BlockCodes chosen = codes();
    out.put(is_last ? 1 : 0, 1);
    out.put(chosen.own ? 2 : 1, 2);
    if (chosen.own) {
      out.put(chosen.all_symbols - 257, 5);
      out.put(chosen.all_distances - 1, 5);
      out.put(chosen.all_runs - 4, 4);
      for (std::size_t i = 0; i < chosen.all_runs; ++i)
        out.put(chosen.run_lengths[run_order[i]], 3);
      const std::array<Code, 19> codes = codes_of(chosen.run_lengths);
      for (const RunLengths::Run& run : chosen.runs.runs) {
        out.put(codes[run.symbol]);
        out.put(run.extra, RunLengths::extra_bits(run.symbol));
      }
    }
    put_tokens(out, codes_of(chosen.lengths), codes_of(chosen.distance_lengths));
    clear();
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

}  // namespace texmap::rfc1951
