// Tests of scene/triangle.hpp, and of published/triangle.hpp where it differs.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "published/triangle.hpp"
#include "support/dice.hpp"
#include "support/lanes.hpp"
#include "support/many_digits.hpp"

namespace texmap::test {
namespace {

/// Three whole numbers from -range to range.
Point grid_point(Dice& dice, int range) {
  const auto whole = [&] { return static_cast<double>(dice.within(-range, range)); };
  return {whole(), whole(), whole()};
}

/// A long thin triangle: a needle has one short side; a cap has its third corner above the middle
/// of the longest side.
enum class Thin { needle, cap };

/// A triangle with a side of length 1 and a width of 1 / aspect, turned any way, `away` from 0.
Triangle thin_triangle(Dice& dice, Thin shape, double aspect, double away) {
  const Point along = dice.direction<double>();
  const Point across = normalize(cross(along, dice.direction<double>()));
  const Point a = dice.direction<double>() * away;
  const double foot = shape == Thin::cap ? 0.5 + 0.3 * dice.between(-1, 1) : 0;
  return {a, a + along, a + along * foot + across * (1 / aspect)};
}

/// A point of the triangle, inside but for rounding.
Point point_inside(Dice& dice, const Triangle& t) {
  double r = (dice.between(-1, 1) + 1) / 2;
  double s = (dice.between(-1, 1) + 1) / 2;
  if (r + s > 1) {
    r = 1 - r;
    s = 1 - s;
  }
  return t.a + (t.b - t.a) * r + (t.c - t.a) * s;
}

template <class Real>
bool is(const Barycentric<Real>& w, double a, double b, double c) {
  return !w.degenerate && w.a == Real(a) && w.b == Real(b) && w.c == Real(c);
}

/// What is said of a triangle that is none.
template <class Real>
bool is_degenerate(const Barycentric<Real>& w) {
  return w.degenerate && w.a == Real(1) && w.b == Real(0) && w.c == Real(0);
}

template <class Real>
bool has_nan(const Barycentric<Real>& w) {
  return std::isnan(w.a) || std::isnan(w.b) || std::isnan(w.c);
}

const Triangle right_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// Equal corners, and corners on a line, many of them in the plane z = 0.
const Triangle degenerate_triangles[] = {
    {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
    {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}},
    {{1, 2, 3}, {1, 2, 3}, {4, 5, 7}},
    {{1, 2, 3}, {4, 5, 7}, {1, 2, 3}},
    {{4, 5, 7}, {1, 2, 3}, {1, 2, 3}},
    {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
    {{0, 0, 0}, {0, 2, 0}, {0, 1, 0}},
    {{1, 1, 1}, {-1, -1, -1}, {3, 3, 3}},
    {{0, 0, 0}, {1, 2, 3}, {-3, -6, -9}},
    {{1e30, 1e30, 0}, {2e30, 2e30, 0}, {3e30, 3e30, 0}},
    {{1e-30, 1e-30, 0}, {2e-30, 2e-30, 0}, {3e-30, 3e-30, 0}},
    {{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}},
    // On a line only before their tenths were rounded.
    {{0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0.3, 0}},
    {{0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}},
    {{0.1, 0.3, 0}, {0.2, 0.6, 0}, {0.3, 0.9, 0}},
    {{1.1, 1.2, 1.3}, {1.2, 1.4, 1.6}, {1.4, 1.8, 2.2}},
    {{-0.1, 0.7, 0}, {0.2, -1.4, 0}, {0.3, -2.1, 0}},
};

constexpr int orders_of_axes = 6;

/// The point with its coordinates in another order: what lies in the plane z = 0 then lies in
/// x = 0 or y = 0.
template <class Real>
Vec3<Real> with_axes(const Vec3<Real>& p, int order) {
  const Vec3<Real> turned[] = {p, {p.y, p.z, p.x}, {p.z, p.x, p.y}};
  const Vec3<Real>& q = turned[order % 3];
  return order < 3 ? q : Vec3<Real>{q.y, q.x, q.z};
}
Triangle with_axes(const Triangle& t, int order) {
  return {with_axes(t.a, order), with_axes(t.b, order), with_axes(t.c, order)};
}

TEST_CASE_TEMPLATE(
    "P24: at a corner all the weight is that corner's, to the bit, for a triangle of any shape",
    Real, float, double, long double) {
  Dice dice;
  for (const double aspect : {1.0, 1e2, 1e4, 1e6}) {
    for (int i = 0; i < 2000; ++i) {
      const Triangle t = thin_triangle(dice, i % 2 == 0 ? Thin::needle : Thin::cap, aspect, 1);
      REQUIRE(is(barycentric(t, number_cast<Real>(t.a)), 1, 0, 0));
      REQUIRE(is(barycentric(t, number_cast<Real>(t.b)), 0, 1, 0));
      REQUIRE(is(barycentric(t, number_cast<Real>(t.c)), 0, 0, 1));
    }
  }
}

TEST_CASE_TEMPLATE("P24: in the middle of a side the weights are 1/2, 1/2 and 0, to the bit", Real,
                   float, double, long double) {
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    // Even coordinates, so that every number holds the middles.
    const int range = i % 2 == 0 ? 16 : 1000000;
    const Triangle t{grid_point(dice, range) * 2.0, grid_point(dice, range) * 2.0,
                     grid_point(dice, range) * 2.0};
    if (barycentric(t, number_cast<Real>(t.a)).degenerate) continue;
    REQUIRE(is(barycentric(t, number_cast<Real>((t.a + t.b) * 0.5)), 0.5, 0.5, 0));
    REQUIRE(is(barycentric(t, number_cast<Real>((t.b + t.c) * 0.5)), 0, 0.5, 0.5));
    REQUIRE(is(barycentric(t, number_cast<Real>((t.c + t.a) * 0.5)), 0.5, 0, 0.5));
  }
}

TEST_CASE_TEMPLATE("P24: at the centroid each weight is the number nearest to 1/3, or its neighbor",
                   Real, float, double, long double) {
  Dice dice;
  const Real third = Real(1) / Real(3);
  Real worst = 0;
  int different = 0;
  for (int i = 0; i < 10000; ++i) {
    const Point center = grid_point(dice, 1000);
    const Point to_a = grid_point(dice, 1000);
    const Point to_b = grid_point(dice, 1000);
    const Triangle t{center + to_a, center + to_b, center - to_a - to_b};
    const Barycentric<Real> w = barycentric(t, number_cast<Real>(center));
    if (w.degenerate) continue;
    worst = std::max({worst, abs(w.a - third), abs(w.b - third), abs(w.c - third)});
    if (w.a != third || w.b != third || w.c != third) ++different;
  }
  MESSAGE(different << " of 10000 differ, by up to "
                    << static_cast<double>(worst / unit_roundoff<Real>()) << " unit roundoffs");
  CHECK(worst <= Real(0.5) * unit_roundoff<Real>());  // one step of the numbers from 1/4 to 1/2
}

TEST_CASE_TEMPLATE("P25: beyond a side a weight is negative, not folded back inside", Real, float,
                   double, long double) {
  CHECK(is(barycentric(right_triangle, Vec3<Real>{-1, 0, 0}), 2, -1, 0));
  CHECK(is(barycentric(right_triangle, Vec3<Real>{0, -1, 0}), 2, 0, -1));
  CHECK(is(barycentric(right_triangle, Vec3<Real>{1, 1, 0}), -1, 1, 1));
  CHECK(is(barycentric(right_triangle, Vec3<Real>{-2, -3, 0}), 6, -2, -3));
  // The other way round, and in the other two planes.
  CHECK(is(barycentric({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, Vec3<Real>{-1, 0, 0}), 2, 0, -1));
  CHECK(is(barycentric({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}, Vec3<Real>{0, -1, 0}), 2, 0, -1));
  CHECK(is(barycentric({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, Vec3<Real>{-1, 0, 0}), 2, -1, 0));
}

TEST_CASE_TEMPLATE(
    "P26: equal corners and corners on a line are degenerate, and have weights all the same", Real,
    float, double, long double) {
  for (const Triangle& of_table : degenerate_triangles) {
    for (int order = 0; order < orders_of_axes; ++order) {
      const Triangle t = with_axes(of_table, order);
      CAPTURE(order);
      CAPTURE(of_table.b.x);
      CAPTURE(of_table.c.y);
      CHECK(is_degenerate(barycentric(t, number_cast<Real>(t.a))));
      CHECK(is_degenerate(barycentric(t, number_cast<Real>(t.b))));
      CHECK(is_degenerate(barycentric(t, Vec3<Real>{Real(0.25), Real(-7), Real(1e6)})));
      CHECK(is_degenerate(barycentric(t, number_cast<Real>((t.a + t.b + t.c) * (1.0 / 3)))));
    }
  }
}

TEST_CASE_TEMPLATE(
    "P26: points computed on a line, in double, are degenerate wherever rounding put them", Real,
    float, double, long double) {
  Dice dice;
  for (int i = 0; i < 20000; ++i) {
    const Point start = dice.direction<double>() * std::exp2(10 * dice.between(-1, 1));
    const Point along = dice.direction<double>();
    const Triangle t{start, start + along * (3 * dice.between(-1, 1)),
                     start + along * (3 * dice.between(-1, 1))};
    REQUIRE(is_degenerate(barycentric(t, number_cast<Real>(point_inside(dice, t)))));
  }
}

TEST_CASE_TEMPLATE("a triangle that is thin along an axis is one at any width", Real, float, double,
                   long double) {
  for (double width = 1; width >= 1e-30; width /= 2) {
    CAPTURE(width);
    const Triangle thin{{0, 0, 0}, {1, 0, 0}, {0.5, width, 0}};
    const Vec3<Real> inside{Real(0.5), Real(width / 2), 0};
    for (int order = 0; order < orders_of_axes; ++order) {
      CAPTURE(order);
      const Triangle t = with_axes(thin, order);
      const Vec3<Real> p = with_axes(inside, order);
      REQUIRE(is(barycentric(t, p), 0.25, 0.25, 0.5));
      REQUIRE(is(barycentric({t.b, t.c, t.a}, p), 0.25, 0.5, 0.25));
      REQUIRE(is(barycentric({t.c, t.a, t.b}, p), 0.5, 0.25, 0.25));
    }
  }
}

TEST_CASE_TEMPLATE(
    "a triangle of size 1 is one up to 1e6 from the origin in float, 5e14 in double, and none far "
    "beyond",
    Real, float, double) {
  const double near = std::is_same_v<Real, float> ? 1e6 : 5e14;
  for (const double away : {1.0, 1e3, near}) {
    CAPTURE(away);
    const double at = std::round(away);
    CHECK(is(barycentric({{at, at, at}, {at + 1, at, at}, {at, at + 1, at}},
                         Vec3<Real>{Real(at), Real(at), Real(at)}),
             1, 0, 0));
  }
  const Real far = Real(16) * Real(near);
  CHECK(barycentric({{far, far, far}, {far + 1, far, far}, {far, far + 1, far}},
                    Vec3<Real>{far, far, far})
            .degenerate);
}

TEST_CASE_TEMPLATE("a point that is no number or at no place has weights that are numbers", Real,
                   float, double, long double) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const Real bad : {nan, infinity<Real>(), -infinity<Real>()}) {
    CHECK(is_degenerate(barycentric(right_triangle, Vec3<Real>{bad, 0, 0})));
    CHECK(is_degenerate(barycentric(right_triangle, Vec3<Real>{0, bad, 0})));
    CHECK(is_degenerate(barycentric(right_triangle, Vec3<Real>{bad, bad, bad})));
  }
  const double infinite = infinity<double>();
  CHECK(is_degenerate(barycentric({{0, 0, 0}, {infinite, 0, 0}, {0, 1, 0}}, Vec3<Real>{0, 0, 0})));
  CHECK(is_degenerate(
      barycentric({{std::nan(""), 0, 0}, {1, 0, 0}, {0, 1, 0}}, Vec3<Real>{0, 0, 0})));
  for (Real far = 1; far < Real(1e36L); far = far * Real(10))
    CHECK_FALSE(has_nan(barycentric(right_triangle, Vec3<Real>{far, -far / Real(3), 0})));
}

TEST_CASE_TEMPLATE("P27: a needle a million times longer than wide keeps its weights", Real, float,
                   double, long double) {
  const Triangle needle{{0, 0, 0}, {1, 0, 0}, {1, 0x1p-20, 0}};
  CHECK(is(barycentric(needle, Vec3<Real>{Real(0.5), Real(0x1p-22), 0}), 0.5, 0.25, 0.25));
}

TEST_CASE_TEMPLATE(
    "the unit of length does not matter, from 1e-20 to 1e20 in float and from 1e-300 to 1e300 in "
    "double",
    Real, float, double, long double) {
  const int decades = std::is_same_v<Real, float> ? 20 : 300;
  for (int i = -decades; i <= decades; ++i) {
    CAPTURE(i);
    const double side = std::pow(10.0, i);
    const Real quarter = Real(side) / Real(4);
    REQUIRE(
        is(barycentric({{0, 0, 0}, {side, 0, 0}, {0, side, 0}}, Vec3<Real>{quarter, quarter, 0}),
           0.5, 0.25, 0.25));
    REQUIRE(
        is(barycentric({{0, 0, 0}, {0, side, 0}, {0, 0, side}}, Vec3<Real>{0, quarter, quarter}),
           0.5, 0.25, 0.25));
    REQUIRE(
        is(barycentric({{0, 0, 0}, {0, 0, side}, {side, 0, 0}}, Vec3<Real>{quarter, 0, quarter}),
           0.5, 0.25, 0.25));
  }
  // Any triangle, to the bit: powers of two round nothing.
  Dice dice;
  for (int i = 0; i < 300; ++i) {
    const Triangle t =
        thin_triangle(dice, i % 2 == 0 ? Thin::needle : Thin::cap, i % 3 == 0 ? 1e4 : 1, 1);
    const Point p = point_inside(dice, t);
    const Barycentric<Real> expected = barycentric(t, number_cast<Real>(p));
    const int reach = std::is_same_v<Real, float> ? 66 : 900;
    for (const int power : {-reach, -reach / 2, -1, 1, reach / 2, reach}) {
      const double unit = std::ldexp(1.0, power);
      const Barycentric<Real> w =
          barycentric({t.a * unit, t.b * unit, t.c * unit}, number_cast<Real>(p * unit));
      REQUIRE((w.a == expected.a && w.b == expected.b && w.c == expected.c &&
               w.degenerate == expected.degenerate));
    }
  }
}

TEST_CASE_TEMPLATE("off the plane the weights are those of the foot", Real, float, double,
                   long double) {
  for (const double height : {1e-6, 0.5, 7.0, 1e6})
    CHECK(is(barycentric(right_triangle, Vec3<Real>{Real(0.25), Real(0.25), Real(height)}), 0.5,
             0.25, 0.25));
}

TEST_CASE_TEMPLATE("the normal points to the side from which a, b, c run counterclockwise", Real,
                   float, double, long double) {
  const auto normal_of = [](const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) {
    return cross(exact_difference(b, a), exact_difference(c, a));
  };
  const Vec3<Real> zero{0, 0, 0};
  CHECK(normal_of(zero, {1, 0, 0}, {0, 1, 0}).z == Real(1));
  CHECK(normal_of(zero, {0, 1, 0}, {0, 0, 1}).x == Real(1));
  CHECK(normal_of(zero, {0, 0, 1}, {1, 0, 0}).y == Real(1));
}

TEST_CASE_TEMPLATE("turning a triangle over changes no weight", Real, float, double, long double) {
  Dice dice;
  for (int i = 0; i < 5000; ++i) {
    const Triangle t = thin_triangle(dice, Thin::cap, i % 2 == 0 ? 1 : 1e4, 1);
    const Vec3<Real> p = number_cast<Real>(point_inside(dice, t));
    const Barycentric<Real> front = barycentric(t, p);
    const Barycentric<Real> back = barycentric({t.a, t.c, t.b}, p);
    REQUIRE((front.a == back.a && front.b == back.c && front.c == back.b));
  }
}

TEST_CASE_TEMPLATE("a pack finds in each lane the weights that a single number finds", T, float,
                   double) {
  using Many = Pack<T>;
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    Triangle t =
        thin_triangle(dice, i % 2 == 0 ? Thin::needle : Thin::cap, i % 3 == 0 ? 1e4 : 1, 1);
    if (i % 10 == 0) t.c = t.a + (t.b - t.a) * 0.3;
    const Many r = from_lanes<Many>([&](std::size_t k) {
      return k == 1 && i % 5 == 0 ? std::numeric_limits<T>::quiet_NaN()
                                  : static_cast<T>(dice.between(-1, 1));
    });
    const Many s =
        from_lanes<Many>([&](std::size_t) { return static_cast<T>(dice.between(-1, 1)); });
    const Vec3<Many> a = number_cast<Many>(t.a);
    const Vec3<Many> p = a + (number_cast<Many>(t.b) - a) * r + (number_cast<Many>(t.c) - a) * s;
    check_each_lane<Many>(
        [&t]<class Real>(const Vec3<Real>& at) {
          const Barycentric<Real> w = barycentric(t, at);
          return std::tuple(w.a, w.b, w.c, select(w.degenerate, Real(1), Real(0)));
        },
        p);
  }
}

TEST_CASE_TEMPLATE("the triangle article's weights agree with ours inside an ordinary triangle",
                   Real, float, double, long double) {
  Dice dice;
  Real worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const Triangle t{dice.direction<double>(), dice.direction<double>() + Point{3, 0, 0},
                     dice.direction<double>() + Point{0, 3, 0}};
    const Point middle = (t.a + t.b + t.c) * (1.0 / 3);
    const Vec3<Real> p =
        number_cast<Real>((point_inside(dice, t) + middle) * 0.5);  // not near a side
    const Barycentric<Real> ours = barycentric(t, p);
    const Barycentric<Real> heron = published::barycentric_heron(t, p);
    worst = std::max({worst, abs(heron.a - ours.a), abs(heron.b - ours.b), abs(heron.c - ours.c)});
  }
  MESSAGE("worst: " << static_cast<double>(worst / unit_roundoff<Real>()) << " unit roundoffs");
  CHECK(worst <= Real(512) * unit_roundoff<Real>());
}

