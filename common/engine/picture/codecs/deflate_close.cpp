// Close packing. At each byte all lengths of repetitions are found, each at its nearest place. The
// cheapest way to write the bytes is the shortest path through a graph: its nodes are the places
// between bytes, its edges are bytes and repetitions, and an edge costs the bits that it takes.
// These depend on the codes, and the codes on the path. So it is sought several times, each time
// with the costs of the one before. Source: zopfli (Alakuijala and Vandevenne, 2013).
#include "engine/picture/codecs/deflate_close.hpp"

#include <algorithm>
#include <limits>

namespace texmap::rfc1951 {
namespace {

constexpr std::size_t shortest_match = 3;
constexpr std::size_t long_enough = 130;  // bytes: nothing else is tried at such a repetition
constexpr std::size_t segment_bytes = 1U << 20;  // for which a way is sought at a time
constexpr std::size_t tokens_a_piece = 2048;     // blocks are made of pieces
constexpr int most_compared = 48;                // places at one byte
constexpr int rounds = 3;

struct Match {
  std::uint16_t length = 0;  // 0: a byte
  std::uint16_t back = 0;    // the distance less 1
};

/// Finds repetitions in a binary tree for each three bytes: the latest place is the root, and
/// branches are in the order of what follows there. Source: Wei Dai and Igor Pavlov's LZMA.
class Trees {
 public:
  explicit Trees(Bytes bytes) : bytes_(bytes), roots_(1U << root_bits), children_(2 * places) {}

  /// Adds the repetitions at a place, each longer and further away than the one before, and
  /// remembers the place.
  void find(std::size_t at, std::vector<Match>& matches) {
    const std::size_t most = std::min(longest_match, bytes_.size() - at);
    if (most < shortest_match) return;
    const std::uint8_t* const here = bytes_.data() + at;
    const std::uint32_t three =
        here[0] | std::uint32_t{here[1]} << 8 | std::uint32_t{here[2]} << 16;
    std::uint32_t& root = roots_[(three * 2654435761U) >> (32 - root_bits)];
    std::uint32_t node = root;
    root = static_cast<std::uint32_t>(at) + 1;
    std::uint32_t* less = children(root);
    std::uint32_t* more = less + 1;
    std::size_t same_as_less = 0, same_as_more = 0;
    std::size_t best = shortest_match - 1;
    for (int left = most_compared; left > 0 && node > 0 && root - node <= window; --left) {
      const std::uint8_t* const there = bytes_.data() + node - 1;
      std::size_t length = std::min(same_as_less, same_as_more);
      length = same_bytes(there, here, length, most);
      std::uint32_t* const below = children(node);
      if (length > best) {
        best = length;
        matches.push_back(
            {static_cast<std::uint16_t>(length), static_cast<std::uint16_t>(root - node - 1)});
      }
      if (length == most || length >= long_enough) {
        *less = below[0];
        *more = below[1];
        return;
      }
      if (there[length] < here[length]) {
        *less = node;
        less = below + 1;
        node = *less;
        same_as_less = length;
      } else {
        *more = node;
        more = below;
        node = *more;
        same_as_more = length;
      }
    }
    *less = 0;
    *more = 0;
  }

 private:
  static constexpr int root_bits = 16;
  static constexpr std::size_t places = 2 * window;

  std::uint32_t* children(std::uint32_t node) { return &children_[2 * (node % places)]; }

  Bytes bytes_;
  std::vector<std::uint32_t> roots_;  // a place plus 1; 0: none
  std::vector<std::uint32_t> children_;
};

/// All repetitions of a segment.
struct Segment {
  Bytes bytes;
  std::vector<Match> matches;
  std::vector<std::uint32_t> first;  // of each place, and one more

  [[nodiscard]] std::span<const Match> at(std::size_t place) const {
    return std::span(matches).subspan(first[place], first[place + 1] - first[place]);
  }
};

Segment segment_of(Bytes bytes, std::size_t begin, Trees& trees) {
  const std::size_t size = std::min(segment_bytes, bytes.size() - begin);
  Segment segment{bytes.subspan(begin, size), {}, {}};
  segment.first.reserve(size + 1);
  std::size_t skipped = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t first = segment.matches.size();
    segment.first.push_back(static_cast<std::uint32_t>(first));
    trees.find(begin + i, segment.matches);
    if (i < skipped) segment.matches.resize(first);
    // Repetitions end with the segment: of those that would go on, the nearest is enough.
    for (std::size_t k = first; k < segment.matches.size(); ++k) {
      if (segment.matches[k].length < size - i) continue;
      segment.matches[k].length = static_cast<std::uint16_t>(size - i);
      segment.matches.resize(size - i < shortest_match ? k : k + 1);
    }
    if (segment.matches.size() > first && segment.matches.back().length >= long_enough)
      skipped = i + segment.matches.back().length;
  }
  segment.first.push_back(static_cast<std::uint32_t>(segment.matches.size()));
  return segment;
}

constexpr std::uint32_t bit = 64;  // the unit of costs is a 64th of a bit

/// The logarithm to base 2 in whole units, the same on every machine.
/// @param x  at least 1
constexpr std::uint32_t logarithm(std::uint32_t x) {
  const auto whole = static_cast<std::uint32_t>(std::bit_width(x)) - 1;
  std::uint64_t y = std::uint64_t{x} << (31 - whole);  // 1 to 2, with 31 bits behind the point
  std::uint32_t result = whole;
  for (std::uint32_t unit = 1; unit < bit; unit *= 2) {
    y = y * y >> 31;
    result = 2 * result + static_cast<std::uint32_t>(y >> 32);
    y >>= y >> 32;
  }
  return result;
}
static_assert(logarithm(1) == 0 && logarithm(1024) == 10 * bit && logarithm(3) == 101);

/// What each edge costs.
struct Costs {
  std::array<std::uint32_t, 256> byte;
  std::array<std::uint32_t, longest_match + 1> length;
  std::array<std::uint32_t, distances> distance;
};

/// By how often symbols occur, as if their codes could have parts of a bit.
template <std::size_t n>
std::array<std::uint32_t, n> costs_of(const std::array<std::uint32_t, n>& counts) {
  std::uint32_t sum = 0;
  for (const std::uint32_t count : counts) sum += count;
  std::array<std::uint32_t, n> costs;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t ratio = logarithm(std::max(sum, 1U)) - logarithm(std::max(counts[i], 1U));
    costs[i] = std::clamp(ratio + (counts[i] == 0 ? bit : 0), bit, 15 * bit);
  }
  return costs;
}

