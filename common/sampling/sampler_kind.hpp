// The names of the four sampling patterns.
#pragma once

namespace texmap {

/// How the samples of a pixel are chosen.
enum class SamplerKind {
  random,        ///< independent
  stratified,    ///< one in each cell of a grid
  multi_jitter,  ///< one in each cell, and one in each of as many columns and rows as samples
  sobol,         ///< one in each cell of every grid of powers of two
};

/// The most samples of a pixel: up to here the samplers' integers fit into 32 bits.
inline constexpr int most_samples = 1 << 14;

}  // namespace texmap