TEST_CASE_TEMPLATE(
    "the triangle article takes a point beyond a side for one inside, because areas have no sign",
    Real, float, double, long double) {
  const Barycentric<Real> w = published::barycentric_heron(right_triangle, Vec3<Real>{-1, 0, 0});
  const Real tolerance = Real(4) * unit_roundoff<Real>();
  CHECK(abs(w.a - Real(2)) <= tolerance);
  CHECK(abs(w.b - Real(1)) <= tolerance);  // -1 in truth
  CHECK(abs(w.c + Real(2)) <= tolerance);  // 0 in truth
}

/// What became of 10000 points in triangles of one shape.
struct Fate {
  int nan = 0;      ///< points with a weight that is no number
  int visible = 0;  ///< points with a weight off by more than a texel of a picture 8192 wide
};

/// @param formula  (triangle, point) to weights; the reference is barycentric in long double, for
///                 the corners that Real holds
template <class Real, class Formula>
Fate fate(Thin shape, double aspect, Formula formula) {
  const auto held = [](const Point& p) {
    const Vec3<Real> q = number_cast<Real>(p);
    return Point{static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z)};
  };
  Dice dice;
  Fate seen;
  for (int i = 0; i < 10000; ++i) {
    const Triangle drawn = thin_triangle(dice, shape, aspect, 1);
    const Triangle t{held(drawn.a), held(drawn.b), held(drawn.c)};
    const Point p = held(point_inside(dice, drawn));
    const Barycentric<Real> w = formula(t, number_cast<Real>(p));
    const Barycentric<long double> truth = barycentric(t, number_cast<long double>(p));
    if (has_nan(w)) {
      ++seen.nan;
    } else if (std::max({abs(w.a - truth.a), abs(w.b - truth.b), abs(w.c - truth.c)}) >
               1.0L / 8192) {
      ++seen.visible;
    }
  }
  MESSAGE(std::string(shape == Thin::cap ? "cap " : "needle ")
          << aspect << ": NaN " << seen.nan << ", visibly wrong " << seen.visible);
  return seen;
}

