// Tests of common/texture/projections.hpp, cube_map.hpp and octahedral_map.hpp; and of
// projection_facts.hpp, whose figures chapter 10's test holds against closed forms, too.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/dice.hpp"
#include "support/shown_values.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::test {
namespace {

bool upper_half_alone(Projection projection) { return projection == Projection::plane; }

/// The farther of u and v, in texels of 4096.
template <class Real>
double texels(const Uv<Real>& a, const Uv<Real>& b) {
  return static_cast<double>(std::max(abs(a.u - b.u), abs(a.v - b.v))) * 4096;
}

/// The texel that lies across an edge of an octahedral map: its direction is that of the edge's own
/// texel, mirrored at the plane of the meridian that the edge is.
Uv<double> mirrored_place(Projection projection, const Uv<double>& inside, bool at_side) {
  Vec3<double> p = unproject(projection, inside);
  (at_side ? p.z : p.x) *= -1;
  return project(projection, p);
}

struct Named {
  Vec3<double> p;
  double u, v;
};

TEST_CASE("the six axes have exact places in every layout") {
  const auto check = [](Projection projection, const std::vector<Named>& rows) {
    for (const Named& row : rows) {
      CAPTURE(row.p);
      const Uv<double> uv = project(projection, row.p);
      CHECK(uv.u == row.u);
      CHECK(uv.v == doctest::Approx(row.v).epsilon(1e-15));
    }
  };
  const Vec3<double> right{1, 0, 0}, left{-1, 0, 0}, top{0, 1, 0}, bottom{0, -1, 0};
  const Vec3<double> front{0, 0, 1}, back{0, 0, -1};
  const double last = below_one<double>();
  for (const Projection round : {Projection::equirect, Projection::cylinder}) {
    check(round, {{left, 0, .5},
                  {front, .25, .5},
                  {right, .5, .5},
                  {back, .75, .5},
                  {top, .5, 1},
                  {bottom, .5, 0}});
  }
  check(Projection::plane,
        {{left, 0, .5}, {front, .5, 0}, {right, last, .5}, {back, .5, 1}, {top, .5, .5}});
  for (const Projection cube : {Projection::cube, Projection::equi_angular}) {
    check(cube, {{left, 0.5 / 3, .75},
                 {front, .5, .75},
                 {right, 2.5 / 3, .75},
                 {bottom, 0.5 / 3, .25},
                 {back, .5, .25},
                 {top, 2.5 / 3, .25}});
  }
  for (const Projection octahedral : {Projection::octahedral, Projection::equal_area}) {
    check(octahedral,
          {{left, 0, .5}, {front, .5, 0}, {right, last, .5}, {back, .5, 1}, {top, .5, .5}});
    const Uv<double> uv = project(octahedral, bottom);  // a corner, any of the four
    CHECK((uv.u == 0 || uv.u == last));
    CHECK((uv.v == 0 || uv.v == 1));
  }
}

TEST_CASE_TEMPLATE("inverse, then forward: the same place, on 401 x 401 places with all edges",
                   Real, float, double, long double) {
  const double bound = std::is_same_v<Real, float> ? 0.001 : 4096e-12;
  constexpr int n = 400;
  for (const ProjectionFacts& facts : projections) {
    double worst = 0;
    double worst_on_edges = 0;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        const Uv<Real> uv{min(Real(i) / Real(n), below_one<Real>()), Real(j) / Real(n)};
        const bool outside = square(uv.u - Real(0.5)) + square(uv.v - Real(0.5)) > Real(0.25);
        if (upper_half_alone(facts.projection) && outside) continue;
        const Vec3<Real> p = unproject(facts.projection, uv);
        const Uv<Real> again = project(facts.projection, p);
        // On a seam two places are one direction, and a pole has a whole row.
        const bool on_edge = i == 0 || i == n || j == 0 || j == n || 2 * j == n;
        if (on_edge) {
          const Vec3<Real> q = unproject(facts.projection, again);
          worst_on_edges = std::max(worst_on_edges, static_cast<double>(length(q - p)));
        } else {
          worst = std::max(worst, texels(uv, again));
        }
      }
    }
    CAPTURE(std::string(facts.word));
    CHECK(worst <= bound);
    CHECK(worst_on_edges <= 16 * static_cast<double>(std::numeric_limits<Real>::epsilon()));
  }
}

