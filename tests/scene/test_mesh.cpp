// Tests of scene/mesh.hpp: no ray slips through, none is counted twice.
#include <doctest.h>

#include "number/kinds/pack2.hpp"
#include "support/mesh_rays.hpp"

namespace texmap::test {

TEST_CASE_TEMPLATE(
    "rays at edges and corners: none slips through, none is counted twice, in every number", Real,
    float, double, long double, Pack2<Pack<float>>, Pack2<Pack<double>>) {
  const Leaks leaks = count_leaks<Real>(100000, 1);
  CHECK(leaks.met > 30000);
  CHECK(leaks.cracks == 0);
  CHECK(leaks.doubles == 0);
  CHECK(leaks.unequal == 0);
}

TEST_CASE_TEMPLATE("the first hit is the nearest, its normal faces the ray, its weights sum to 1",
                   Real, float, double, long double) {
  Dice dice;
  const Mesh ring = torus(24, 12).mesh;
  const Real u = unit_roundoff<Real>();
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const Ray<Real> ray =
        aimed<Real>([&] { return point_within(dice, 3); }, [&] { return point_within(dice, 1); });
    Real nearest = infinity<Real>();
    bool from_outside = false;  // a closed mesh is entered from the front and left from the back
    for_each_crossing(ring, ray, nearest, [&](int, const Crossing<Real>& found) {
      if (!(found.distance > Real(0) && found.distance < nearest)) return;
      nearest = found.distance;
      from_outside = found.front;
    });
    const MeshHit<Real> hit = first_hit(ring, ray);
    REQUIRE(hit.met == (nearest < infinity<Real>()));
    if (!hit.met) continue;
    ++met;
    REQUIRE(hit.distance == nearest);
    if (length(ray.origin) > Real(2)) REQUIRE(from_outside);
    const Real slope = -dot(hit.normal, normalize(ray.direction));
    REQUIRE(slope >= Real(0));
    REQUIRE(std::min({hit.a, hit.b, hit.c}) >= Real(0));
    REQUIRE(abs(hit.a + hit.b + hit.c - Real(1)) <= Real(4) * u);
    // Away from the silhouette the two ways to the point agree.
    const Vec3<Real> along = ray.origin + ray.direction * hit.distance;
    REQUIRE(largest(hit.point - along) * slope < Real(400) * u);
  }
  CHECK(met > 1000);
}

TEST_CASE_TEMPLATE("a ray outward from `outside` does not meet its own plane again", Real, float,
                   double) {
  Dice dice;
  long from_outside = 0;
  long from_point = 0;
  for (int i = 0; i < 20000; ++i) {
    const Mesh cube = turned_cube(dice);
    const Ray<Real> ray =
        aimed<Real>([&] { return point_within(dice, 6); }, [&] { return point_within(dice, 1); });
    const MeshHit<Real> hit = first_hit(cube, ray);
    if (!hit.met) continue;
    Vec3<Real> direction = dice.direction<Real>();
    if (dot(direction, hit.normal) < Real(0)) direction = -direction;
    Mesh face = cube;
    const auto first = cube.triangles.begin() + static_cast<int>(hit.triangle) / 2 * 2;
    face.triangles = {first[0], first[1]};
    const auto meets_face = [&](const Vec3<Real>& origin) {
      return count_crossings(face, Ray<Real>{origin, direction}).ahead > Real(0) ? 1 : 0;
    };
    from_outside += meets_face(hit.outside);
    from_point += meets_face(hit.point);
  }
  CHECK(from_outside == 0);
  CHECK(from_point > 1000);
}

TEST_CASE_TEMPLATE("the slivers of a flat fan do not shadow each other, however thin", Real, float,
                   double) {
  Dice dice;
  int met = 0;
  for (const double width : {1e-2, 1e-4, 1e-6}) {
    for (int i = 0; i < 500; ++i) {
      const RotationY turn = rotation_y(dice.between(0, 360));
      const double first = dice.between(0, 6);
      const auto on_rim = [&](int k) {
        return turn(Point{std::cos(first + k * width), std::sin(first + k * width), 0});
      };
      Mesh fan;
      fan.points = {{0, 0, 0}, on_rim(0)};
      for (int k = 1; k <= 40; ++k) {
        fan.points.push_back(on_rim(k));
        fan.triangles.push_back({0, k, k + 1});
      }
      const Point aim = (on_rim(20) + on_rim(21)) * dice.between(0.05, 0.45);
      const Point eye = turn(Point{0, 0, 1} + point_within(dice, 0.9)) * 5.0;
      const MeshHit<Real> hit = first_hit(
          fan, Ray<Real>{number_cast<Real>(eye), number_cast<Real>(normalize(aim - eye))});
      if (!hit.met) continue;  // a rounded ray may miss so narrow a fan
      ++met;
      const Ray<Real> to_light{hit.outside,
                               number_cast<Real>(turn(Point{dice.between(-2, 2), 1, 1}))};
      REQUIRE_FALSE(is_occluded(others(fan, hit), to_light, Real(10)));
    }
  }
  CHECK(met > 1400);
}

TEST_CASE_TEMPLATE("needles of any width have a normal, also where rounding loses their area", Real,
                   float, double, long double) {
  Dice dice;
  int met = 0, lost = 0;
  for (int i = 0; i < 20000; ++i) {
    // Corners on a line through the origin, rounded to Real: only rounding gives them an area.
    const Vec3d along = dice.direction<double>();
    Mesh needle;
    needle.triangles = {{0, 1, 2}};
    for (const double t : {1.0, 2.0, dice.between(1.1, 1.9)})
      needle.points.push_back(
          number_cast<double>(number_cast<long double>(number_cast<Real>(along * t))));
    const auto& p = needle.points;
    const MeshHit<Real> hit =
        first_hit(needle, aimed<Real>([&] { return point_within(dice, 0.5); },
                                      [&] { return (p[0] + p[1] + p[2]) * (1.0 / 3); }));
    if (!hit.met) continue;
    ++met;
    const auto [a, b, c] = corners_of(needle, Real(0));
    lost += largest(cross(b - a, c - a)) > Real(0) ? 0 : 1;
    REQUIRE(abs(length(hit.normal) - Real(1)) < Real(8) * unit_roundoff<Real>());
  }
  CHECK(met > 100);
  if (!std::is_same_v<Real, long double>) CHECK(lost > 100);
}

TEST_CASE("the other triangles of a mesh cast shadows, its own does not") {
  const Mesh cube = crate().mesh;
  const MeshHit<double> on_top = first_hit(cube, Ray<double>{{0.5, 4, 0.25}, {0, -1, 0}});
  REQUIRE(on_top.met);
  const auto hidden = [&](const Vec3d& direction, double distance) {
    return is_occluded(others(cube, on_top), Ray<double>{on_top.point, direction}, distance);
  };
  CHECK_FALSE(hidden({0, 1, 0}, 10.0));
  CHECK(hidden({0, -1, 0}, 10.0));  // the bottom
  CHECK_FALSE(hidden({0, -1, 0}, 1.5));
  const Ray<double> down{on_top.point + Point{0, 1, 0}, {0, -1, 0}};
  CHECK_FALSE(is_occluded(others(cube, on_top), down, 1.5));  // its own is in between
  CHECK_FALSE(first_hit(Mesh{}, Ray<double>{{0, 0, 0}, {0, 0, -1}}).met);
}

}  // namespace texmap::test
