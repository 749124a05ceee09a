// Tests of scene/edge_function.hpp: exact sides of edges, whatever rounding does.
#include <doctest.h>

#include <tuple>
#include <vector>

#include "number/dual.hpp"
#include "number/kinds/pack2.hpp"
#include "scene/edge_function.hpp"
#include "support/dice.hpp"
#include "support/lanes.hpp"
#include "support/many_digits.hpp"

namespace texmap::test {
namespace {

template <class Real>
Vec3<Real> flat(Real x, Real y) {
  return {x, y, Real(1)};
}

/// 1 on the left, -1 on the right, 0 on neither or, which must not be, on both.
template <class Real>
int sign_of(const EdgeSide<Real>& side) {
  return (side.left ? 1 : 0) - (side.right ? 1 : 0);
}

/// The rule without an exact sign: what rounding leaves, and what lies on an edge is on no side.
struct RoundedSide {
  template <class Real>
  int operator()(const Vec3<Real>& a, const Vec3<Real>& b) const {
    const Real area = a.x * b.y - a.y * b.x;
    return area > Real(0) ? 1 : area < Real(0) ? -1 : 0;
  }
};
struct ExactSide {
  template <class Real>
  int operator()(const Vec3<Real>& a, const Vec3<Real>& b) const {
    return sign_of(side_of_edge(a, b));
  }
};

/// 1 if the ray at (0, 0) is in the triangle seen counterclockwise, -1 if clockwise, 0 outside.
template <class Side, class Real>
int covers(const Side& side, const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) {
  const int ab = side(a, b);
  return ab == side(b, c) && ab == side(c, a) ? ab : 0;
}

/// Of all four faces of all tetrahedra with these corners, how many do not cover (0, 0) as often
/// to the left as to the right.
template <class Real, class Side>
long uncovered(const Side& side, const std::vector<Vec3<Real>>& points) {
  long wrong = 0;
  for (const auto& a : points) {
    for (const auto& b : points) {
      for (const auto& c : points) {
        for (const auto& d : points) {
          const int sum = covers(side, a, b, c) + covers(side, a, c, d) + covers(side, a, d, b) +
                          covers(side, b, d, c);
          wrong += sum != 0 ? 1 : 0;
        }
      }
    }
  }
  return wrong;
}

TEST_CASE_TEMPLATE(
    "the four faces of a tetrahedron cover a ray as often from the front as from the back, for "
    "all corners on a grid",
    Real, float, double, long double) {
  std::vector<Vec3<Real>> points;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) points.push_back(flat(Real(x), Real(y)));
  }
  CHECK(uncovered(ExactSide{}, points) == 0);
  CHECK(uncovered(RoundedSide{}, points) > 10000);
}

TEST_CASE_TEMPLATE(
    "the same for corners on lines through the ray, where rounding alone decides between sides",
    Real, float, double, long double) {
  Dice dice;
  long wrong = 0;
  long wrong_if_rounded = 0;
  // With all digits of Real: the products of numbers of 53 digits have no rounding in 113.
  const auto factor = [&] { return static_cast<Real>(dice.sign()) * dice.number<Real>(-4, 1); };
  for (int i = 0; i < 60; ++i) {
    const Real x = factor();
    const Real y = factor();
    std::vector<Vec3<Real>> points;
    for (int k = 0; k < 9; ++k) {
      const Real s = factor();
      points.push_back(flat(x * s, y * s));
    }
    points.push_back(flat(Real(0), Real(0)));
    wrong += uncovered(ExactSide{}, points);
    wrong_if_rounded += uncovered(RoundedSide{}, points);
  }
  CHECK(wrong == 0);
  CHECK(wrong_if_rounded > 100);
}

TEST_CASE_TEMPLATE("from b to a everything is the exact opposite", Real, float, double,
                   long double) {
  Dice dice;
  for (int i = 0; i < 20000; ++i) {
    const auto coordinate = [&] {
      return i % 2 == 0 ? static_cast<Real>(dice.within(-3, 3)) : dice.number<Real>(-20, 20);
    };
    const Vec3<Real> a = flat(coordinate(), coordinate());
    const Vec3<Real> b = flat(coordinate(), coordinate());
    const EdgeSide<Real> there = side_of_edge(a, b);
    const EdgeSide<Real> back = side_of_edge(b, a);
    REQUIRE(there.left == back.right);
    REQUIRE(there.right == back.left);
    REQUIRE(there.area == -back.area);
    const bool same_place = a.x == b.x && a.y == b.y;
    REQUIRE(sign_of(there) == (same_place ? 0 : there.left ? 1 : -1));
  }
}

