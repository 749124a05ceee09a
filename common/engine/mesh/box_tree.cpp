// A tree of boxes around the triangles of a mesh: a ray then tries few of them.
#include "engine/mesh/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace texmap {
namespace {

using Axes = std::array<double, 3>;

struct Bounds {
  Axes low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Axes high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Axes& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  void add(const Bounds& other) {
    add(other.low);
    add(other.high);
  }
  /// Half the surface: the chance of a ray to meet the box grows with it.
  [[nodiscard]] double half_surface() const {
    const double x = high[0] - low[0];
    const double y = high[1] - low[1];
    const double z = high[2] - low[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
};

class Builder {
 public:
  explicit Builder(Mesh& mesh)
      : mesh_(mesh), bounds_(mesh.triangles.size()), middles_(bounds_.size()) {
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const Point& p = mesh.corner(static_cast<int>(i), corner);
        bounds_[i].add(Axes{p.x, p.y, p.z});
      }
      for (std::size_t k = 0; k < 3; ++k)
        middles_[i][k] = 0.5 * bounds_[i].low[k] + 0.5 * bounds_[i].high[k];
    }
    mesh.order.resize(bounds_.size());
    std::iota(mesh.order.begin(), mesh.order.end(), 0);
  }

  // Adds the box of the triangles order[first] to order[end - 1], and the boxes inside it.
  void add_box(int first, int end, int depth = 0) {
    Bounds around, middles;
    for (int i = first; i < end; ++i) {
      around.add(bounds_of(i));
      middles.add(middle_of(i));
    }
    const std::size_t place = mesh_.boxes.size();
    mesh_.boxes.push_back(box_of(around));
    const Split split = split_of(first, end, around, middles, depth);
    if (split.place == end) {
      mesh_.boxes[place].first = first;
      mesh_.boxes[place].end = end;
      return;
    }
    mesh_.boxes[place].axis = split.axis;
    add_box(first, split.place, depth + 1);
    mesh_.boxes[place].second = static_cast<int>(mesh_.boxes.size());
    add_box(split.place, end, depth + 1);
  }

 private:
  static constexpr int few = 4;          // triangles that always share a box
  static constexpr int many = 16;        // triangles that may share one
  static constexpr int deepest = 40;     // then boxes are halved: 21 more for 2^21 triangles
  static constexpr int bins = 16;        // places where a box may be cut
  static constexpr double box_cost = 1;  // of a box, in triangles

  [[nodiscard]] const Bounds& bounds_of(int i) const {
    return bounds_[static_cast<std::size_t>(mesh_.order[static_cast<std::size_t>(i)])];
  }
  [[nodiscard]] const Axes& middle_of(int i) const {
    return middles_[static_cast<std::size_t>(mesh_.order[static_cast<std::size_t>(i)])];
  }

  // The box of some bounds; rounding makes it larger.
  static MeshBox box_of(const Bounds& b) {
    Axes center{}, half{};
    for (std::size_t k = 0; k < 3; ++k) {
      center[k] = 0.5 * b.low[k] + 0.5 * b.high[k];
      half[k] = std::max(b.high[k] - center[k], center[k] - b.low[k]) *
                (1 + 4 * std::numeric_limits<double>::epsilon());
    }
    return {{center[0], center[1], center[2]}, {half[0], half[1], half[2]}, 0, 0, 0, 0};
  }

  struct Split {
    int place;  // where the second group begins; `end` for one group
    int axis;
  };
  // Sorts the triangles into two groups.
  Split split_of(int first, int end, const Bounds& around, const Bounds& middles, int depth) {
    const int all = end - first;
    if (all <= few) return {end, 0};
    if (depth > deepest) return {(first + end) / 2, 0};
    double best_cost = HUGE_VAL;
    std::size_t best_axis = 0;
    int best_bin = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(middles.high[axis] > middles.low[axis])) continue;
      std::array<Bounds, bins> in_bin;
      std::array<int, bins> count{};
      for (int i = first; i < end; ++i) {
        const int bin = bin_of(middle_of(i)[axis], middles.low[axis], middles.high[axis]);
        in_bin[static_cast<std::size_t>(bin)].add(bounds_of(i));
        ++count[static_cast<std::size_t>(bin)];
      }
      std::array<double, bins> cost_above{};
      Bounds above;
      int triangles = 0;
      for (std::size_t bin = bins - 1; bin > 0; --bin) {
        above.add(in_bin[bin]);
        triangles += count[bin];
        cost_above[bin] = above.half_surface() * triangles;
      }
      Bounds below;
      triangles = 0;
      for (std::size_t bin = 1; bin < bins; ++bin) {
        below.add(in_bin[bin - 1]);
        triangles += count[bin - 1];
        const double cost = below.half_surface() * triangles + cost_above[bin];
        if (triangles == 0 || triangles == end - first || !(cost < best_cost)) continue;
        best_cost = cost;
        best_axis = axis;
        best_bin = static_cast<int>(bin);
      }
    }
    if (best_bin == 0)  // the middles of all triangles are at one place
      return {all > many ? (first + end) / 2 : end, 0};
    const double whole = around.half_surface();
    if (all <= many && best_cost + box_cost * whole >= whole * all) return {end, 0};
    const auto middle =
        std::partition(mesh_.order.begin() + first, mesh_.order.begin() + end, [&](int triangle) {
          const double at = middles_[static_cast<std::size_t>(triangle)][best_axis];
          return bin_of(at, middles.low[best_axis], middles.high[best_axis]) < best_bin;
        });
    return {static_cast<int>(middle - mesh_.order.begin()), static_cast<int>(best_axis)};
  }

  static int bin_of(double at, double low, double high) {
    const double place = (at - low) / (high - low) * bins;
    return place < bins - 1 ? static_cast<int>(place) : bins - 1;
  }

  Mesh& mesh_;
  std::vector<Bounds> bounds_;
  std::vector<Axes> middles_;
};

}  // namespace

void build_box_tree(Mesh& mesh) {
  mesh.boxes.clear();
  Builder builder(mesh);
  if (!mesh.triangles.empty()) builder.add_box(0, static_cast<int>(mesh.triangles.size()));
}

}  // namespace texmap
