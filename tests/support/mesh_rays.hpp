// Rays that are aimed at the edges and corners of meshes, and what they cross.
#pragma once
#include "math/rotation.hpp"
#include "scene/mesh.hpp"
#include "support/dice.hpp"
#include "texture/crate.hpp"

namespace texmap::test {

/// How many triangles of a mesh the line of a ray crosses, in each lane.
template <class Real>
struct CrossingCount {
  Real front = Real(0);  ///< from the side where corners run counterclockwise
  Real back = Real(0);
  Real ahead = Real(0);  ///< of both, those ahead of the ray's origin
};

template <class AnyMesh, class Real>
[[nodiscard]] CrossingCount<Real> count_crossings(const AnyMesh& mesh, const Ray<Real>& ray) {
  CrossingCount<Real> count;
  for_each_crossing(mesh, ray, infinity<Real>(), [&](int, const Crossing<Real>& found) {
    const auto one_where = [](const Mask<Real>& mask) { return select(mask, Real(1), Real(0)); };
    count.front = count.front + one_where(found.met && found.front);
    count.back = count.back + one_where(found.met && !found.front);
    count.ahead = count.ahead + one_where(found.met && found.distance > Real(0));
  });
  return count;
}

/// The cube of twelve triangles, turned any way.
[[nodiscard]] inline Mesh turned_cube(Dice& dice) {
  Mesh mesh = crate().mesh;
  const RotationY first = rotation_y(dice.between(0, 360));
  const RotationY second = rotation_y(dice.between(0, 360));
  for (Point& p : mesh.points) {
    p = first(p);
    p = second(Point{p.y, p.z, p.x});
  }
  return mesh;
}

/// A closed mesh with a hole through it, bent and not convex: columns x rows squares.
[[nodiscard]] inline TexturedMesh torus(int columns, int rows) {
  TexturedMesh torus;
  const auto index = [rows](int i, int k) { return i * rows + k; };
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const OnCircle<double> along = on_circle_of_degrees(360.0 * i / columns);
      const OnCircle<double> round = on_circle_of_degrees(360.0 * k / rows);
      const double bump = 1 + 0.2 * on_circle_of_degrees(360.0 * 7 * i / columns).sine;
      const double radius = 1 + 0.4 * round.cosine * bump;
      torus.mesh.points.push_back(
          {radius * along.cosine, 0.6 * round.sine * bump, -radius * along.sine});
    }
  }
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const int i_next = (i + 1) % columns;
      const int k_next = (k + 1) % rows;
      const auto uv = [&](int di, int dk) {
        return Uv<double>{8.0 * (i + di) / columns, 3.0 * (k + dk) / rows};
      };
      add_rectangle(torus, {index(i, k), index(i_next, k), index(i_next, k_next), index(i, k_next)},
                    {uv(0, 0), uv(1, 0), uv(1, 1), uv(0, 1)});
    }
  }
  return torus;
}

/// A closed mesh in which rays from near its middle meet one triangle: a ball of rows of squares.
[[nodiscard]] inline Mesh globe(int columns, int rows) {
  Mesh globe;
  globe.points = {{0, 1, 0}, {0, -1, 0}};
  const auto index = [&](int column, int row) {
    if (row == 0 || row == rows) return row == 0 ? 0 : 1;
    return 2 + (row - 1) * columns + column % columns;
  };
  for (int row = 1; row < rows; ++row) {
    const OnCircle<double> down = on_circle_of_degrees(180.0 * row / rows);
    for (int column = 0; column < columns; ++column) {
      const OnCircle<double> along = on_circle_of_degrees(360.0 * column / columns);
      globe.points.push_back({down.sine * along.cosine, down.cosine, -down.sine * along.sine});
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = index(column, row);
      const int b = index(column, row + 1);
      const int c = index(column + 1, row + 1);
      const int d = index(column + 1, row);
      if (row + 1 < rows) globe.triangles.push_back({a, b, c});
      if (row > 0) globe.triangles.push_back({a, c, d});
    }
  }
  return globe;
}

/// A point of a mesh where triangles meet: a corner, the middle of an edge, or elsewhere on one.
[[nodiscard]] inline Point point_on_edge(Dice& dice, const Mesh& mesh) {
  const int triangle = dice.below(static_cast<int>(mesh.triangles.size()));
  const int corner = dice.below(3);
  const Point& a = mesh.corner(triangle, corner);
  const Point& b = mesh.corner(triangle, (corner + 1) % 3);
  const int kind = dice.below(4);
  if (kind < 2) return kind == 0 ? a : (a + b) * 0.5;
  return a + (b - a) * dice.between(0, 1);
}

/// A ray, in each lane another, from `origin()` to `target()`, with the direction as rounded.
template <class Real, class Origin, class Target>
[[nodiscard]] Ray<Real> aimed(const Origin& origin, const Target& target) {
  std::array<Point, lanes<Real>> from, to;
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    from[i] = origin();
    to[i] = target();
  }
  const auto packed = [](const std::array<Point, lanes<Real>>& points) {
    const auto coordinate = [&](double Point::*which) {
      return from_lanes<Real>(
          [&](std::size_t i) { return static_cast<Scalar<Real>>(points[i].*which); });
    };
    return Vec3<Real>{coordinate(&Point::x), coordinate(&Point::y), coordinate(&Point::z)};
  };
  const Vec3<Real> start = packed(from);
  return {start, packed(to) - start};
}

/// What went wrong with rays at edges and corners.
struct Leaks {
  long rays = 0;
  long cracks = 0;   ///< from inside a convex mesh: nothing ahead
  long doubles = 0;  ///< the same: more than one triangle ahead
  long unequal = 0;  ///< lines with another number of triangles from the front than from the back
  long met = 0;      ///< lines that cross the mesh
};

/// Aims `rays` rays at the edges and corners of cubes from inside, and at closed meshes from
/// anywhere.
template <class Real>
[[nodiscard]] Leaks count_leaks(long rays, std::uint64_t seed) {
  Dice dice(seed);
  Leaks leaks;
  const Mesh upright = crate().mesh;
  const Mesh ring = torus(6, 4).mesh;
  Mesh cube = upright;
  while (leaks.rays < rays) {
    if (leaks.rays % 1024 == 0) cube = turned_cube(dice);
    const bool any_cube = dice.once_in(2);
    const Mesh& convex = any_cube ? cube : upright;
    const Mesh& closed = dice.once_in(4) ? ring : convex;
    const bool whole = dice.once_in(4);
    const Ray<Real> inside = aimed<Real>([&] { return whole ? Point{} : point_within(dice, 0.5); },
                                         [&] { return point_on_edge(dice, convex); });
    const Ray<Real> outside =
        aimed<Real>([&] { return whole ? whole_point_within(dice, 4) : point_within(dice, 4); },
                    [&] { return point_on_edge(dice, closed); });
    const CrossingCount<Real> from_inside = count_crossings(convex, inside);
    const CrossingCount<Real> from_anywhere = count_crossings(closed, outside);
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      const auto ahead = lane(from_inside.ahead, i);
      if (ahead < 1) ++leaks.cracks;
      if (ahead > 1) ++leaks.doubles;
      if (lane(from_anywhere.front, i) != lane(from_anywhere.back, i)) ++leaks.unequal;
      if (lane(from_anywhere.front, i) > 0) ++leaks.met;
    }
    leaks.rays += 2 * static_cast<long>(lanes<Real>);
  }
  return leaks;
}

}  // namespace texmap::test
