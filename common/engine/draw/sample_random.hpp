// The random numbers of the samples of some pixels, made in blocks.
#pragma once
#include <algorithm>
#include <array>

#include "engine/draw/inline_whole.hpp"
#include "sampling/samplers.hpp"

namespace texmap {

/// The numbers of a block of samples, for a pack of pixels. A dimension's are made, for the whole
/// block, when its first sample asks: what the samples share is then computed once.
template <class Real>
struct RandomBlock {
  static constexpr int at_once = 16;  ///< samples: the numbers of the widest packs take 16 KiB
  static constexpr int kept = 4;      ///< dimensions; paths in open scenes seldom need more

  const Sampler* sampler = nullptr;
  UInt<Real> pixels{};
  int first = 0, end = 0;  ///< samples
  int made = 0;            ///< dimensions that have numbers
  std::array<std::array<Point2<Real>, at_once>, kept> pairs;
  Point2<Real> other;  ///< of a dimension that is not kept

  [[nodiscard]] const Point2<Real>& pair(int sample, int dimension) {
    if (dimension >= made) return make(sample, dimension);
    return pairs[static_cast<std::size_t>(dimension)][static_cast<std::size_t>(sample - first)];
  }
  /// The same for a dimension without numbers.
  [[nodiscard]] TEXMAP_NOINLINE const Point2<Real>& make(int sample, int dimension) {
    const auto d = static_cast<std::uint32_t>(dimension);
    if (dimension >= kept)
      return other = sampler->pair<Real>(pixels, static_cast<std::uint32_t>(sample), d);
    auto& of_samples = pairs[static_cast<std::size_t>(dimension)];
    sampler->visit([&](const auto& pattern) {
      inline_whole<Real>([&] {
        for (int i = first; i < end; ++i) {
          of_samples[static_cast<std::size_t>(i - first)] =
              pattern.template pair<Real>(pixels, static_cast<std::uint32_t>(i), d);
        }
      });
    });
    made = dimension + 1;
    return of_samples[static_cast<std::size_t>(sample - first)];
  }
};

/// The numbers of one sample: those of Sampler::pair, one dimension after another.
template <class Real>
class SampleRandom {
 public:
  SampleRandom(RandomBlock<Real>& block, int sample) : block_(block), sample_(sample) {}

  /// The next two numbers in [0, 1): each call has its own dimension.
  ///
  /// @return  valid until the next call. By reference: copying a pack would store it in pieces and
  ///          stall loading it whole.
  [[nodiscard]] const Point2<Real>& next_2d() { return block_.pair(sample_, dimension_++); }

 private:
  RandomBlock<Real>& block_;
  int sample_;
  int dimension_ = 0;
};

/// Calls a work with the numbers of each sample and sums what it returns.
template <class Real>
class SampleSums {
 public:
  /// `sampler` must live as long as the sums.
  explicit SampleSums(const Sampler& sampler) { block_.sampler = &sampler; }

  /// @param pixels      from hash_pixels
  /// @param first, end  the samples from first to end - 1
  /// @param work        called with SampleRandom
  /// @param sum         what the results are added to
  template <class Work, class Sum>
  void add(const UInt<Real>& pixels, int first, int end, const Work& work, Sum& sum) {
    block_.pixels = pixels;
    inline_whole<Real>([&] {
      for (block_.first = first; block_.first < end; block_.first = block_.end) {
        block_.end = std::min(block_.first + block_.at_once, end);
        block_.made = 0;
        for (int sample = block_.first; sample < block_.end; ++sample) {
          SampleRandom<Real> random(block_, sample);
          sum = sum + work(random);
        }
      }
    });
  }

 private:
  RandomBlock<Real> block_;
};

}  // namespace texmap