TEST_CASE(
    "in float the triangle article's weights are mostly NaN in caps of 10000 to 1 and wrong in all "
    "the rest, and "
    "ours are right") {
  const auto heron = [](const Triangle& t, const Vec3<float>& p) {
    return published::barycentric_heron(t, p);
  };
  const auto ours = [](const Triangle& t, const Vec3<float>& p) { return barycentric(t, p); };
  const Fate cap = fate<float>(Thin::cap, 1e4, heron);
  CHECK(cap.nan > 5000);
  CHECK(cap.nan + cap.visible > 9990);
  const Fate needle = fate<float>(Thin::needle, 1e4, heron);
  CHECK(needle.nan > 200);
  CHECK(needle.nan + needle.visible > 9950);
  CHECK(fate<float>(Thin::needle, 100, heron).visible >
        5000);  // a needle that a model may well contain
  for (const Thin shape : {Thin::needle, Thin::cap}) {
    for (const double aspect : {1.0, 100.0, 1e4, 1e6}) {
      const Fate fine = fate<float>(shape, aspect, ours);
      CHECK(fine.nan == 0);
      CHECK(fine.visible == 0);
    }
    CHECK(fate<float>(shape, 1e8, ours).nan == 0);  // nearly all degenerate, and said to be
  }
}

