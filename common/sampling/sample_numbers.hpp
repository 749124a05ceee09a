// The random numbers of the samples of some pixels, handed out one pair after another.
#pragma once
#include <algorithm>
#include <array>

#include "compiler.hpp"
#include "samplers.hpp"

namespace texmap {

/// The numbers of a range of samples in a pack of pixels: those of Sampler::pair, dimension after dimension.
///
/// They are made for a block of samples when its first one asks for a dimension. So a sampler's pattern is chosen once a block,
/// what a dimension's samples have in common is calculated once, and what uses the numbers is compiled once for all patterns.
template <class Real>
class SampleNumbers {
 public:
  /// @param sampler  and
  /// @param pixels   from pixel_bits: are looked at as long as numbers are asked for
  /// @param first, end  the samples: begins at the first; there are none from `end` on
  SampleNumbers(const Sampler& sampler, const Bits<Real>& pixels, int first, int end)
      : sampler_(sampler),
        pixels_(pixels),
        sample_(static_cast<std::uint32_t>(first)),
        block_(sample_),
        end_(static_cast<std::uint32_t>(end)) {}

  /// The next two numbers in [0, 1): every use in a sample has a dimension of its own.
  /// Domain: not after the last sample.
  [[nodiscard]] Sample2<Real> pair() {
    const std::uint32_t dimension = dimension_++;
    if (dimension >= kept) return alone(dimension);
    if (dimension >= made_) make(dimension);
    return numbers_[dimension][sample_ - block_];
  }

  /// Goes on to the next sample, and begins with dimension 0 again.
  void next_sample() {
    ++sample_;
    dimension_ = 0;
    if (sample_ == block_ + at_once) {
      block_ = sample_;
      made_ = 0;
    }
  }

 private:
  static constexpr std::uint32_t at_once = 16;  ///< samples of a block: all kept numbers of the widest packs fit into 16 KiB
  static constexpr std::uint32_t kept = 4;      ///< dimensions; paths through open scenes seldom need more

  TEXMAP_NOINLINE void make(std::uint32_t dimension) {
    sampler_.visit([&](const auto& pattern) {
      const std::uint32_t count = std::min(at_once, end_ - block_);
      for (std::uint32_t i = 0; i < count; ++i) {
        numbers_[dimension][i] = pattern.template pair<Real>(pixels_, block_ + i, dimension);
      }
    });
    made_ = dimension + 1;
  }

  [[nodiscard]] TEXMAP_NOINLINE Sample2<Real> alone(std::uint32_t dimension) const {
    return sampler_.template pair<Real>(pixels_, sample_, dimension);
  }

  const Sampler& sampler_;
  const Bits<Real>& pixels_;
  std::uint32_t sample_;
  std::uint32_t block_;  ///< its first sample
  std::uint32_t end_;
  std::uint32_t dimension_ = 0;
  std::uint32_t made_ = 0;  ///< dimensions of the block whose numbers are there
  std::array<std::array<Sample2<Real>, at_once>, kept> numbers_;
};

}  // namespace texmap
