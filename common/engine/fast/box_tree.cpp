// A tree of boxes around the triangles of a mesh: a ray then tries few of them.
#include "engine/fast/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace texmap {
namespace {

using Axes = std::array<float, 3>;

struct Bounds {
  Axes low{HUGE_VALF, HUGE_VALF, HUGE_VALF};
  Axes high{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

  void add(const Axes& from, const Axes& to) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], from[k]);
      high[k] = std::max(high[k], to[k]);
    }
  }
  void add(const Bounds& other) { add(other.low, other.high); }
  /// Twice the middle along an axis.
  [[nodiscard]] float middle(std::size_t axis) const { return low[axis] + high[axis]; }
  /// Half the surface: the chance of a ray to meet the box grows with it.
  [[nodiscard]] float half_surface() const {
    const float x = high[0] - low[0];
    const float y = high[1] - low[1];
    const float z = high[2] - low[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
};

struct Numbered : Bounds {
  int triangle;
};

// Triangles that will share a box: those from `first` to before `end`.
struct Group : Bounds {
  int first, end;

  [[nodiscard]] int size() const { return end - first; }
};

class Builder {
 public:
  explicit Builder(BoxedMesh& mesh) : mesh_(mesh), triangles_(mesh.triangles.size()) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      Numbered& triangle = triangles_[i];
      triangle.triangle = static_cast<int>(i);
      for (int corner = 0; corner < 3; ++corner) {
        const Point& p = mesh.corner(static_cast<int>(i), corner);
        const Axes at{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
        triangle.add(at, at);
      }
      for (std::size_t k = 0; k < 3; ++k) {  // rounded outward
        triangle.low[k] = std::nextafter(triangle.low[k], -infinite);
        triangle.high[k] = std::nextafter(triangle.high[k], infinite);
      }
    }
  }

  void build() {
    mesh_.leaves.reserve(triangles_.size() / 3);  // most leaves are full
    if (!triangles_.empty()) add_boxes(group_of(0, static_cast<int>(triangles_.size())), 0);
  }

 private:
  static constexpr int few = 4;                 // triangles of a leaf
  static constexpr int deepest = 16;            // then groups are halved: 7 more for 2^21 triangles
  static constexpr std::size_t most_bins = 16;  // where a group is cut: at most one a triangle

  Group group_of(int first, int end) const {
    Group group{{}, first, end};
    for (int i = first; i < end; ++i) group.add(triangles_[static_cast<std::size_t>(i)]);
    return group;
  }

  // Adds the eight boxes in a group, and those inside them.
  void add_boxes(const Group& all, int depth) {
    std::vector<Group> groups{all};
    while (groups.size() < 8) {
      // The one to be cut: the largest; far down, the one with the most triangles.
      const auto cost = [&](const Group& group) {
        if (group.size() <= few) return -1.0F;
        return depth < deepest ? group.half_surface() : static_cast<float>(group.size());
      };
      const auto largest =
          std::max_element(groups.begin(), groups.end(),
                           [&](const Group& a, const Group& b) { return cost(a) < cost(b); });
      if (cost(*largest) < 0) break;
      const Group cut = *largest;
      int middle = depth < deepest ? place_to_cut(cut) : (cut.first + cut.end) / 2;
      if (middle == cut.first) {  // all are at one place
        const int end = end_without_copies(cut);
        if (end < cut.end) {
          *largest = group_of(cut.first, end);
          continue;
        }
        middle = (cut.first + cut.end) / 2;
      }
      *largest = group_of(cut.first, middle);
      groups.push_back(group_of(middle, cut.end));
    }
    const std::size_t place = mesh_.boxes.size();
    mesh_.boxes.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) {
      const Group group = i < groups.size() ? groups[i] : Group{{}, 0, 0};
      InBox inside{};
      if (group.size() > few) {
        inside.place = static_cast<int>(mesh_.boxes.size());
        add_boxes(group, depth + 1);
      } else if (group.size() > 0) {
        inside = leaf_of(group);
      }
      float margin = i < groups.size() ? 0 : std::numeric_limits<float>::quiet_NaN();
      for (std::size_t k = 0; k < 3; ++k) {
        const float size = std::max(std::abs(group.low[k]), std::abs(group.high[k]));
        margin = std::max(margin, static_cast<float>(box_margin) * size);
      }
      MeshBoxes& boxes = mesh_.boxes[place];
      for (std::size_t k = 0; k < 3; ++k) {
        boxes.sides[8 * k + i] = group.low[k] - margin;
        boxes.sides[8 * k + 24 + i] = group.high[k] + margin;
      }
      boxes.inside[i] = inside;
    }
  }

  InBox leaf_of(const Group& group) {
    const int place = static_cast<int>(mesh_.leaves.size());
    MeshLeaf& leaf = mesh_.leaves.emplace_back();
    for (std::size_t i = 0; i < static_cast<std::size_t>(group.size()); ++i) {
      leaf.triangles[i] = triangles_[static_cast<std::size_t>(group.first) + i].triangle;
      for (int corner = 0; corner < 3; ++corner) {
        const Point& p = mesh_.corner(leaf.triangles[i], corner);
        std::array<float, 12>& at = leaf.corners[static_cast<std::size_t>(corner)];
        at[i] = static_cast<float>(p.x);
        at[4 + i] = static_cast<float>(p.y);
        at[8 + i] = static_cast<float>(p.z);
      }
    }
    return {place, group.size()};
  }

  // Keeps two of the triangles with the same corners in the same order, those with the smallest
  // numbers: a ray meets the first, and in a shadow of its own it meets the second. Gives the new
  // end.
  int end_without_copies(const Group& group) {
    const auto begin = triangles_.begin() + group.first;
    const auto end = triangles_.begin() + group.end;
    const auto corners = [&](const Numbered& each) {
      std::array<double, 9> all{};
      for (std::size_t k = 0; k < 9; k += 3) {
        const Point& p = mesh_.corner(each.triangle, static_cast<int>(k / 3));
        all[k] = p.x;
        all[k + 1] = p.y;
        all[k + 2] = p.z;
      }
      return all;
    };
    std::sort(begin, end, [&](const Numbered& a, const Numbered& b) {
      return std::pair(corners(a), a.triangle) < std::pair(corners(b), b.triangle);
    });
    auto kept = begin;
    for (auto each = begin; each != end; ++each) {
      if (kept - begin < 2 || corners(*(kept - 2)) != corners(*each)) *kept++ = *each;
    }
    return static_cast<int>(kept - triangles_.begin());
  }

  // Sorts the triangles of a group into two; gives the place where the second begins: that of the
  // group if all are at one place.
  int place_to_cut(const Group& group) {
    const auto bins = std::min(most_bins, static_cast<std::size_t>(group.size()));
    const auto begin = triangles_.begin() + group.first;
    const auto end = triangles_.begin() + group.end;
    Bounds middles;
    for (auto each = begin; each != end; ++each) {
      const Axes middle{each->middle(0), each->middle(1), each->middle(2)};
      middles.add(middle, middle);
    }
    Axes scale{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float extent = middles.high[axis] - middles.low[axis];
      if (extent > 0) {
        scale[axis] =
            std::min(static_cast<float>(bins) / extent, std::numeric_limits<float>::max());
      }
    }
    const auto bin_of = [&](const Bounds& each, std::size_t axis) {
      const float at = (each.middle(axis) - middles.low[axis]) * scale[axis];
      return at < static_cast<float>(bins - 1) ? static_cast<std::size_t>(at) : bins - 1;
    };
    std::array<std::array<Bounds, most_bins>, 3> in_bin;
    std::array<std::array<int, most_bins>, 3> count{};
    for (auto each = begin; each != end; ++each) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t bin = bin_of(*each, axis);
        in_bin[axis][bin].add(*each);
        ++count[axis][bin];
      }
    }
    float best_cost = HUGE_VALF;
    std::size_t best_axis = 0;
    std::size_t best_bin = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<float, most_bins> cost_above{};
      Bounds above;
      int triangles = 0;
      for (std::size_t bin = bins - 1; bin > 0; --bin) {
        above.add(in_bin[axis][bin]);
        triangles += count[axis][bin];
        cost_above[bin] = above.half_surface() * static_cast<float>(triangles);
      }
      Bounds below;
      triangles = 0;
      for (std::size_t bin = 1; bin < bins; ++bin) {
        below.add(in_bin[axis][bin - 1]);
        triangles += count[axis][bin - 1];
        const float cost = below.half_surface() * static_cast<float>(triangles) + cost_above[bin];
        if (triangles == 0 || triangles == group.size() || !(cost < best_cost)) continue;
        best_cost = cost;
        best_axis = axis;
        best_bin = bin;
      }
    }
    if (best_bin == 0) return group.first;  // all are at one place
    const auto middle = std::partition(
        begin, end, [&](const Bounds& each) { return bin_of(each, best_axis) < best_bin; });
    return static_cast<int>(middle - triangles_.begin());
  }

  BoxedMesh& mesh_;
  std::vector<Numbered> triangles_;
};

}  // namespace

BoxedMesh with_boxes(Mesh mesh) {
  BoxedMesh boxed{std::move(mesh), {}, {}};
  Builder(boxed).build();
  return boxed;
}

}  // namespace texmap
