// The numbers over which the tests of common/sampling run: all of them must give the same. And a
// source of samples for what draws its own.
#pragma once
#include "number/kinds/pack2.hpp"
#include "sampling/samplers.hpp"

#define TEXMAP_SAMPLED_NUMBERS                                           \
  float, double, long double, texmap::Pack<float>, texmap::Pack<double>, \
      texmap::Pack2<texmap::Pack<float>>, texmap::Pack2<texmap::Pack<double>>

namespace texmap::test {

/// The numbers of one sample, the same in every lane and whoever draws them.
template <class Real>
struct SampledNumbers {
  Sampler sampler;
  std::uint32_t sample = 0;
  std::uint32_t dimension = 0;

  [[nodiscard]] Point2<Real> next_2d() {
    return sampler.pair<Real>(UInt<Real>(hash_bits(7U)), sample, dimension++);
  }
};

}  // namespace texmap::test
