// Polygons of a mesh, cut into triangles.
#include "engine/files/cut_polygon.hpp"

#include <algorithm>
#include <cmath>

#include "scene/edge_function.hpp"

namespace texmap {
namespace {

double size_of(const Vec3d& v) { return std::max(std::abs(v.x), std::abs(v.y)); }

// Twice the area of a triangle in a plane, by chapter 08's edge function; above 0 if p, a, b run
// counterclockwise, and 0 if they are in a line but for rounding.
double turn(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d to_a = a - p, to_b = b - p;
  const double area = side_of_edge(to_a, to_b).area;
  return std::abs(area) > 0x1p-40 * size_of(to_a) * size_of(to_b) ? area : 0;
}

bool apart(double one, double other) { return one < 0 ? other > 0 : one > 0 && other < 0; }

bool same(const Vec3d& a, const Vec3d& b) { return a.x == b.x && a.y == b.y; }

// True if the line from a to b crosses that from c to d, and does not only touch it.
bool cross_each_other(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  return apart(turn(a, b, c), turn(a, b, d)) && apart(turn(c, d, a), turn(c, d, b));
}

// Turns corners into their places in a plane, counterclockwise.
void flatten(std::vector<Point>& corners) {
  Vec3d normal{}, sizes{};
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vec3d part = cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    normal = normal + part;
    sizes = sizes + Vec3d{std::abs(part.x), std::abs(part.y), std::abs(part.z)};
  }
  const bool cancels = !(largest(normal) > 0x1p-40 * largest(sizes));   // as in the figure 8
  const RaySpace<double> space({{0, 0, 0}, cancels ? sizes : normal});  // along the longest axis
  for (Point& corner : corners) {
    const Vec3d p = space.renamed(corner);
    corner = space.direction.z > 0 ? Point{p.x, p.y, 0} : Point{p.y, p.x, 0};
  }
}

// A fan from the first corner covers the polygon if it turns one way alone, by at most half a turn.
bool fan_covers(const std::vector<Point>& at) {
  for (std::size_t i = 2; i < at.size(); ++i) {
    if (turn(at[0], at[i - 1], at[i]) < 0 || turn(at[0], at[1], at[i]) < 0) return false;
  }
  return !same(at[0], at[1]);
}

class Clipper {
 public:
  Clipper(const std::vector<Point>& places, std::size_t& looks) : at_(places), looks_(looks) {
    for (std::size_t i = 0; i < at_.size(); ++i) {
      if (!same(at_[i], at_[(i + 1) % at_.size()])) left_.push_back(i);
    }
  }

  // True if the triangles in `cuts` cover the polygon.
  bool clip(Cuts& cuts) {
    for (std::size_t i = 0, tried = 0; left_.size() > 2; i %= left_.size()) {
      if (looks_ == 0 || --looks_ == 0) return false;
      const auto [before, after] = neighbors(i);
      const double area = turn(place(before), place(i), place(after));
      const bool is_straight = area == 0 && tried >= left_.size();  // the last to be tried
      if (area > 0 && is_alone(before, i, after)) {
        cuts.push_back({left_[before], left_[i], left_[after]});
      } else if (!is_straight) {
        if (++tried == 2 * left_.size()) return false;
        ++i;
        continue;
      }
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
      tried = 0;
    }
    return true;
  }

 private:
  [[nodiscard]] std::array<std::size_t, 2> neighbors(std::size_t i) const {
    return {(i + left_.size() - 1) % left_.size(), (i + 1) % left_.size()};
  }
  [[nodiscard]] const Point& place(std::size_t i) const { return at_[left_[i]]; }

  // True if nothing else of the polygon is in the triangle of three corners, and no edge crosses
  // its sides; so edges that cross each other are found when the first of them is cut off.
  bool is_alone(std::size_t before, std::size_t at, std::size_t after) {
    const Point &a = place(before), &b = place(at), &c = place(after);
    for (std::size_t k = 0; k < left_.size(); ++k) {
      if (looks_ == 0 || --looks_ == 0) return false;
      const Point &p = place(k), &next = place(neighbors(k)[1]);
      const bool is_corner = same(p, a) || same(p, b) || same(p, c);
      if (!is_corner && turn(c, a, p) >= 0 && turn(a, b, p) >= 0 && turn(b, c, p) >= 0)
        return false;
      if (cross_each_other(c, a, p, next) || cross_each_other(a, b, p, next) ||
          cross_each_other(b, c, p, next))
        return false;
    }
    return true;
  }

  const std::vector<Point>& at_;
  std::vector<std::size_t> left_;  // the corners that are not cut off, in their order
  std::size_t& looks_;
};

}  // namespace

bool cut_polygon(std::vector<Point>& corners, Cuts& cuts, std::size_t& looks) {
  cuts.clear();
  flatten(corners);
  const bool is_fan = fan_covers(corners);
  const bool covered = is_fan || Clipper(corners, looks).clip(cuts);
  if (covered && !cuts.empty()) return true;
  cuts.clear();  // a fan, also of a polygon without an area
  for (std::size_t i = 2; i < corners.size(); ++i) cuts.push_back({0, i - 1, i});
  return covered;
}

}  // namespace texmap
