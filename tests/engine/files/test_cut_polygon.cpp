// Tests of engine/files/cut_polygon.hpp: triangles cover a polygon and nothing else.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/files/cut_polygon.hpp"
#include "support/mesh_rays.hpp"

namespace texmap::test {
namespace {

using Polygon = std::vector<Point>;

/// How often triangles cover a point, less how often from behind.
CrossingCount<double> covers_of(const Polygon& polygon, const Cuts& cuts, const Point& point) {
  Mesh mesh{polygon, {}};
  for (const auto& [a, b, c] : cuts)
    mesh.triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  return count_crossings(mesh, Ray<double>{{point.x, point.y, 9}, {0, 0, -1}});
}

/// Points where the triangles and the polygon differ, of 1000 for each of six planes; -1 if it
/// crosses itself. A fan covers each point as often as the edges go around it.
int points_wrong(Polygon polygon, Dice& dice, std::size_t looks = most_polygon_looks) {
  int wrong = 0;
  Cuts cuts, fan;
  for (std::size_t i = 2; i < polygon.size(); ++i) fan.push_back({0, i - 1, i});
  for (const int plane : {0, 1, 2, 3, 4, 5}) {
    if (plane == 3) std::reverse(polygon.begin(), polygon.end());
    Polygon given = polygon;  // not quite flat, along each axis, from both sides
    for (Point& p : given) {
      const double z = 0.3 * p.x - 0.2 * p.y + 1e-3 * std::sin(9 * p.x);
      const Point places[] = {{p.x, p.y, z}, {z, p.x, p.y}, {p.y, z, p.x}};
      p = places[plane % 3];
    }
    if (!cut_polygon(given, cuts, looks)) return -1;
    for (int i = 0; i < 1000; ++i) {
      const Point at = point_within(dice, 2);
      const auto seen = covers_of(polygon, cuts, at), around = covers_of(polygon, fan, at);
      const bool is_right =
          seen.front - seen.back == around.front - around.back && seen.front + seen.back <= 1;
      wrong += is_right ? 0 : 1;
    }
  }
  return wrong;
}

/// A polygon from pairs of x and y.
Polygon polygon_of(const std::vector<double>& xy) {
  Polygon polygon;
  for (std::size_t i = 0; i < xy.size(); i += 2) polygon.push_back({xy[i], xy[i + 1], 0});
  return polygon;
}

/// A polygon whose corners are at random distances around (0, 0).
Polygon star(Dice& dice, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const OnCircle<double> at = on_circle_of_degrees(360.0 * i / corners);
    const double r = dice.between(0.2, 1.9);
    polygon.push_back({r * at.cosine, r * at.sine, 0});
  }
  return polygon;
}

TEST_CASE("triangles cover a polygon of any shape and nothing else") {
  Dice dice;
  for (const std::vector<double>& xy : std::vector<std::vector<double>>{
           {1, 0, 1, 0.5, 0.5, 0.5, 0.5, 1, 0, 1, 0, 0},                              // L
           {0, 0, 2, 0, 2, 2, 1.5, 2, 1.5, 0.5, 0.5, 0.5, 0.5, 2, 0, 2},              // U
           {0, 0, 1, 1, 2, 0, 1, 2},                                                  // an arrow
           {0, 0, 0.1, 0.1, 0.3, 0.3, 0.3, 0.3, 0, 1},                                // twice there
           {-2, -2, 2, -2, 2, 2, -2, 2, -2, -2, -1, -1, -1, 1, 1, 1, 1, -1, -1, -1},  // a hole
           {0, 0, 2, 0, 1, 0, 1, 1, 0, 1}})                                           // a spike
    CHECK(points_wrong(polygon_of(xy), dice) == 0);
  for (const int corners : {4, 5, 7, 12, 30, 200}) {
    for (int i = 0; i < 10; ++i) CHECK(points_wrong(star(dice, corners), dice) == 0);
  }
}

TEST_CASE("a convex polygon is a fan; so is one that crosses itself or is too large, but told") {
  Cuts cuts;
  std::size_t looks = 0;
  Polygon convex = polygon_of({0, 0, 2, 0, 3, 1, 2, 2, 0, 2});
  CHECK(cut_polygon(convex, cuts, looks));
  CHECK(cuts == Cuts{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  Dice dice;
  CHECK(points_wrong(star(dice, 100), dice, 1000) == -1);
  for (const std::vector<double>& xy : std::vector<std::vector<double>>{
           {0, 0, 1, 1, 1, 0, 0, 1},                               // an 8
           {0, 0, 6, 0, 1, 4, 3, -3, 5, 4},                        // a pentagram
           {0, 0, 1, 0, 0, 1, -1, 0, 0, -1, 2, 0, 0, 2, -2, 0.1},  // twice around its first corner
           {0, 0, 4, 0, 4, 4, 3, 4, 3, -1, 2, -1, 2, 4, 0, 4}}) {  // a bay through the far side
    Polygon crossed = polygon_of(xy);
    CHECK(points_wrong(crossed, dice) == -1);
    looks = most_polygon_looks;
    CHECK_FALSE(cut_polygon(crossed, cuts, looks));
    CHECK(cuts.front() == std::array<std::size_t, 3>{0, 1, 2});
  }
}

TEST_CASE("a polygon without an area has as many triangles as another, and its looks are counted") {
  Cuts cuts;
  std::size_t looks = 100;
  Polygon point = polygon_of({1, 1, 1, 1, 1, 1, 1, 1});
  CHECK(cut_polygon(point, cuts, looks));
  CHECK(cuts.size() == 2);
  std::vector<double> back_and_forth = {0, 0};
  for (int i = 0; i < 40; ++i) back_and_forth.insert(back_and_forth.end(), {i % 2 * 1.0, 0});
  Polygon line = polygon_of(back_and_forth);
  CHECK_FALSE(cut_polygon(line, cuts, looks));
  CHECK(looks == 0);
  CHECK(cuts.size() == 39);
}

}  // namespace
}  // namespace texmap::test
