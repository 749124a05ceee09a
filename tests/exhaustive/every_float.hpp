// Runs functions over every float of an interval, on all cores, against a reference in double.
#pragma once
#include <doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "engine/draw/threads.hpp"
#include "number/kinds/pack.hpp"
#include "number/number.hpp"

namespace texmap::test {

/// 1 runs every float; where programs are slow, only one row of so many is run.
inline constexpr int one_row_of = TEXMAP_EXHAUSTIVE_ONE_OF;

using Floats = Pack<float>;
using Wide = Pack<double>;

/// Consecutive floats, and what is known of them.
struct Block {
  static constexpr std::size_t size = 1024;
  alignas(64) std::array<float, size> x;
  alignas(64) std::array<float, size> beside;  ///< a second argument that belongs to x
  alignas(64) std::array<double, size> exact;  ///< the reference
};

/// One function of a float: how to run it, and what it must keep to.
struct Candidate {
  std::string name;
  std::function<void(const Block&, float*)> run;
  double bound = 0;               ///< largest error
  double step_back = 0;           ///< largest step against its direction, between neighbors
  float lowest = 0, highest = 1;  ///< its range
  bool falls = false;
  double offset = 0, factor = 1;  ///< the exact result is offset + factor * reference
  bool in_ulps = false;           ///< the bound's unit, else 1