TEST_CASE(
    "in double the triangle article's weights last to a thousand to one and fail at a hundred "
    "million to one, "
    "and ours are right") {
  const auto heron = [](const Triangle& t, const Vec3<double>& p) {
    return published::barycentric_heron(t, p);
  };
  const auto ours = [](const Triangle& t, const Vec3<double>& p) { return barycentric(t, p); };
  const Fate thousand = fate<double>(Thin::needle, 1e3, heron);
  CHECK(thousand.nan == 0);
  CHECK(thousand.visible == 0);
  CHECK(fate<double>(Thin::cap, 1e8, heron).nan > 1500);
  CHECK(fate<double>(Thin::needle, 1e8, heron).nan > 100);
  CHECK(fate<double>(Thin::needle, 1e8, heron).visible > 9000);
  for (const Thin shape : {Thin::needle, Thin::cap}) {
    const Fate fine = fate<double>(shape, 1e8, ours);
    CHECK(fine.nan == 0);
    CHECK(fine.visible == 0);
  }
}

TEST_CASE(
    "of a line the triangle article makes a triangle with plausible weights, and of a point NaN") {
  const Triangle line{{0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}};
  const Barycentric<float> w = published::barycentric_heron(line, Vec3<float>{0.2F, 0.4F, 0.6F});
  CHECK_FALSE(w.degenerate);
  CHECK(w.a + w.b + w.c == doctest::Approx(1).epsilon(1e-6));
  CHECK(std::min({w.a, w.b, w.c}) >= 0);
  CHECK(std::max({w.a, w.b, w.c}) <= 1);
  CHECK(has_nan(
      published::barycentric_heron({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, Vec3<float>{1, 2, 3})));
}

TEST_CASE_TEMPLATE("Heron's formula knows the triangle 3, 4, 5 in every order", Real, float, double,
                   long double) {
  const double table[][3] = {{3, 4, 5}, {4, 5, 3}, {5, 3, 4}, {5, 4, 3}, {4, 3, 5}, {3, 5, 4}};
  for (const auto& [x, y, z] : table) {
    CHECK(published::heron_area(Real(x), Real(y), Real(z)) == Real(6));
  }
  CHECK(published::heron_area(Real(1), Real(1), Real(0)) == Real(0));
}

TEST_CASE("Kahan's needle: in float Heron's formula finds no area at all") {
  const float x = 100000;
  const float y = 99999.99979F;
  const float z = 0.00029F;
  CHECK(published::heron_area(x, y, z) == 0);
}

#ifdef TEXMAP_HAVE_DIGITS  // the number that judges double; the laws above do without it
using Reference = Digits100;

template <class Real>
Vec3<Reference> referred(const Vec3<Real>& p) {
  return {Reference(p.x), Reference(p.y), Reference(p.z)};
}

/// The weights for the corners that Real holds: Cramer's rule on dot products of sides, 100 digits.
template <class Real>
Vec3<Reference> true_weights(const Triangle& triangle, const Vec3<Real>& p) {
  const Vec3<Reference> a = referred(number_cast<Real>(triangle.a));
  const Vec3<Reference> ab = referred(number_cast<Real>(triangle.b)) - a;
  const Vec3<Reference> ac = referred(number_cast<Real>(triangle.c)) - a;
  const Vec3<Reference> ap = referred(p) - a;
  const Reference bb = dot(ab, ab);
  const Reference bc = dot(ab, ac);
  const Reference cc = dot(ac, ac);
  const Reference whole = bb * cc - bc * bc;
  const Reference at_b = (dot(ap, ab) * cc - dot(ap, ac) * bc) / whole;
  const Reference at_c = (dot(ap, ac) * bb - dot(ap, ab) * bc) / whole;
  return {Reference(1) - at_b - at_c, at_b, at_c};
}

/// The largest error of the three weights in unit roundoffs.
template <class Real>
double error_of(const Barycentric<Real>& w, const Vec3<Reference>& truth) {
  const Vec3<Reference> off =
      Vec3<Reference>{Reference(w.a), Reference(w.b), Reference(w.c)} - truth;
  return static_cast<double>(largest(off) / Reference(unit_roundoff<Real>()));
}

TEST_CASE_TEMPLATE(
    "inside a triangle of any shape, anywhere, the weights are right to 3 unit roundoffs", Real,
    float, double, long double) {
  Dice dice;
  double worst = 0;
  int degenerate = 0;
  for (const double away : {1.0, 1e3}) {
    for (const double aspect : {1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e8, 1e12}) {
      // At an angle to the axes a float's grid is coarser than that.
      if (std::is_same_v<Real, float> && aspect * away > 1e6) continue;
      if (aspect * away > 1e14) continue;
      for (int i = 0; i < 2000; ++i) {
        const Triangle t = thin_triangle(dice, i % 2 == 0 ? Thin::needle : Thin::cap, aspect, away);
        const Vec3<Real> p = number_cast<Real>(point_inside(dice, t));
        const Barycentric<Real> w = barycentric(t, p);
        const Vec3<Reference> truth = true_weights(t, p);
        const double size =
            static_cast<double>(largest(truth));  // above 1 where rounding took p outside
        worst = std::max(worst, error_of(w, truth) / std::max(1.0, size * size));
        degenerate += w.degenerate ? 1 : 0;
      }
    }
  }
  MESSAGE("worst: " << worst << " unit roundoffs");
  CHECK(degenerate == 0);
  CHECK(worst <= 3);
}

TEST_CASE_TEMPLATE(
    "outside a triangle the error grows with the square of the largest weight, and no faster", Real,
    float, double, long double) {
  Dice dice;
  for (const double reach : {2.0, 30.0, 1000.0}) {
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
      const Triangle t =
          thin_triangle(dice, i % 2 == 0 ? Thin::needle : Thin::cap, i % 3 == 0 ? 100 : 1, 1);
      const double r = reach * dice.between(-1, 1);
      const double q = reach * dice.between(-1, 1);
      const Vec3<Real> p = number_cast<Real>(t.a + (t.b - t.a) * r + (t.c - t.a) * q);
      const Vec3<Reference> truth = true_weights(t, p);
      const double size = std::max(1.0, static_cast<double>(largest(truth)));
      const Barycentric<Real> w = barycentric(t, p);
      REQUIRE_FALSE(w.degenerate);
      worst = std::max(worst, error_of(w, truth) / (size * size));
    }
    CAPTURE(reach);
    MESSAGE("worst: " << worst << " unit roundoffs times the square, up to " << reach
                      << " sides away");
    CHECK(worst <= 10);
  }
}