#ifdef TEXMAP_HAVE_DIGITS
TEST_CASE_TEMPLATE("the side is that of the exact area; rounding leaves few edges undecided", Real,
                   float, double, long double) {
  Dice dice;
  long undecided = 0;
  constexpr int edges = 40000;
  for (int i = 0; i < edges; ++i) {
    // Half of the edges point almost at the ray: b is a multiple of a, rounded, and a step further.
    const auto x = static_cast<Real>(dice.uniform(-1, 1));
    const auto y = static_cast<Real>(dice.uniform(-1, 1));
    const auto s = static_cast<Real>(dice.uniform(-2, 2));
    const bool aimed = i % 2 == 0;
    const Vec3<Real> a = flat(x, y);
    const Vec3<Real> b = aimed ? flat(x * s, std::nextafter(y * s, static_cast<Real>(dice.sign())))
                               : flat(s, static_cast<Real>(dice.uniform(-1, 1)));
    if (!aimed && a.x * b.y == a.y * b.x) ++undecided;
    const Digits50 exact = Digits50(a.x) * Digits50(b.y) - Digits50(a.y) * Digits50(b.x);
    const int expected = exact > 0 ? 1 : exact < 0 ? -1 : 0;
    if (expected != 0) REQUIRE(sign_of(side_of_edge(a, b)) == expected);
  }
  CHECK(undecided <= 1);
}
#endif

TEST_CASE_TEMPLATE("a ray along origin + direction sees that point at (0, 0), and all weight there",
                   Real, float, double, long double) {
  Dice dice;
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto point = [&] {
      return dice.direction<Real>() * static_cast<Real>(dice.uniform(1, 4));
    };
    const Vec3<Real> a = point();
    const Vec3<Real> b = point();
    const Vec3<Real> c = point();
    const Vec3<Real> eye = point();
    const RaySpace<Real> space(Ray<Real>{eye, a - eye});
    const Vec3<Real> seen = seen_along(space, a);
    REQUIRE(seen.x == Real(0));
    REQUIRE(seen.y == Real(0));
    const Crossing<Real> found = crossing(space, seen, seen_along(space, b), seen_along(space, c));
    if (!found.met) continue;
    ++met;
    REQUIRE(found.a == Real(1));
    REQUIRE(found.b == Real(0));
    REQUIRE(found.c == Real(0));
    REQUIRE(found.distance == Real(1));
  }
  CHECK(met > 2000);
}

#ifdef TEXMAP_HAVE_DIGITS
TEST_CASE_TEMPLATE(
    "a place in the view is within 6 unit roundoffs of |direction| (|point| + |origin|)", Real,
    float, double) {
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&](int power) {
      return scaled(dice.direction<Real>(), dice.within(-power, power));
    };
    const Ray<Real> ray{any(6), any(3)};
    const Vec3<Real> point = any(6);
    const RaySpace<Real> space(ray);
    const Vec3<Real> seen = seen_along(space, point);
    const Vec3<Real> d = space.direction;
    const Vec3<Real> p = space.renamed(point);
    const Vec3<Real> o = space.renamed(ray.origin);
    const auto wide = [](Real x) { return Digits50(x); };
    const Digits50 x = (wide(p.x) - wide(o.x)) * wide(d.z) - (wide(p.z) - wide(o.z)) * wide(d.x);
    const Digits50 off = abs(x - wide(seen.x));
    const Real size = largest(ray.direction) * (largest(point) + largest(ray.origin));
    worst = std::max(worst, static_cast<double>(off / (wide(size) * wide(unit_roundoff<Real>()))));
  }
  CHECK(worst > 1);
  CHECK(worst <= 6);
}
#endif

TEST_CASE("on an edge with depths 1 and 3, the middle of the screen is a quarter of the edge") {
  // The middle of the picture of the edge from (-1, 0, -1) to (3, 0, -3) is straight ahead.
  const RaySpace<double> space(Ray<double>{{0, 0, 0}, {0, 0, -1}});
  const auto with_third = [&](const Point& c) {
    return crossing(space, seen_along(space, Point{-1, 0, -1}), seen_along(space, Point{3, 0, -3}),
                    seen_along(space, c));
  };
  const Crossing<double> above = with_third({0, 9, -1});
  const Crossing<double> below = with_third({0, -9, -1});
  REQUIRE(above.met != below.met);  // the edge belongs to one of the two triangles
  const Crossing<double> found = above.met ? above : below;
  CHECK(found.a == 0.75);  // z0 / (z0 + z1) = 1/4 of the way from a to b
  CHECK(found.b == 0.25);
  CHECK(found.c == 0);
  CHECK(found.distance == 1.5);
  const double in_screen_space = 0.5;  // the mean of the ends, as a picture alone suggests
  CHECK(in_screen_space - found.b == 0.25);
}

