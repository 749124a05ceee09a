// Where the samples of a pixel lie: four patterns in the unit square.
#pragma once
#include <algorithm>
#include <bit>

#include "number/refuse.hpp"
#include "sampling/hash.hpp"
#include "sampling/point2.hpp"
#include "sampling/sampler_kind.hpp"

namespace texmap {

namespace sampling {

/// The next key of random bits: half a hash, the least that keeps small Sobol' nets uniform.
template <class Integers>
[[nodiscard]] inline Integers next_key(Integers key) {
  key = (key ^ (key >> 15)) * 0x2c1b3c6dU;
  return key ^ (key >> 12);
}

/// A permutation of the integers below `count`, one of many, chosen by a key.
struct Shuffle {
  std::uint32_t count = 1;
  std::uint32_t mask = 0;  ///< the smallest 2^k - 1 that is not below count - 1
  int half = 1;            ///< half of k
  int less = 1;            ///< half - 1: with equal shifts the lowest bit mixes badly

  Shuffle() = default;
  explicit Shuffle(std::uint32_t how_many)
      : count(how_many),
        mask(std::bit_ceil(how_many) - 1),
        half((std::countr_one(mask | 1U) + 1) / 2),
        less(std::max(half - 1, 1)) {}

  /// A permutation of the integers from 0 to `mask`.
  /// Source: after Kensler, "Correlated Multi-Jittered Sampling", Pixar memo 13-01 (2013).
  template <class Integers>
  [[nodiscard]] Integers within_mask(Integers i, const Integers& key) const {
    i = ((i ^ key) * ((key >> 9) | 1U)) & mask;
    i = i ^ (i >> half);
    i = ((i ^ (key >> 5)) * ((key >> 17) | 1U)) & mask;
    i = i ^ (i >> less);
    i = ((i ^ (key >> 13)) * ((key >> 22) | 1U)) & mask;
    i = i ^ (i >> half);
    i = ((i ^ (key >> 26)) * ((key >> 3) | 1U)) & mask;
    return i ^ (i >> less);
  }

  /// A permutation of the integers below any `count`: a random rotation, then six rounds, each of
  /// which mirrors the integers at a random place and swaps a pair if a random bit is set.
  /// Source: Hoang, Morris and Rogaway, "An Enciphering Scheme Based on a Card Shuffle" (2012).
  template <class Integers>
  [[nodiscard]] Integers within_count(Integers i, Integers key) const {
    const auto below_count = [this](const Integers& random) {
      return Integers(((random >> 16) * count) >> 16);
    };
    i = i + below_count(key);
    i = lesser(i, Integers(i - count));  // a negative integer wraps to a large one
    for (int round = 0; round < 6; ++round) {
      key = key * 0x9e3779b1U + 0x7f4a7c15U;
      const Integers apart = below_count(key) - i;
      const Integers mirrored = lesser(apart, Integers(apart + count));
      const Integers pair = i + mirrored - lesser(i, mirrored);  // the larger one
      const Integers coin = (pair + pair + 1U) * (key ^ (key >> 15));
      i = i ^ ((i ^ mirrored) & (0U - (coin >> 31)));
    }
    return i;
  }

  /// The image of `i` under the permutation of `key`.
  template <class Integers>
  [[nodiscard]] Integers operator()(const Integers& i, const Integers& key) const {
    return mask + 1 == count ? within_mask(i, key) : within_count(i, key);
  }

 private:
  template <class Integers>
  [[nodiscard]] static Integers lesser(const Integers& a, const Integers& b) {
    return select_less(a, b, a, b);
  }
};

/// The unit interval cut into `count` equal strata, in units of 2^-32.
struct Strata {
  std::uint32_t step = 0;      ///< from one stratum to the next
  std::uint32_t width = 0;     ///< of a stratum, in units of 2^-16
  std::uint32_t round_up = 0;  ///< keeps the upper 24 bits inside the stratum