TEST_CASE(
    "the same formula in 100 digits has 100 digits, so it can draw the pictures that judge the "
    "others") {
  Dice dice;
  for (int i = 0; i < 200; ++i) {
    const Triangle t = thin_triangle(dice, i % 2 == 0 ? Thin::needle : Thin::cap, 1e4, 1);
    const Vec3<Reference> p = number_cast<Reference>(point_inside(dice, t));
    const Vec3<Reference> truth = true_weights(t, p);
    const Barycentric<Reference> w = barycentric(t, p);
    REQUIRE_FALSE(w.degenerate);
    REQUIRE(largest(Vec3<Reference>{w.a, w.b, w.c} - truth) < Reference(1e-80));
  }
  CHECK(barycentric({{0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}}, Vec3<Reference>{}).degenerate);
}

/// The area of a triangle from the lengths of its sides, in 100 digits.
template <class Real>
Reference true_area(Real x, Real y, Real z) {
  const Reference s = (Reference(x) + Reference(y) + Reference(z)) / 2;
  return sqrt(s * (s - Reference(x)) * (s - Reference(y)) * (s - Reference(z)));
}

TEST_CASE_TEMPLATE(
    "for sides without an error Heron's area loses what the triangle is longer than wide", Real,
    float, double) {
  Dice dice;
  for (const double aspect : {1.0, 1e2, 1e4, 1e6, 1e8}) {
    if (std::is_same_v<Real, float> && aspect > 1e6) continue;
    double worst_heron = 0;
    for (int i = 0; i < 5000; ++i) {
      // Two sides of about 1 and a short one, within the triangle inequality.
      const Real x = static_cast<Real>(1.5 + 0.25 * dice.between(-1, 1));
      const Real z = static_cast<Real>((0.75 + 0.25 * dice.between(-1, 1)) / aspect);
      const Real y = x + z * static_cast<Real>(0.9 * dice.between(-1, 1));
      if (!(x < y + z && y < x + z) || Reference(x) - Reference(y) >= Reference(z) ||
          Reference(y) - Reference(x) >= Reference(z))
        continue;
      const Reference truth = true_area(x, y, z);
      const auto error = [&](Real area) {
        return static_cast<double>(abs(Reference(area) - truth) / truth /
                                   Reference(unit_roundoff<Real>()));
      };
      const Real heron = published::heron_area(x, y, z);
      worst_heron =
          std::max(worst_heron, std::isnan(heron) ? 1 / static_cast<double>(unit_roundoff<Real>())
                                                  : error(heron));
    }
    CAPTURE(aspect);
    MESSAGE("Heron's worst at " << aspect << " to 1: " << worst_heron << " unit roundoffs");
    CHECK(worst_heron > aspect / 2);
  }
}
#endif

}  // namespace
}  // namespace texmap::test
