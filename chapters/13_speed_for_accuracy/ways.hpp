// A way to draw that is tried: a row with its bound, what was seen of its errors, and its time. The
// table, the JSON, the plots and the recommendations walk the rows.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "engine/compare/interleaved.hpp"
#include "engine/compare/machine.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/fast/turns.hpp"
#include "sampling/samplers.hpp"
#include "scenes.hpp"

namespace texmap::chapter_13 {

/// One way to draw the globe.
struct Variant {
  NumberKind number = NumberKind::double_;
  Instructions instructions = Instructions::baseline;
  int degree = 0;  ///< of the (u, v) kernel's arc tangent; 0 for the reference formula
  Filter filter = Filter::nearest;
  Curve curve = Curve::none;

  bool operator==(const Variant&) const = default;
};

/// What the rows of a run are about, in its order. Errors are in levels of 255, but for places.
enum class Part {
  places,    ///< every number, kernel and filter: how far off a place is, in texels
  curves,    ///< from texels through light to bytes: how far off a channel is before rounding
  samplers,  ///< samplers and samples: root mean squares over pixels and channels
};
inline constexpr std::array all_parts = {Part::places, Part::curves, Part::samplers};

/// A way that is tried.
struct Row {
  Part part;
  Variant variant = {};
  SamplerKind sampler = SamplerKind::sobol;
  int samples = 1;  ///< rays per pixel

  double bound = 0;                  ///< never exceeded
  double worst = 0, mean = 0;        ///< seen; places nearer to the rim than least_cosine aside
  long changed = 0, may_change = 0;  ///< pixels with other bytes than the reference
  int levels = 0, levels_bound = 0;  ///< the largest change of a byte

  WorkTime took = {0, 0, 1};  ///< for one picture on one thread
  double time = 0;            ///< as a part of what the first row of its part took
};

/// Rows that something is said about.
using Rows = std::vector<const Row*>;

/// All that was measured in one run.
struct Measurements {
  Machine machine;
  int width = 0, height = 0;  ///< of the pictures of places and curves, pixels
  std::array<std::vector<Row>, all_parts.size()> parts = {};
  int skipped = 0;  ///< rounds of timing, because the time limit was reached
  double rays = 0;  ///< that were timed

  [[nodiscard]] std::vector<Row>& of(Part part) { return parts[static_cast<std::size_t>(part)]; }
  [[nodiscard]] const std::vector<Row>& of(Part part) const {
    return parts[static_cast<std::size_t>(part)];
  }
  /// Those of a part that `may_be` is true of.
  template <class MayBe>
  [[nodiscard]] Rows some_of(Part part, const MayBe& may_be) const {
    Rows some;
    for (const Row& row : of(part)) {
      if (may_be(row)) some.push_back(&row);
    }
    return some;
  }
};

/// Called with how many parts of a phase of the run are done, and how many it has.
using Tick = std::function<void(int done, int total)>;

}  // namespace texmap::chapter_13