TEST_CASE("the plane shows a disk: what project and unproject lead back to, and a margin") {
  for (int i = 0; i < 80 * 80; ++i) {
    const Uv<double> uv{(i % 80 + 0.5) / 80, (i / 80 + 0.5) / 80};
    const double beyond = std::hypot(uv.u - 0.5, uv.v - 0.5) - 0.5;
    REQUIRE(shows(Projection::plane, uv) == (beyond < 0));
    REQUIRE(shows(Projection::plane, uv, 0.05) == (beyond < 0.05));
  }
}

TEST_CASE("a texel of the plane covers 1 / (2 y) of a mean texel's solid angle") {
  for (const double y : {0.1, 0.6, 1.0}) {
    const Vec3<double> n{std::sqrt(1 - y * y), y, 0};
    CHECK(distortion(Projection::plane, n).area == doctest::Approx(1 / (2 * y)).epsilon(1e-14));
  }
}

TEST_CASE("a zero with a minus sign is a zero") {
  CHECK((with_sign_of(0.0, 2.0) == 2 && with_sign_of(-0.0, 2.0) == 2));
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    for (const Vec3<double>& p : {Vec3<double>{-1, 0.5, 0}, Vec3<double>{0, 0.5, -1},
                                  Vec3<double>{1, 0, 0}, Vec3<double>{0, 1, 0}}) {
      const auto minus = [](double x) { return x == 0 ? -0.0 : x; };
      const Uv<double> one = project(facts.projection, p);
      const Uv<double> two =
          project(facts.projection, Vec3<double>{minus(p.x), minus(p.y), minus(p.z)});
      CHECK(one.u == two.u);
      CHECK(one.v == two.v);
    }
  }
}

TEST_CASE("every picture reads as printed from outside: no layout is mirrored") {
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    Dice dice(7);
    for (int i = 0; i < 20000; ++i) {
      const auto n = dice.direction<double>();
      if (upper_half_alone(facts.projection) && n.y < 0.01) continue;
      const Vec3<double> east = normalize(cross(Vec3<double>{0, 1, 0}, n));
      const Vec3<double> north = cross(n, east);
      const Uv<Dual<double>> uv =
          project(facts.projection,
                  Vec3<Dual<double>>{
                      {n.x, east.x, north.x}, {n.y, east.y, north.y}, {n.z, east.z, north.z}});
      REQUIRE(uv.u.dx * uv.v.dy - uv.u.dy * uv.v.dx > 0);
    }
  }
}

TEST_CASE("beyond each of the four edges an octahedral map goes on at the mirrored texel") {
  for (const Projection projection : {Projection::octahedral, Projection::equal_area}) {
    for (int n = 1; n <= 16; ++n) {
      for (int i = 0; i < n; ++i) {
        for (const auto& [column, row] : {std::pair(-1, i), {n, i}, {i, -1}, {i, n}}) {
          const int inner_column = std::clamp(column, 0, n - 1);
          const int inner_row = std::clamp(row, 0, n - 1);
          const Uv<double> place =
              mirrored_place(projection, {(inner_column + 0.5) / n, 1 - (inner_row + 0.5) / n},
                             inner_column != column);
          const auto texel = folded_octahedral<double>(column, row, n, n);
          REQUIRE(texel.column == std::floor(place.u * n));
          REQUIRE(texel.row == n - 1 - std::floor(place.v * n));
        }
      }
    }
  }
  // All four corners are the south pole.
  const auto corner = folded_octahedral<double>(-1, -1, 8, 8);
  CHECK(corner.column == 7);
  CHECK(corner.row == 7);
}

TEST_CASE_TEMPLATE("u is below 1 and v from 0 to 1 for every vector, beyond the domain too", Real,
                   float, double, long double) {
  Dice dice(3);
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    for (int i = 0; i < 5000; ++i) {
      const Vec3<Real> p{dice.anything<Real>(), dice.anything<Real>(), dice.anything<Real>()};
      const Uv<Real> uv = project(facts.projection, p);
      CAPTURE(p);
      REQUIRE((uv.u >= Real(0) && uv.u < Real(1) && uv.v >= Real(0) && uv.v <= Real(1)));
    }
  }
}

}  // namespace
}  // namespace texmap::test
