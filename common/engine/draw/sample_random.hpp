// The random numbers of the samples of some pixels, made in blocks.
#pragma once
#include <algorithm>
#include <array>
#include <utility>

#include "engine/draw/inline_whole.hpp"
#include "sampling/samplers.hpp"

namespace texmap {

/// The numbers of a block of samples, for a pack of pixels.
template <class Real>
struct RandomBlock {
  static constexpr int at_once = 16;  ///< samples: the numbers of the widest packs take 16 KiB
  static constexpr int kept = 4;      ///< dimensions; paths in open scenes seldom need more

  const Sampler* sampler = nullptr;
  UInt<Real> pixels{};
  int first = 0;  ///< first sample of the block
  int made = 0;   ///< dimensions that have numbers, at least 1
  std::array<std::array<Point2<Real>, at_once>, kept> pairs;

  Point2<Real> other;  ///< of a dimension that is not kept

  [[nodiscard]] TEXMAP_NOINLINE const Point2<Real>& make_other(int sample, int dimension) {
    return other = sampler->pair<Real>(pixels, static_cast<std::uint32_t>(sample),
                                       static_cast<std::uint32_t>(dimension));
  }
};

/// The numbers of one sample: those of Sampler::pair, one dimension after another.
/// Domain: block.made is 1 or more.
template <class Real>
class SampleRandom {
 public:
  SampleRandom(RandomBlock<Real>& block, int sample) : block_(block), sample_(sample) {}

  /// The next two numbers in [0, 1): each call has its own dimension.
  ///
  /// @return  valid until the next call; not yet the right numbers while lack() is true. By
  ///          reference: copying a pack would store it in pieces and stall loading it whole.
  [[nodiscard]] const Point2<Real>& next_2d() {
    const int dimension = dimension_++;
    if (dimension >= block_.kept) return block_.make_other(sample_, dimension);
    return block_.pairs[static_cast<std::size_t>(dimension < block_.made ? dimension : 0)]
                       [static_cast<std::size_t>(sample_ - block_.first)];
  }

  /// How many of the kept pairs have been asked for.
  [[nodiscard]] int asked() const { return std::min(dimension_, block_.kept); }
  /// True if a pair was asked for that does not exist yet.
  [[nodiscard]] bool lack() const { return asked() > block_.made; }

 private:
  RandomBlock<Real>& block_;
  int sample_;
  int dimension_ = 0;
};

/// Calls a work with the numbers of each sample and sums what it returns.
/// Numbers are made for a whole block first. If the work asks for more dimensions than there are,
/// they are made and the sample is done again; later blocks have them from the start.
template <class Real>
class SampleSums {
 public:
  /// `sampler` must live as long as the sums.
  explicit SampleSums(const Sampler& sampler) { block_.sampler = &sampler; }

  /// @param pixels      from hash_pixels
  /// @param first, end  the samples from first to end - 1
  /// @param work        called with SampleRandom; may be called again for the same sample
  /// @param sum         what the results are added to
  template <class Work, class Sum>
  void add(const UInt<Real>& pixels, int first, int end, const Work& work, Sum& sum) {
    inline_whole<Real>([&] { add_samples(pixels, first, end, work, sum); });
  }

 private:
  template <class Work, class Sum>
  void add_samples(const UInt<Real>& pixels, int first, int end, const Work& work, Sum& sum) {
    block_.pixels = pixels;
    // Starts with as many as the last pixel used. A pack would repeat too many samples.
    if constexpr (lanes<Real> == 1) needed_ = std::exchange(asked_, 1);
    int sample = first;
    while (sample < end) {
      const int begin = sample;
      const int stop = std::min(begin + block_.at_once, end);
      block_.first = begin;
      block_.made = 0;
      do {
        make(stop - begin);
        for (; sample < stop; ++sample) {
          SampleRandom<Real> random(block_, sample);
          const Sum light = work(random);
          asked_ = std::max(asked_, random.asked());
          if (random.lack()) {
            needed_ = asked_;
            break;
          }
          sum = sum + light;
        }
      } while (sample < stop);
    }
  }

  /// Makes the dimensions that are needed and missing.
  TEXMAP_NOINLINE void make(int count) {
    block_.sampler->visit([&](const auto& pattern) {
      inline_whole<Real>([&] {  // what does not depend on the sample is then computed once
        for (; block_.made < needed_; ++block_.made) {
          auto& pairs = block_.pairs[static_cast<std::size_t>(block_.made)];
          for (int i = 0; i < count; ++i) {
            pairs[static_cast<std::size_t>(i)] = pattern.template pair<Real>(
                block_.pixels, static_cast<std::uint32_t>(block_.first + i),
                static_cast<std::uint32_t>(block_.made));
          }
        }
      });
    });
  }

  RandomBlock<Real> block_;
  int needed_ = 1;  ///< dimensions
  int asked_ = 1;   ///< the most that a sample asked for, since `needed_` was set
};

}  // namespace texmap
