// Drawing one of many things by chance, each with its own probability, in constant time.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "number/compensated.hpp"

namespace texmap {

/// A list of boxes, all drawn equally often. A box holds up to two things: its own, with a share,
/// and another one, with the rest.
/// The number of boxes is a power of two, so that 24 random bits choose each equally often.
/// Source: Walker (1977); Vose, "A Linear Algorithm for Generating Random Numbers" (1991).
class AliasTable {
 public:
  struct Box {
    double share = 0;         ///< of the box's own thing, 0 to 1
    std::uint32_t other = 0;  ///< the thing that has the rest
  };

  AliasTable() : boxes_{{1, 0}} {}
  /// @param weights  0 or more, at least one above 0; 1 to 2^24 of them
  /// Errors: std::invalid_argument for other weights.
  explicit AliasTable(const std::vector<double>& weights)
      : boxes_(std::bit_ceil(weights.empty() ? 1 : weights.size())) {
    CompensatedSum<double> sum;
    for (const double weight : weights) {
      if (!(weight >= 0)) throw std::invalid_argument("a weight is below 0");
      sum.add(weight);
    }
    const double total = sum.value();
    if (!(total > 0) || !(total < infinity<double>()) || boxes_.size() > (std::size_t{1} << 24))
      throw std::invalid_argument("weights that nothing can be drawn by");
    fill(weights, total);
  }

  /// The thing that a sample draws.
  ///
  /// @param u, v  in [0, 1), multiples of 2^-24: u chooses the box, v one of its two things
  [[nodiscard]] std::uint32_t draw(double u, double v) const {
    const auto box = static_cast<std::uint32_t>(u * static_cast<double>(boxes_.size()));
    return v < boxes_[box].share ? box : boxes_[box].other;
  }

  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

 private:
  /// Fills boxes that have too little from things that have too much.
  void fill(const std::vector<double>& weights, double total) {
    const auto count = static_cast<double>(boxes_.size());
    std::vector<std::uint32_t> small;
    std::vector<std::uint32_t> large;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const auto thing = static_cast<std::uint32_t>(i);
      boxes_[i] = {i < weights.size() ? weights[i] / total * count : 0.0, thing};
      (boxes_[i].share < 1 ? small : large).push_back(thing);
    }
    std::size_t next = 0;  // of `small`
    for (const std::uint32_t giver : large) {
      CompensatedSum<double> left;  // a sun gives thousands of times
      left.add(boxes_[giver].share);
      while (left.value() > 1 && next < small.size()) {
        Box& box = boxes_[small[next++]];
        box.other = giver;
        left.add(box.share);
        left.add(-1.0);
      }
      boxes_[giver].share = left.value();
      if (left.value() < 1) small.push_back(giver);
    }
    // What rounding has left over.
    for (; next < small.size(); ++next) {
      Box& box = boxes_[small[next]];
      if (box.share > 0.5) {
        box.share = 1;
      } else {
        box.other = largest(weights);
      }
    }
    for (Box& box : boxes_) box.share = min(box.share, 1.0);
  }

  [[nodiscard]] static std::uint32_t largest(const std::vector<double>& weights) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < weights.size(); ++i) {
      if (weights[i] > weights[best]) best = i;
    }
    return static_cast<std::uint32_t>(best);
  }

  std::vector<Box> boxes_;
};

}  // namespace texmap