Costs costs_of(const Block& block) {
  const std::array<std::uint32_t, symbols> of_symbols = costs_of(block.counts());
  Costs costs{{}, {}, costs_of(block.distance_counts())};
  std::copy_n(of_symbols.begin(), costs.byte.size(), costs.byte.begin());
  for (std::size_t length = shortest_match; length <= longest_match; ++length) {
    const Split& split = length_splits[length - 3];
    costs.length[length] = of_symbols[split.symbol] + bit * static_cast<std::uint32_t>(split.count);
  }
  for (std::uint32_t symbol = 4; symbol < distances; ++symbol)
    costs.distance[symbol] += bit * (symbol / 2 - 1);
  return costs;
}

/// Blocks, and where in their segment they end.
struct Way {
  std::vector<Block> blocks;
  std::vector<std::size_t> ends;

  void add(Block&& piece, std::size_t end) {
    if (!blocks.empty()) {
      // Pieces share their codes where that takes fewer bits.
      Block both = blocks.back();
      both.append(piece);
      if (both.codes().bits <= blocks.back().codes().bits + piece.codes().bits) {
        blocks.back() = std::move(both);
        ends.back() = end;
        return;
      }
    }
    blocks.push_back(std::move(piece));
    ends.push_back(end);
  }
};

/// Cuts a way into blocks.
/// @param step  the match with which a place is left, or a byte
template <class Step>
Way blocks_of(const Segment& segment, const Step& step) {
  Way way;
  Block piece(tokens_a_piece);
  for (std::size_t at = 0; at < segment.bytes.size();) {
    const Match match = step(at);
    if (match.length > 0) {
      piece.add_match(match.length, match.back + std::size_t{1});
      at += match.length;
    } else {
      piece.add(segment.bytes[at++]);
    }
    if (piece.size() < tokens_a_piece && at < segment.bytes.size()) continue;
    way.add(std::move(piece), at);
    piece = Block(tokens_a_piece);
  }
  return way;
}

/// The first way takes the longest match everywhere.
Way first_way(const Segment& segment) {
  return blocks_of(segment, [&](std::size_t at) {
    const std::span<const Match> matches = segment.at(at);
    return matches.empty() ? Match{} : matches.back();
  });
}

/// The cheapest way by the costs of another.
Way cheapest_way(const Segment& segment, const Way& before) {
  const std::size_t size = segment.bytes.size();
  std::vector<std::uint32_t> cost(size + 1, std::numeric_limits<std::uint32_t>::max());
  std::vector<Match> into(size + 1);  // the edge on which a place is reached
  cost[0] = 0;
  std::size_t block = 0;
  Costs costs = costs_of(before.blocks[0]);
  for (std::size_t at = 0; at < size; ++at) {
    if (at == before.ends[block]) costs = costs_of(before.blocks[++block]);
    const auto reach = [&](std::size_t place, std::uint32_t by, Match edge) {
      if (by >= cost[place]) return;
      cost[place] = by;
      into[place] = edge;
    };
    reach(at + 1, cost[at] + costs.byte[segment.bytes[at]], {});
    std::size_t length = shortest_match;
    for (const Match& match : segment.at(at)) {
      const std::uint32_t there = cost[at] + costs.distance[split(match.back, 2).symbol];
      if (match.length >= long_enough) length = match.length;
      for (; length <= match.length; ++length) {
        reach(at + length, there + costs.length[length],
              {static_cast<std::uint16_t>(length), match.back});
      }
    }
  }
  // From the end back, edges are moved to where they begin.
  std::vector<Match>& from = into;
  Match edge = into[size];
  for (std::size_t at = size; at > 0;) {
    const Match here = edge;
    at -= std::max<std::size_t>(here.length, 1);
    edge = into[at];
    from[at] = here;
  }
  return blocks_of(segment, [&](std::size_t at) { return from[at]; });
}

}  // namespace

void put_closely(BitWriter& out, Bytes bytes) {
  Trees trees(bytes);
  for (std::size_t begin = 0; begin < bytes.size(); begin += segment_bytes) {
    const Segment segment = segment_of(bytes, begin, trees);
    Way way = first_way(segment);
    for (int round = 0; round < rounds; ++round) way = cheapest_way(segment, way);
    const bool is_last = begin + segment.bytes.size() == bytes.size();
    for (Block& block : way.blocks) block.put(out, is_last && &block == &way.blocks.back());
  }
  if (bytes.empty()) Block(0).put(out, true);
}

}  // namespace texmap::rfc1951