  /// The error of a result.
  [[nodiscard]] double error_of(float is, double reference) const {
    const double should = offset + factor * reference;
    const double off = std::abs(static_cast<double>(is) - should);
    if (!in_ulps) return off;
    // The distance of floats at `should`, by its exponent.
    const auto exponent =
        std::max<std::uint64_t>(std::bit_cast<std::uint64_t>(std::abs(should)) >> 52, 1023U - 126U);
    return off / std::bit_cast<double>((exponent - 23) << 52);
  }
  [[nodiscard]] double back(float before, float is) const {
    return static_cast<double>(falls ? is - before : before - is);
  }
  [[nodiscard]] bool in_range(float is) const { return is >= lowest && is <= highest; }
};

/// A reference that fills `exact`, and `beside` where a candidate needs it.
using Prepare = std::function<void(Block&)>;

/// What was seen of a candidate.
struct Seen {
  double worst = 0, back = 0;
  std::uint64_t wrong = 0;  ///< results that break a promise, NaN too
  float wrong_at = 0;
};

/// Runs a function of packs over an array of blocks' x.
template <class T, class Function>
void in_packs(const T* from, T* to, const Function& function) {
  using Real = Pack<T>;
  for (std::size_t i = 0; i < Block::size; i += lanes<Real>)
    function(Real(Real::Batch::load_aligned(from + i))).batch().store_unaligned(to + i);
}

/// A candidate from a function of one pack of floats.
template <class Function>
[[nodiscard]] std::function<void(const Block&, float*)> by_packs(Function function) {
  return [function](const Block& block, float* to) { in_packs(block.x.data(), to, function); };
}
/// A candidate from a function of one plain float.
template <class Function>
[[nodiscard]] std::function<void(const Block&, float*)> one_by_one(Function function) {
  return [function](const Block& block, float* to) {
    for (std::size_t i = 0; i < Block::size; ++i) to[i] = function(block.x[i]);
  };
}

/// Judges a block's results; `before` is the result of the float before the first.
inline void judge(const Candidate& candidate, const Block& block, const float* is, float before,
                  Seen& seen) {
  alignas(64) std::array<double, Block::size> wide;
  alignas(64) std::array<float, Block::size> earlier;
  for (std::size_t i = 0; i < Block::size; ++i) wide[i] = static_cast<double>(is[i]);
  earlier[0] = before;
  std::copy(is, is + Block::size - 1, earlier.begin() + 1);

  // The worst of the block, in packs.
  const Floats lowest(candidate.lowest), highest(candidate.highest);
  Floats back(0);
  auto outside = !(lowest <= highest);
  for (std::size_t i = 0; i < Block::size; i += lanes<Floats>) {
    const Floats now(Floats::Batch::load_aligned(is + i));
    const Floats then(Floats::Batch::load_aligned(earlier.data() + i));
    outside = outside || !(now >= lowest && now <= highest);
    back = max(candidate.falls ? now - then : then - now, back);
  }
  double worst = 0;
  if (candidate.in_ulps) {
    for (std::size_t i = 0; i < Block::size; ++i)
      worst = std::max(worst, candidate.error_of(is[i], block.exact[i]));
  } else {
    const Wide offset(candidate.offset), factor(candidate.factor);
    Wide off(0);
    for (std::size_t i = 0; i < Block::size; i += lanes<Wide>) {
      const Wide should = offset + factor * Wide(Wide::Batch::load_aligned(block.exact.data() + i));
      off = max(abs(Wide(Wide::Batch::load_aligned(wide.data() + i)) - should), off);
    }
    for (const double each : all_lanes(off)) worst = std::max(worst, each);
  }
  double most_back = 0;
  for (const float each : all_lanes(back)) most_back = std::max(most_back, double{each});
  seen.worst = std::max(seen.worst, worst);
  seen.back = std::max(seen.back, most_back);
  if (!any(outside) && worst <= candidate.bound && most_back <= candidate.step_back) return;

  // A promise is broken: where?
  for (std::size_t i = 0; i < Block::size; ++i) {
    if (candidate.in_range(is[i]) && candidate.error_of(is[i], block.exact[i]) <= candidate.bound &&
        candidate.back(earlier[i], is[i]) <= candidate.step_back)
      continue;
    ++seen.wrong;
    seen.wrong_at = block.x[i];
  }
}

/// Numbers in rising order: the one at an index, and how many there are.
struct Inputs {
  std::uint64_t count;
  std::function<float(std::uint64_t index)> at;
};

/// Every float from `low` to `high`, both 0 or more: the bits of such floats count upward.
[[nodiscard]] inline Inputs every_float(float low, float high) {
  const std::uint64_t first = std::bit_cast<std::uint32_t>(low);
  return {std::bit_cast<std::uint32_t>(high) - first + 1, [first](std::uint64_t index) {
            return std::bit_cast<float>(static_cast<std::uint32_t>(first + index));
          }};
}

/// 1 - cos for every float cos from 0 to 1: multiples of 2^-24, exactly from cos = 1/2 on and by
/// rounding below.
[[nodiscard]] inline Inputs versines_of_every_cosine() {
  return {(1U << 24) + 1, [](std::uint64_t index) { return static_cast<float>(index) * 0x1p-24F; }};
}

/// Runs all candidates over the inputs and checks what they must keep to.
inline void check_all(const Inputs& inputs, const Prepare& prepare,
                      const std::vector<Candidate>& candidates) {
  constexpr std::uint64_t row_size = 64 * Block::size;
  const auto rows = static_cast<int>((inputs.count + row_size - 1) / row_size);
  std::vector<Seen> all(candidates.size());
  std::mutex mutex;
  for_each_row((rows + one_row_of - 1) / one_row_of, 0, {}, [&](int row) {
    std::vector<Seen> seen(candidates.size());
    std::vector<float> before(candidates.size());
    const std::uint64_t start = static_cast<std::uint64_t>(row) * one_row_of * row_size;
    Block block;
    alignas(64) std::array<float, Block::size> is;
    // A row begins one number earlier, so that no step between rows is missed.
    const std::uint64_t first = start > 0 ? start - 1 : 0;
    const std::uint64_t end = std::min(start + row_size, inputs.count);
    for (std::uint64_t at = first; at < end; at += Block::size) {
      for (std::size_t i = 0; i < Block::size; ++i)  // the last again at the end
        block.x[i] = inputs.at(std::min(at + i, inputs.count - 1));
      prepare(block);
      for (std::size_t k = 0; k < candidates.size(); ++k) {
        candidates[k].run(block, is.data());
        judge(candidates[k], block, is.data(), at == first ? is[0] : before[k], seen[k]);
        before[k] = is[Block::size - 1];
      }
    }
    const std::lock_guard lock(mutex);
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k].worst = std::max(all[k].worst, seen[k].worst);
      all[k].back = std::max(all[k].back, seen[k].back);
      all[k].wrong += seen[k].wrong;
      if (seen[k].wrong > 0) all[k].wrong_at = seen[k].wrong_at;
    }
  });
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Candidate& candidate = candidates[k];
    CAPTURE(candidate.name);
    CAPTURE(all[k].wrong_at);
    MESSAGE(candidate.name << ": " << inputs.count / one_row_of << " floats, at worst "
                           << all[k].worst << " of " << candidate.bound
                           << std::string(candidate.in_ulps ? " ulp" : "") << ", steps back by "
                           << all[k].back << " of " << candidate.step_back);
    CHECK(all[k].wrong == 0);
  }
}

}  // namespace texmap::test