  Strata() = default;
  explicit Strata(std::uint32_t count) {
    constexpr std::uint64_t whole = std::uint64_t{1} << 32;
    const bool exact = std::has_single_bit(count);
    step = static_cast<std::uint32_t>((whole + count - 1) / count);  // 0 for one stratum
    width = static_cast<std::uint32_t>((whole / count - (exact ? 0 : 256 + count)) >> 16);
    round_up = exact ? 0 : 255;
  }

  /// A point of stratum `i`, chosen by 16 random bits, for unit_interval.
  /// For other counts than powers of two its end is left out; the mean is up to 2^-15.9 too small.
  template <class Integers>
  [[nodiscard]] Integers point(const Integers& i, const Integers& random) const {
    return i * step + (random * width + round_up);
  }
};

/// A grid with a cell for each of `count` samples, about as wide as high.
/// If count = a b with a <= b <= 2 a, it has a columns and b rows. Otherwise it has the root of
/// count, rounded down, as columns, and less than one row of cells too many.
struct CellGrid {
  std::uint32_t count = 1;  ///< samples
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
  std::uint32_t inverse = 1;  ///< 2^shift / columns, rounded up
  int shift = 0;

  CellGrid() = default;
  explicit CellGrid(std::uint32_t samples) : count(samples) {
    std::uint32_t root = 1;
    while ((root + 1) * (root + 1) <= count) ++root;
    columns = root;
    for (std::uint32_t a = root; 2 * a * a >= count; --a) {
      if (count % a == 0) {
        columns = a;
        break;
      }
    }
    rows = (count + columns - 1) / columns;
    shift = std::min(std::countl_zero(rows), 24);
    inverse = ((std::uint32_t{1} << shift) + columns - 1) / columns;
  }

  /// cell / columns, rounded down, for all cells of the grid.
  template <class Integers>
  [[nodiscard]] Integers row_of(const Integers& cell) const {
    return (cell * inverse) >> shift;
  }
};

/// All bits in reverse order.
template <class Integers>
[[nodiscard]] inline Integers reverse_bits(Integers x) {
  x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
  x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
  x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x >> 8) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8);
  return (x >> 16) | (x << 16);
}

/// Owen's scrambling of a fraction with reversed bits: each bit is flipped at random, depending
/// on the bits of larger value, which are the lower ones here.
/// Source: Laine and Karras (2011), as in Burley, "Practical Hash-based Owen Scrambling" (2020);
/// constants by Vegdahl, "Building a Better LK Hash" (2021).
template <class Integers>
[[nodiscard]] inline Integers scramble_reversed(Integers x, const Integers& key) {
  x = x ^ (x * 0x3d20adeaU);
  x = x + key;
  x = x * ((key >> 16) | 1U);
  x = x ^ (x * 0x05526c56U);
  return x ^ (x * 0x53a22864U);
}

/// The second coordinate of point `index` of Sobol's sequence, with reversed bits; the first is
/// `index`. Bit k is the parity of the index's bits j with binomial(j, k) odd.
/// Domain: index below 2^16. Source: Sobol' (1967), dimension 2.
template <class Integers>
[[nodiscard]] inline Integers sobol_second_reversed(Integers index) {
  index = index ^ ((index >> 1) & 0x55555555U);
  index = index ^ ((index >> 2) & 0x33333333U);
  index = index ^ ((index >> 4) & 0x0f0f0f0fU);
  return index ^ ((index >> 8) & 0x00ff00ffU);
}

/// The random key of one pixel and one dimension.
template <class Integers>
[[nodiscard]] inline Integers dimension_key(const Integers& pixel, std::uint32_t seed,
                                            std::uint32_t dimension) {
  return hash_bits(Integers(pixel ^ (seed + dimension * 0x9e3779b9U)));
}

/// 32 random bits for one sample.
template <class Integers>
[[nodiscard]] inline Integers sample_bits(const Integers& key, std::uint32_t sample) {
  return hash_bits(Integers(key ^ (sample * 0xb5297a4dU + 0x68e31da4U)));
}

}  // namespace sampling

