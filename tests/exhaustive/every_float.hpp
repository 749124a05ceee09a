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
#include <limits>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "engine/render/threads.hpp"
#include "number/kinds/pack.hpp"
#include "number/number.hpp"

namespace texmap::test {

/// 1 runs every float; where programs are slow, only one row of so many is run.
inline constexpr int one_row_of = TEXMAP_EXHAUSTIVE_ONE_OF;

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
};

/// A reference that fills `exact`, and `beside` where a candidate needs it.
using Prepare = std::function<void(Block&)>;

/// What was seen of a candidate.
struct Seen {
  double worst = 0, back = 0;
  float worst_at = 0, back_at = 0, outside_at = 0;
  std::uint64_t outside = 0;  ///< results out of range, NaN too

  void merge(const Seen& other) {
    if (other.worst > worst) worst = other.worst, worst_at = other.worst_at;
    if (other.back > back) back = other.back, back_at = other.back_at;
    if (other.outside > 0) outside += other.outside, outside_at = other.outside_at;
  }
};

/// The distance of floats at `x`, a double.
[[nodiscard]] inline double float_ulp(double x) {
  const auto exponent =
      std::max<std::uint64_t>(std::bit_cast<std::uint64_t>(std::abs(x)) >> 52, 1023U - 126U);
  return std::bit_cast<double>((exponent - 23) << 52);
}

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

/// The error of one result.
[[nodiscard]] inline double error_of(const Candidate& candidate, float is, double reference) {
  const double should = candidate.offset + candidate.factor * reference;
  const double off = std::abs(static_cast<double>(is) - should);
  return candidate.in_ulps ? off / float_ulp(should) : off;
}

/// Judges a block's results; `before` is the result of the float before the first.
inline void judge(const Candidate& candidate, const Block& block, const float* is, float before,
                  Seen& seen) {
  using F = Pack<float>;
  using D = Pack<double>;
  alignas(64) std::array<double, Block::size> wide;
  alignas(64) std::array<float, Block::size> earlier;
  for (std::size_t i = 0; i < Block::size; ++i) wide[i] = static_cast<double>(is[i]);
  earlier[0] = before;
  std::copy(is, is + Block::size - 1, earlier.begin() + 1);

  // Range and steps.
  const F lowest(candidate.lowest), highest(candidate.highest);
  F back(0);
  auto outside = !(lowest <= highest);
  for (std::size_t i = 0; i < Block::size; i += lanes<F>) {
    const F now(F::Batch::load_aligned(is + i));
    const F then(F::Batch::load_aligned(earlier.data() + i));
    outside = outside || !(now >= lowest && now <= highest);
    back = max(candidate.falls ? now - then : then - now, back);
  }
  if (any(outside)) {
    for (std::size_t i = 0; i < Block::size; ++i) {
      if (is[i] >= candidate.lowest && is[i] <= candidate.highest) continue;
      ++seen.outside;
      seen.outside_at = block.x[i];
    }
  }
  for (const float step : all_lanes(back)) {
    if (static_cast<double>(step) <= seen.back) continue;
    seen.back = static_cast<double>(step);
    for (std::size_t i = 0; i < Block::size; ++i) {
      if ((candidate.falls ? is[i] - earlier[i] : earlier[i] - is[i]) == step)
        seen.back_at = block.x[i];
    }
  }

  // Errors.
  D worst(0);
  if (candidate.in_ulps) {
    double most = 0;
    for (std::size_t i = 0; i < Block::size; ++i)
      most = std::max(most, error_of(candidate, is[i], block.exact[i]));
    worst = D(most);
  } else {
    const D offset(candidate.offset), factor(candidate.factor);
    for (std::size_t i = 0; i < Block::size; i += lanes<D>) {
      const D should = offset + factor * D(D::Batch::load_aligned(block.exact.data() + i));
      worst = max(abs(D(D::Batch::load_aligned(wide.data() + i)) - should), worst);
    }
  }
  for (const double off : all_lanes(worst)) {
    if (off <= seen.worst) continue;
    seen.worst = off;
    for (std::size_t i = 0; i < Block::size; ++i) {
      if (error_of(candidate, is[i], block.exact[i]) == off) seen.worst_at = block.x[i];
    }
  }
}

/// Numbers in rising order: the one at an index, and how many there are.
struct Inputs {
  std::uint64_t count;
  std::function<void(std::uint64_t first, std::span<float>)> fill;  ///< the last again at the end
};

/// Every float from `low` to `high`, both 0 or more: the bits of such floats count upward.
[[nodiscard]] inline Inputs every_float(float low, float high) {
  const std::uint64_t first = std::bit_cast<std::uint32_t>(low);
  const std::uint64_t last = std::bit_cast<std::uint32_t>(high);
  return {last - first + 1, [=](std::uint64_t index, std::span<float> x) {
            for (std::size_t i = 0; i < x.size(); ++i) {
              const std::uint64_t bits = std::min(first + index + i, last);
              x[i] = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
            }
          }};
}

/// 1 - cos for every float cos from 0 to 1: multiples of 2^-24, exactly from cos = 1/2 on and by
/// rounding below.
[[nodiscard]] inline Inputs versines_of_every_cosine() {
  const std::uint64_t last = 1U << 24;
  return {last + 1, [last](std::uint64_t index, std::span<float> x) {
            for (std::size_t i = 0; i < x.size(); ++i)
              x[i] = static_cast<float>(std::min(index + i, last)) * 0x1p-24F;
          }};
}

/// What all candidates do with the inputs.
[[nodiscard]] inline std::vector<Seen> see_all(const Inputs& inputs, const Prepare& prepare,
                                               std::span<const Candidate> candidates) {
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
      inputs.fill(at, block.x);
      prepare(block);
      for (std::size_t k = 0; k < candidates.size(); ++k) {
        candidates[k].run(block, is.data());
        judge(candidates[k], block, is.data(), at == first ? is[0] : before[k], seen[k]);
        before[k] = is[Block::size - 1];
      }
    }
    const std::lock_guard lock(mutex);
    for (std::size_t k = 0; k < all.size(); ++k) all[k].merge(seen[k]);
  });
  return all;
}

/// Runs all candidates over the inputs and checks what they must keep to.
inline void check_all(const Inputs& inputs, const Prepare& prepare,
                      const std::vector<Candidate>& candidates) {
  const std::vector<Seen> all = see_all(inputs, prepare, candidates);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Candidate& candidate = candidates[k];
    const Seen& seen = all[k];
    CAPTURE(candidate.name);
    CAPTURE(seen.worst_at);
    CAPTURE(seen.back_at);
    CAPTURE(seen.outside_at);
    MESSAGE(candidate.name << ": " << inputs.count / one_row_of << " floats, at worst "
                           << seen.worst << " of " << candidate.bound
                           << std::string(candidate.in_ulps ? " ulp" : "") << ", steps back by "
                           << seen.back << " of " << candidate.step_back);
    CHECK(seen.outside == 0);
    CHECK(seen.worst <= candidate.bound);
    CHECK(seen.back <= candidate.step_back);
  }
}

}  // namespace texmap::test
