// Tests of engine/fast/box_tree.hpp: a tree changes no hit.
#include <doctest.h>

#include <cmath>

#include "engine/fast/box_search.hpp"
#include "number/kinds/interval.hpp"
#include "number/kinds/pack2.hpp"
#include "support/lanes.hpp"
#include "support/mesh_rays.hpp"

namespace texmap::test {
namespace {

/// Rays that meet other things with the tree than without, to the last bit.
template <class Real>
long count_lost(const Mesh& list, const BoxedMesh& tree, long rays, double reach) {
  Dice dice;
  long different = 0;
  for (long i = 0; i < rays; ++i) {
    // From whole points, some rays run along an axis or in the plane of a face.
    const bool whole = dice.once_in(4);
    const auto from = [&] {
      return whole ? whole_point_within(dice, 3) : point_within(dice, reach);
    };
    const Ray<Real> ray = aimed<Real>(from, [&] { return point_on_edge(dice, list); });
    const MeshHit<Real> a = first_hit(list, ray);
    const MeshHit<Real> b = first_hit(tree, ray);
    const Ray<Real> onward{a.outside, dice.direction<Real>()};
    const Real far = Real(dice.between(0, 2) * reach);
    const bool same =
        a.met == b.met &&
        (!a.met ||
         (a.triangle == b.triangle && a.a == b.a && a.b == b.b && a.distance == b.distance)) &&
        is_occluded(others(list, a), onward, far) == is_occluded(others(tree, b), onward, far);
    different += same ? 0 : 1;
  }
  return different;
}

TEST_CASE_TEMPLATE("the tree meets what the list meets, to the last bit", Real, float, double,
                   long double) {
  const Mesh ring = torus(20, 12).mesh;
  CHECK(count_lost<Real>(ring, with_boxes(ring), 4000, 3) == 0);
  // Far from the origin, where rounding moves every point.
  Mesh far = ring;
  for (Point& p : far.points) p = p + Point{1000, -3000, 500};
  CHECK(count_lost<Real>(far, with_boxes(far), 4000, 4000) == 0);
  // Small and large: the boxes' margins follow.
  for (const double scale : {1e-6, 1e5}) {
    Mesh scaled = ring;
    for (Point& p : scaled.points) p = p * scale;
    CHECK(count_lost<Real>(scaled, with_boxes(scaled), 4000, 3 * scale) == 0);
  }
  // In planes along the axes the boxes are flat.
  const Mesh cube = crate().mesh;
  CHECK(count_lost<Real>(cube, with_boxes(cube), 4000, 3) == 0);
  // Without boxes: a mesh of few points, and one of many.
  CHECK(count_lost<Real>(cube, BoxedMesh{cube, {}, {}}, 4000, 3) == 0);
  CHECK(count_lost<Real>(ring, BoxedMesh{ring, {}, {}}, 400, 3) == 0);
}

TEST_CASE_TEMPLATE("a million triangles: no ray slips through, none is counted twice", Real, float,
                   double, Pack2<Pack<float>>) {
  static const BoxedMesh ball = with_boxes(globe(1000, 500));
  REQUIRE(ball.triangles.size() == 998'000);
  Dice dice;
  long wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray<Real> ray = aimed<Real>([&] { return point_within(dice, 0.4); },
                                      [&] { return point_on_edge(dice, ball); });
    const CrossingCount<Real> count = count_crossings(ball, ray);
    for (std::size_t k = 0; k < lanes<Real>; ++k) wrong += lane(count.ahead, k) == 1 ? 0 : 1;
  }
  CHECK(wrong == 0);
  const std::size_t bytes =
      ball.boxes.size() * sizeof(MeshBoxes) + ball.leaves.size() * sizeof(MeshLeaf) +
      ball.points.size() * sizeof(Point) + ball.triangles.size() * sizeof(ball.triangles[0]);
  CHECK(bytes < 100 * ball.triangles.size());  // as with_boxes states
}

TEST_CASE("triangles that grow by powers of two nest no deeper than rays can follow") {
  Mesh nested;
  for (int i = 0; i < 1000; ++i) {
    const double size = std::ldexp(1.0, i / 8 - 60);
    const int first = static_cast<int>(nested.points.size());
    nested.points.insert(nested.points.end(), {{size, 0, 0}, {0, size, 0}, {0, 0, size}});
    nested.triangles.push_back({first, first + 1, first + 2});
  }
  const BoxedMesh tree = with_boxes(nested);
  CHECK(count_lost<double>(nested, tree, 1000, 2) == 0);
}

TEST_CASE("triangles at one place, flat ones and none at all have a tree, too") {
  Mesh same;
  same.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  same.triangles.assign(1000, {0, 1, 2});
  const BoxedMesh tree = with_boxes(same);
  const MeshHit<double> hit = first_hit(tree, Ray<double>{{0.25, 0.25, 1}, {0, 0, -1}});
  CHECK(hit.met);
  CHECK(hit.triangle == 0);  // of several at one distance, the first
  CHECK(tree.leaves.size() ==
        1);  // or a face that is there 20,000 times takes 20,000 times as long
  Mesh point;
  point.points = {{1, 2, 3}};
  point.triangles.assign(100, {0, 0, 0});
  CHECK_FALSE(first_hit(with_boxes(point), Ray<double>{{0, 0, 0}, {1, 2, 3}}).met);
  CHECK(with_boxes(Mesh{}).boxes.empty());
}

TEST_CASE_TEMPLATE("each lane meets in the tree what a plain ray meets", Many, Pack<float>,
                   Pack2<Pack<double>>) {
  Dice dice;
  const BoxedMesh tree = with_boxes(torus(20, 12).mesh);
  for (int i = 0; i < 500; ++i) {
    const Ray<Many> ray = aimed<Many>([&] { return point_within(dice, 3); },
                                      [&] { return point_on_edge(dice, tree); });
    check_each_lane<Many>(
        [&](const auto& in) {
          using Real = std::remove_cvref_t<decltype(in.origin.x)>;
          const MeshHit<Real> hit = first_hit(tree, in);
          return std::tuple{select(hit.met, hit.distance, Real(-1)), hit.triangle};
        },
        ray);
  }
}

TEST_CASE(
    "intervals that may hit hold what a plain ray meets, and boxes that are none stay empty") {
  Dice dice;
  const BoxedMesh tree = with_boxes(torus(20, 12).mesh);
  for (int i = 0; i < 200; ++i) {
    const auto ray = aimed<double>([&] { return point_within(dice, 3); },
                                   [&] { return point_on_edge(dice, tree); });
    const MeshHit<double> plain = first_hit(tree, ray);
    const auto hit = first_hit(tree, Ray<Interval>{number_cast<Interval>(ray.origin),
                                                   number_cast<Interval>(ray.direction)});
    if (plain.met) CHECK(hit.triangle.contains(plain.triangle));
  }
}

}  // namespace
}  // namespace texmap::test