/// Independent samples: the error of a mean of n falls as n^-1/2.
struct RandomPattern {
  std::uint32_t seed = 0;

  template <class Real>
  [[nodiscard]] Point2<Real> pair(const UInt<Real>& pixel, std::uint32_t sample,
                                  std::uint32_t dimension) const {
    const UInt<Real> place = pixel ^ (seed + dimension * 0x9e3779b9U + sample * 0xb5297a4dU);
    return {unit_interval<Real>(hash_bits(place)),
            unit_interval<Real>(hash_bits(UInt<Real>(place ^ 0x68e31da4U)))};
  }
};

/// One sample in each cell of a grid, the cells shuffled for each pixel and dimension.
/// If the grid has more cells than samples, each pixel leaves out others.
struct StratifiedPattern {
  std::uint32_t seed = 0;
  sampling::CellGrid grid;
  sampling::Shuffle cells;
  sampling::Strata across, down;

  StratifiedPattern(std::uint32_t samples, std::uint32_t first_key)
      : seed(first_key),
        grid(samples),
        cells(grid.columns * grid.rows),
        across(grid.columns),
        down(grid.rows) {}

  template <class Real>
  [[nodiscard]] Point2<Real> pair(const UInt<Real>& pixel, std::uint32_t sample,
                                  std::uint32_t dimension) const {
    const UInt<Real> key = sampling::dimension_key(pixel, seed, dimension);
    const UInt<Real> cell = cells(UInt<Real>(sample), key);
    const UInt<Real> row = grid.row_of(cell);
    const UInt<Real> column = cell - row * grid.columns;
    const UInt<Real> random = sampling::sample_bits(key, sample);
    return {unit_interval<Real>(across.point(column, UInt<Real>(random >> 16))),
            unit_interval<Real>(down.point(row, UInt<Real>(random & 0xffffU)))};
  }
};

/// One sample in each cell, and one in each of as many columns and rows as there are samples;
/// shuffled for each pixel and dimension. If the grid has more cells than samples, there are as
/// many columns as cells, and sometimes two samples in a cell.
/// Source: Kensler, "Correlated Multi-Jittered Sampling", Pixar memo 13-01 (2013).
struct MultiJitterPattern {
  std::uint32_t seed = 0;
  sampling::CellGrid grid;
  sampling::Shuffle samples_order, columns_order, rows_order;
  sampling::Strata across, down;

  MultiJitterPattern(std::uint32_t samples, std::uint32_t first_key)
      : seed(first_key),
        grid(samples),
        samples_order(samples),
        columns_order(grid.columns),
        rows_order(grid.rows),
        across(grid.columns * grid.rows),
        down(samples) {}

  template <class Real>
  [[nodiscard]] Point2<Real> pair(const UInt<Real>& pixel, std::uint32_t sample,
                                  std::uint32_t dimension) const {
    const UInt<Real> key = sampling::dimension_key(pixel, seed, dimension);
    const UInt<Real> columns_key = sampling::next_key(key);
    const UInt<Real> rows_key = sampling::next_key(columns_key);
    const UInt<Real> place = samples_order(UInt<Real>(sample), key);
    const UInt<Real> row = grid.row_of(place);
    const UInt<Real> column = columns_order(place - row * grid.columns, columns_key);
    const UInt<Real> within = rows_order(row, rows_key);
    const UInt<Real> random = sampling::sample_bits(key, sample);
    return {unit_interval<Real>(
                across.point(UInt<Real>(column * grid.rows + within), UInt<Real>(random >> 16))),
            unit_interval<Real>(down.point(place, UInt<Real>(random & 0xffffU)))};
  }
};

