// Drawing one of many things by chance, each with its own probability, by one random number.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "number/number.hpp"
#include "number/refuse.hpp"

namespace texmap {

/// A list of things that lie one after another on the line from 0 to 1, each as long as it is
/// probable. A random number draws the thing that lies there, and near numbers draw neighbors.
/// The line has 2^24 steps, one for each random number; each thing has a whole number of them.
class CumulativeTable {
 public:
  static constexpr std::uint32_t steps = std::uint32_t{1} << 24;

  CumulativeTable() : CumulativeTable(std::vector<double>{1}) {}
  /// @param weights  0 or more, at least one above 0; 1 to 2^23 of them
  /// Errors: std::invalid_argument for other weights.
  /// Bound: each thing with a weight has a step. The others are shared by weight, off by 1 at most.
  explicit CumulativeTable(const std::vector<double>& weights) {
    double total = 0;
    std::uint32_t things = 0;  // with a weight
    for (const double weight : weights) {
      if (!(weight >= 0)) refuse_argument("a weight is below 0");
      total += weight;
      things += weight > 0 ? 1 : 0;
    }
    if (things == 0 || !(total < infinity<double>()) || weights.size() > steps / 2)
      refuse_argument("weights that nothing can be drawn by");
    const double shared = steps - things;
    double sum = 0;  // grows as `total` did, so that it ends there
    std::uint32_t so_far = 0;
    for (const double weight : weights) {
      sum += weight;
      so_far += weight > 0 ? 1 : 0;
      edges_.push_back(so_far + static_cast<std::uint32_t>(std::lround(shared * (sum / total))));
    }
    const int bits = max(static_cast<int>(std::bit_width(weights.size() - 1)) - 2, 0);
    shift_ = 24 - bits;
    for (std::uint32_t part = 0, thing = 0; part >> bits == 0; ++part) {
      while (edges_[thing + 1] <= part << shift_) ++thing;
      first_.push_back(thing);
    }
  }

  struct Drawn {
    std::uint32_t thing;
    double place;  ///< where in the thing, above 0 and below 1
  };
  /// The thing that a random number draws.
  ///
  /// @param u  in [0, 1); of more digits than 24 the rest is cut off
  [[nodiscard]] Drawn draw(double u) const {
    const auto step = static_cast<std::uint32_t>(u * steps);
    std::uint32_t thing = first_[step >> shift_];
    while (edges_[thing + 1] <= step) ++thing;
    return {thing, (step - edges_[thing] + 0.5) / steps_of(thing)};
  }
  /// How many of the 2^24 random numbers draw the thing.
  [[nodiscard]] std::uint32_t steps_of(std::uint32_t thing) const {
    return edges_[thing + 1] - edges_[thing];
  }

 private:
  std::vector<std::uint32_t> edges_{0};  ///< in steps: thing i lies from edge i to edge i + 1
  std::vector<std::uint32_t> first_;     ///< the thing at the start of each of 2^k equal parts
  int shift_ = 24;                       ///< a part has 2^shift steps
};

}  // namespace texmap