TEST_CASE("a corner that is NaN, a direction that is zero or NaN: nothing is met") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point a{-1, -1, -2}, b{1, -1, -2}, c{0, 1, -2};
  const auto meets = [&](const Vec3d& direction, const Point& first) {
    const RaySpace<double> space(Ray<double>{{0, 0, 0}, direction});
    return crossing(space, seen_along(space, first), seen_along(space, b), seen_along(space, c))
        .met;
  };
  CHECK(meets({0, 0, -1}, a));
  CHECK_FALSE(meets({0, 0, 0}, a));
  CHECK_FALSE(meets({0, 0, nan}, a));
  CHECK_FALSE(meets({0, 0, -1}, {nan, -1, -2}));
}

TEST_CASE_TEMPLATE("each lane computes what a plain number computes", Many, Pack<float>,
                   Pack<double>, Pack2<Pack<double>>) {
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    const auto coordinate = [&] {
      return from_lanes<Many>(
          [&](std::size_t) { return static_cast<Scalar<Many>>(dice.within(-3, 3)) / 2; });
    };
    const auto point = [&] {
      Vec3<Many> p;
      p.x = coordinate();
      p.y = coordinate();
      p.z = coordinate();
      return p;
    };
    const Ray<Many> ray{point(), point()};
    const Vec3<Many> a = point(), b = point(), c = point();
    const auto found = [](const auto& in, const auto& p, const auto& q, const auto& r) {
      using Real = std::remove_cvref_t<decltype(p.x)>;
      const RaySpace<Real> space(in);
      const Crossing<Real> at =
          crossing(space, seen_along(space, p), seen_along(space, q), seen_along(space, r));
      return std::tuple{select(at.met, Real(1), Real(0)), select(at.front, Real(1), Real(0)),
                        select(at.met, at.a, Real(0)), select(at.met, at.distance, Real(0))};
    };
    check_each_lane<Many>(found, ray, a, b, c);
  }
}

TEST_CASE("the derivatives of weights and distance are those of small steps") {
  Dice dice;
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d b{2, -1, -3}, c{0.25, 2, -5}, a{-2, -1, -4};
    const double x = dice.between(-0.2, 0.2);
    const double y = dice.between(-0.2, 0.2);
    const auto at = [&]<class Real>(const Real& across, const Real& up) {
      const RaySpace<Real> space(Ray<Real>{{}, {across, up, Real(-1)}});
      const auto seen = [&](const Vec3d& p) { return seen_along(space, number_cast<Real>(p)); };
      return crossing(space, seen(a), seen(b), seen(c));
    };
    const auto dual = at(Dual<double>{x, 1, 0}, Dual<double>{y, 0, 1});
    const long double step = 1e-6L;
    const auto left = at(static_cast<long double>(x) - step, static_cast<long double>(y));
    const auto right = at(static_cast<long double>(x) + step, static_cast<long double>(y));
    if (!dual.met || !left.met || !right.met) continue;
    ++met;
    REQUIRE(std::abs(static_cast<double>((right.b - left.b) / (2 * step)) - dual.b.dx) < 1e-10);
    REQUIRE(std::abs(static_cast<double>((right.distance - left.distance) / (2 * step)) -
                     dual.distance.dx) < 1e-10);
  }
  CHECK(met > 300);
  // A ray exactly through a corner: the value 0 has derivatives all the same.
  const RaySpace<Dual<double>> space(
      Ray<Dual<double>>{{}, {Dual<double>{0, 1, 0}, Dual<double>{0, 0, 1}, Dual<double>(-1)}});
  const auto seen = seen_along(space, Vec3<Dual<double>>{{}, {}, Dual<double>(-4)});
  CHECK(seen.x.value == 0);
  CHECK(seen.x.dx == 4);
}

TEST_CASE_TEMPLATE("numbers with products that would underflow are 0, all others stay", Real, float,
                   double, long double) {
  using Limits = std::numeric_limits<Real>;
  const Real least = std::ldexp(Real(1), (Limits::min_exponent + Limits::digits) / 2);
  CHECK(snapped(least) == least);
  CHECK(snapped(-least) == -least);
  CHECK(snapped(std::nextafter(least, Real(0))) == Real(0));
  CHECK(snapped(Limits::denorm_min()) == Real(0));
  CHECK(snapped(Real(0)) == Real(0));
  // The least product has a rounding error that the number can still hold.
  const Real odd = least * (Real(1) + Limits::epsilon());
  const TwoParts<Real> product = two_product(odd, odd);
  CHECK(product.low == least * least * Limits::epsilon() * Limits::epsilon());
}

}  // namespace
}  // namespace texmap::test