/// Sobol's sequence in two dimensions, Owen-scrambled for each pixel and dimension.
/// 2^k samples are a net: one in each cell of every grid of 2^j x 2^(k-j) cells. Other counts are
/// several nets. Samples are shuffled within a net; only a whole net is evenly spread.
/// Source: Burley, "Practical Hash-based Owen Scrambling" (2020), with another shuffling.
struct SobolPattern {
  std::uint32_t seed = 0;
  std::uint32_t samples = 1;

  template <class Real>
  [[nodiscard]] Point2<Real> pair(const UInt<Real>& pixel, std::uint32_t sample,
                                  std::uint32_t dimension) const {
    const UInt<Real> key = sampling::dimension_key(pixel, seed, dimension);
    const UInt<Real> v_key = sampling::next_key(key);
    const UInt<Real> order_key = sampling::next_key(v_key);

    // The net of the sample: its size is the largest bit in which sample and samples differ.
    const std::uint32_t size = std::bit_floor(sample ^ samples);
    const std::uint32_t first = sample & ~(size - 1U);
    const UInt<Real> index =
        sampling::Shuffle(size).within_mask(UInt<Real>(sample), order_key) | first;

    // Both coordinates keep 16 scrambled bits, so one reversal serves both; lower bits are random.
    const UInt<Real> u = sampling::scramble_reversed(index, key);
    const UInt<Real> v = sampling::scramble_reversed(sampling::sobol_second_reversed(index), v_key);
    const UInt<Real> both = sampling::reverse_bits(UInt<Real>((u & 0xffffU) | (v << 16)));
    return {unit_interval<Real>((both & 0xffff0000U) | (u >> 16)),
            unit_interval<Real>((both << 16) | (v >> 16))};
  }
};

/// The samples of all pixels of a picture: the same kind, count and seed give the same numbers.
/// To add a pattern, write a struct with `pair` and name it in SamplerKind and in `visit`.
class Sampler {
 public:
  /// @param samples  of a pixel, 1 to most_samples
  /// @param seed     any number; another one gives another picture of the same scene
  /// Errors: std::invalid_argument for another number of samples.
  Sampler(SamplerKind kind, int samples, std::uint32_t seed = 0)
      : kind_(kind),
        samples_(checked(samples)),
        seed_(hash_bits(seed + 0x9e3779b9U)),
        stratified_(samples_, seed_),
        multi_jitter_(samples_, seed_) {}

  [[nodiscard]] int samples() const { return static_cast<int>(samples_); }

  /// Calls `work` with the pattern of this sampler's kind; all patterns must return the same type.
  template <class Work>
  decltype(auto) visit(Work&& work) const {
    switch (kind_) {
      case SamplerKind::stratified:
        return work(stratified_);
      case SamplerKind::multi_jitter:
        return work(multi_jitter_);
      case SamplerKind::sobol:
        return work(SobolPattern{seed_, samples_});
      case SamplerKind::random:
        break;
    }
    return work(RandomPattern{seed_});
  }

  /// Two numbers in [0, 1) for each pixel, multiples of 2^-24, the same for every Real.
  ///
  /// @param pixel      from hash_pixels
  /// @param sample     0 to samples - 1
  /// @param dimension  0 in the pixel, then lens and time if they blur, then bounces
  template <class Real>
  [[nodiscard]] Point2<Real> pair(const UInt<Real>& pixel, std::uint32_t sample,
                                  std::uint32_t dimension) const {
    return visit(
        [&](const auto& pattern) { return pattern.template pair<Real>(pixel, sample, dimension); });
  }

 private:
  [[nodiscard]] static std::uint32_t checked(int samples) {
    if (samples < 1 || samples > most_samples) {
      refuse_argument("samples per pixel: " + std::to_string(samples) + " is not from 1 to " +
                      std::to_string(most_samples));
    }
    return static_cast<std::uint32_t>(samples);
  }

  SamplerKind kind_;
  std::uint32_t samples_;
  std::uint32_t seed_;
  StratifiedPattern stratified_;
  MultiJitterPattern multi_jitter_;
};

}  // namespace texmap
