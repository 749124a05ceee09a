// The random numbers of the samples of some pixels, made by blocks and handed out one pair after another.
#pragma once
#include <algorithm>
#include <array>

#include "compiler.hpp"
#include "samplers.hpp"

namespace texmap {

/// The numbers of a block of samples, for a pack of pixels.
template <class Real>
struct NumberBlock {
  static constexpr int at_once = 16;  ///< samples: all numbers of the widest packs take 16 KiB
  static constexpr int kept = 4;      ///< dimensions; paths through open scenes seldom need more

  const Sampler* sampler = nullptr;
  Bits<Real> pixels{};
  int first = 0;  ///< sample of the block
  int made = 0;   ///< dimensions whose numbers are there, at least 1
  std::array<std::array<Sample2<Real>, at_once>, kept> pairs;

  Sample2<Real> other;  ///< of a dimension that is not kept

  [[nodiscard]] TEXMAP_NOINLINE const Sample2<Real>& make_other(int sample, int dimension) {
    return other = sampler->pair<Real>(pixels, static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(dimension));
  }
};

/// The numbers of one sample: those of Sampler::pair, dimension after dimension.
///
/// Domain: block.made is 1 or more.
template <class Real>
class SampleNumbers {
 public:
  SampleNumbers(NumberBlock<Real>& block, int sample) : block_(block), sample_(sample) {}

  /// The next two numbers in [0, 1): every use in a sample has a dimension of its own.
  ///
  /// @return  where they stand until the next are asked for: a copy of packs goes through memory in small pieces, and who loads
  ///          it whole has to wait. While lack() is true, wrong numbers
  [[nodiscard]] const Sample2<Real>& pair() {
    const int dimension = dimension_++;
    if (dimension >= block_.kept) return block_.make_other(sample_, dimension);
    return block_.pairs[static_cast<std::size_t>(dimension < block_.made ? dimension : 0)]
                       [static_cast<std::size_t>(sample_ - block_.first)];
  }

  /// How many pairs have been asked for, of those that are kept.
  [[nodiscard]] int asked() const { return std::min(dimension_, block_.kept); }
  /// True if one was asked for that is not there yet.
  [[nodiscard]] bool lack() const { return asked() > block_.made; }

 private:
  NumberBlock<Real>& block_;
  int sample_;
  int dimension_ = 0;
};

/// Calls a work with the numbers of each sample, and adds up what it returns.
///
/// Numbers are made for a block of samples before it is worked on: a sampler's pattern is chosen once a block, what a
/// dimension's samples have in common is calculated once, the work is compiled once for all patterns, and its loop has no call
/// that would take its registers away. How many dimensions the work needs shows when it asks: then they are made, the sample is
/// worked on again, and later blocks have them from the start.
template <class Real>
class SampleSums {
 public:
  /// @param sampler  is looked at as long as the sums are in use
  explicit SampleSums(const Sampler& sampler) { block_.sampler = &sampler; }

  /// @param pixels      from pixel_bits
  /// @param first, end  the samples; none from `end` on
  /// @param work        called with SampleNumbers, gives what depends on them alone; a sample's work may be done again
  /// @param sum         to which all that is added
  template <class Work, class Sum>
  TEXMAP_FLATTEN void add(const Bits<Real>& pixels, int first, int end, const Work& work, Sum& sum) {
    block_.pixels = pixels;
    int sample = first;
    while (sample < end) {
      const int begin = sample;
      const int stop = std::min(begin + block_.at_once, end);
      block_.first = begin;
      block_.made = 0;
      do {
        make(stop - begin);
        for (; sample < stop; ++sample) {
          SampleNumbers<Real> numbers(block_, sample);
          const Sum light = work(numbers);
          if (numbers.lack()) {
            needed_ = numbers.asked();
            break;
          }
          sum = sum + light;
        }
      } while (sample < stop);
    }
  }

 private:
  /// Makes the dimensions that are needed and not yet there.
  TEXMAP_NOINLINE void make(int count) {
    block_.sampler->visit([&](const auto& pattern) {
      for (; block_.made < needed_; ++block_.made) {
        for (int i = 0; i < count; ++i) {
          block_.pairs[static_cast<std::size_t>(block_.made)][static_cast<std::size_t>(i)] = pattern.template pair<Real>(
              block_.pixels, static_cast<std::uint32_t>(block_.first + i), static_cast<std::uint32_t>(block_.made));
        }
      }
    });
  }

  NumberBlock<Real> block_;
  int needed_ = 1;  ///< dimensions
};

}  // namespace texmap
