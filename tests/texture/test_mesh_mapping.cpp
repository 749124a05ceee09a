// Tests of texture/mesh_mapping.hpp and texture/crate.hpp.
#include <doctest.h>

#include "support/mesh_rays.hpp"
#include "texture/crate.hpp"

namespace texmap::test {

TEST_CASE_TEMPLATE("at a corner (u, v) is exactly the corner's", Real, float, double, long double) {
  Dice dice;
  const TexturedMesh ring = torus(9, 5);
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    Point target;
    const Ray<Real> ray =
        aimed<Real>([&] { return point_within(dice, 4); },
                    [&] {
                      target = ring.mesh.points[static_cast<std::size_t>(dice.below(45))];
                      return target;
                    });
    const MeshHit<Real> hit = first_hit(ring.mesh, ray);
    if (!hit.met || !(hit.a == Real(1) || hit.b == Real(1) || hit.c == Real(1))) continue;
    ++checked;
    const Uv<Real> uv = ring.mapping(hit);
    const auto& corners = ring.mapping.corners[static_cast<std::size_t>(hit.triangle)];
    const std::size_t corner = hit.a == Real(1) ? 0 : hit.b == Real(1) ? 1 : 2;
    REQUIRE(uv.u == static_cast<Real>(corners[corner].u));
    REQUIRE(uv.v == static_cast<Real>(corners[corner].v));
  }
  CHECK(checked > 500);
}

TEST_CASE_TEMPLATE("with u = x and v = z in the corners, (u, v) is the hit point's x and z", Real,
                   float, double, long double) {
  Dice dice;
  for (int i = 0; i < 5000; ++i) {
    TexturedMesh one;
    for (int k = 0; k < 3; ++k) one.mesh.points.push_back(point_within(dice, 4));
    one.mesh.triangles.push_back({0, 1, 2});
    const auto& p = one.mesh.points;
    one.mapping.corners.push_back({{{p[0].x, p[0].z}, {p[1].x, p[1].z}, {p[2].x, p[2].z}}});
    const Ray<Real> ray = aimed<Real>([&] { return point_within(dice, 9); },
                                      [&] { return (p[0] + p[1] + p[2]) * (1.0 / 3); });
    const MeshHit<Real> hit = first_hit(one.mesh, ray);
    if (!hit.met) continue;
    const Uv<Real> uv = one.mapping(hit);
    REQUIRE(uv.u == hit.point.x);
    REQUIRE(uv.v == hit.point.z);
  }
}

TEST_CASE("each side of the crate shows the texture upright and not mirrored") {
  const TexturedMesh box = crate();
  const auto uv_at = [&](const Point& from, const Point& to) {
    return box.mapping(first_hit(box.mesh, Ray<double>{from, to - from}));
  };
  // From each side: a step to the right adds to u, a step up adds to v.
  for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
    const RotationY turn = rotation_y(degrees);
    const auto uv = [&](double x, double y) {
      return uv_at(turn(Point{x, y, 4}), turn(Point{x, y, 0}));
    };
    CHECK(uv(-0.5, -0.5).u == 0.25);
    CHECK(uv(0.5, -0.5).u == 0.75);
    CHECK(uv(0.5, 0.5).v == 0.75);
    CHECK(uv(0.5, -0.5).v == 0.25);
  }
  CHECK(uv_at({0.5, 4, 0.5}, {0.5, 0, 0.5}).u == 0.75);
  CHECK(uv_at({0.5, 4, 0.5}, {0.5, 0, 0.5}).v == 0.25);
  CHECK(MeshMapping{}(MeshHit<double>{}).u == 0);
}

}  // namespace texmap::test
