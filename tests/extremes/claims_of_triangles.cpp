// Claims of common/scene/triangle.hpp and floor.hpp: weights in a triangle, and the floor.
#include "claims.hpp"
#include "published/triangle.hpp"
#include "references.hpp"
#include "scene/floor.hpp"
#include "scene/triangle.hpp"

namespace texmap::extremes {
namespace {

/// A triangle with corners that every number holds, and a point.
template <class T>
struct Case {
  Triangle triangle;
  Vec3<T> p;
};

template <class T>
Point as_point(const Vec3<long double>& p) {
  return number_cast<double>(rounded<T>(p));
}

/// Which needles and caps are drawn, with a point inside or outside.
struct Thin {
  long double aspect;       ///< power of ten: how many times longer than wide, at most
  int scale = 0;            ///< sizes are multiplied by powers of two up to this and its inverse
  bool along_axis = false;  ///< or at any angle to the axes
  long double farthest{};   ///< power of ten: the point is as many sides outside; 0: it is inside
};

template <class T>
Case<T> draw_thin(Dice& dice, const Thin& thin) {
  using Corner = std::conditional_t<(sizeof(T) > sizeof(double)), double,
                                    T>;  // triangles of a scene are double
  const Vec3<long double> along = thin.along_axis ? Vec3<long double>{1, 0, 0} : dice.direction();
  const Vec3<long double> across =
      (thin.along_axis ? Vec3<long double>{0, 0, 1} : dice.across(along)) *
      dice.power_of_ten(-thin.aspect, 0);
  const long double foot = dice.once_in(2)
                               ? dice.uniform(0, 1)
                               : 1;  // a cap's top is over its base, a needle's at its end
  const Vec3<long double> from = dice.direction() * (thin.along_axis ? 0.0L : dice.uniform(0, 1));
  const int size = dice.within(-thin.scale, thin.scale);
  const auto corner = [&](const Vec3<long double>& p) { return scaled(as_point<Corner>(p), size); };
  const Triangle triangle{corner(from), corner(from + along), corner(from + along * foot + across)};
  long double at_b = dice.uniform(0, 1);
  long double at_c = dice.uniform(0, 1);
  if (at_b + at_c > 1) {
    at_b = 1 - at_b;
    at_c = 1 - at_c;
  }
  if (thin.farthest > 0) {
    at_b = dice.sign() * dice.power_of_ten(0, thin.farthest);
    at_c = dice.sign() * dice.power_of_ten(-thin.farthest, thin.farthest);
  }
  return {triangle, scaled(rounded<T>(from + along * (at_b + at_c * foot) + across * at_c), size)};
}

/// The point's distance from a corner over the triangle's smallest height.
template <class T>
Digits50 reach_over_height(const Case<T>& one) {
  const Vec3<Digits50> ab = exactly(one.triangle.b) - exactly(one.triangle.a);
  const Vec3<Digits50> ac = exactly(one.triangle.c) - exactly(one.triangle.a);
  const Vec3<Digits50> bc = ac - ab;
  const Digits50 longest = sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
  return length(exactly(one.p) - exactly(one.triangle.a)) * longest / length(cross(ab, ac));
}

template <class T>
double weights_off(const Barycentric<T>& got, const Case<T>& one) {
  const Vec3<Digits50> exact = exact_weights_by_areas(
      exactly(one.triangle.a), exactly(one.triangle.b), exactly(one.triangle.c), exactly(one.p));
  // Far outside, weights are large; errors grow with them, and where p sees the sides as almost
  // one line also with the distance over the triangle's height.
  const Digits50 most = std::max(Digits50(1), largest(exact));
  const Digits50 unit = roundoff<T>() * most * most * (1 + roundoff<T>() * reach_over_height(one));
  return std::max({units_off(got.a, exact.x, unit), units_off(got.b, exact.y, unit),
                   units_off(got.c, exact.z, unit)});
}

/// The weights of all lanes' points in one triangle; the first lane's triangle is everyone's.
template <class Real, class Function>
auto worst_weights(Function function, const Thin& thin) {
  using T = Scalar<Real>;
  return worst_over([=](Dice& dice, Worst& worst) {
    const Case<T> one = draw_thin<T>(dice, thin);
    const Barycentric<Real> got = function(one.triangle, number_cast<Real>(one.p));
    const std::size_t k = lanes<Real> - 1;
    if (thin.farthest > 0 && lane(select(got.degenerate, Real(1), Real(0)), k) > 0) return;
    worst.see(weights_off<T>({lane(got.a, k), lane(got.b, k), lane(got.c, k), false}, one),
              [&] { return described(one.triangle) + " at " + described(one.p); });
  });
}

/// Triangles of this shape that are called degenerate although they are far from it.
template <class T>
auto count_refused(const Thin& thin) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    const Case<T> one = draw_thin<T>(dice, thin);
    worst.count(barycentric(one.triangle, one.p).degenerate,
                [&] { return described(one.triangle); });
  });
}

/// Corners that are equal or on a line: each a rounded multiple of one vector, or copies.
template <class T>
Triangle draw_flat(Dice& dice) {
  using Corner = std::conditional_t<(sizeof(T) > sizeof(double)), double, T>;
  const Vec3<long double> along = dice.direction() * dice.power_of_ten(-6, 6);
  const auto corner = [&] {
    return as_point<Corner>(along * (dice.once_in(3) ? 1.0L : dice.uniform(-4, 4)));
  };
  return {corner(), corner(), corner()};
}

/// Triangles that have other weights, or count as degenerate, with corners in another order.
template <class T>
auto count_of_order(int scale) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    Case<T> one = draw_thin<T>(dice, {.aspect = 20, .scale = scale});
    if (dice.once_in(3)) one.triangle = draw_flat<T>(dice);
    const auto& [a, b, c] = one.triangle;
    const Barycentric<T> w = barycentric(one.triangle, one.p);
    const Barycentric<T> turned = barycentric<T>({b, c, a}, one.p);
    const Barycentric<T> mirrored = barycentric<T>({a, c, b}, one.p);
    const bool alike = w.degenerate
                           ? turned.degenerate && mirrored.degenerate
                           : turned.a == w.b && turned.b == w.c && turned.c == w.a &&
                                 mirrored.a == w.a && mirrored.b == w.c && mirrored.c == w.b;
    worst.count(!alike, [&] { return described(one.triangle) + " at " + described(one.p); });
  });
}

/// Triangles without an area that are not called so.
template <class T>
auto count_missed_flats() {
  return worst_over(4, [](Dice& dice, Worst& worst) {
    const Triangle triangle = draw_flat<T>(dice);
    worst.count(!barycentric(triangle, rounded<T>(dice.direction())).degenerate,
                [&] { return described(triangle); });
  });
}

/// Weights that are no number, for any shape and any point.
template <class T, class Function>
auto count_nan(Function function) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    Case<T> one = draw_thin<T>(dice, {.aspect = 20});
    if (dice.once_in(3)) one.triangle = draw_flat<T>(dice);
    if (dice.once_in(3)) one.p = {dice.anything<T>(), dice.anything<T>(), dice.anything<T>()};
    const Barycentric<T> got = function(one.triangle, one.p);
    worst.count(std::isnan(got.a) || std::isnan(got.b) || std::isnan(got.c),
                [&] { return described(one.triangle) + " at " + described(one.p); });
  });
}

/// A ray over a floor.
template <class T>
Ray<T> draw_downward(Dice& dice) {
  return {rounded<T>(dice.direction() * dice.power_of_ten(-6, 6)),
          rounded<T>(dice.direction() * dice.power_of_ten(-6, 6))};
}

template <class T>
auto worst_floor() {
  return worst_over([](Dice& dice, Worst& worst) {
    const Floor floor{
        static_cast<double>(static_cast<float>(dice.sign() * dice.power_of_ten(-6, 6)))};
    const Ray<T> ray = draw_downward<T>(dice);
    const Digits50 exact =
        (Digits50(floor.height) - Digits50(ray.origin.y)) / Digits50(ray.direction.y);
    const T got = distance_to(floor, ray);
    const double missed = got == infinity<T>() ? 0 : 1e30;
    worst.see(exact <= 0 ? missed : ulps_off(got, exact), [&] { return described(ray); });
  });
}

/// Points of the floor that are not on it.
template <class T>
auto count_off_floor() {
  return worst_over(20, [](Dice& dice, Worst& worst) {
    const Floor floor{static_cast<double>(static_cast<float>(dice.uniform(-2, 2)))};
    const Ray<T> ray = draw_downward<T>(dice);
    const T distance = distance_to(floor, ray);
    if (!(distance < infinity<T>())) return;
    worst.count(point_on(floor, ray, distance).y != static_cast<T>(floor.height),
                [&] { return described(ray); });
  });
}

constexpr auto ours = [](const Triangle& triangle, const auto& p) {
  return barycentric(triangle, p);
};
constexpr auto heron = [](const Triangle& triangle, const auto& p) {
  return published::barycentric_heron(triangle, p);
};
const Triangle ordinary{{0, 0, 0}, {1, 0.25, 0}, {0.5, 1, 0.125}};

/// A program that adds up the weights of directions.
template <class Real, class Function>
auto adding_up(Function function) {
  return working_through(inputs_of_cost<Real>(drawn_direction<Real>),
                         [function](const Vec3<Real>& p) {
                           const Barycentric<Real> w = function(ordinary, p);
                           return w.a + w.b + w.c;
                         });
}

/// Which triangles are drawn, and what the page calls them.
struct Shapes {
  Thin thin;
  const char* aspect;
  const char* range;
  long double thinnest;  ///< power of ten, of those along an axis

  [[nodiscard]] std::string text() const {
    return std::string("needles and caps at any angle, to ") + aspect +
           " times longer than wide; sides of " + range;
  }
};

template <class Real>
void add_weights(Family& family, const Shapes& shapes) {
  family
      .add<Real>("barycentric", shapes.text() + "; points inside", {3, "u (largest weight)^2"},
                 worst_weights<Real>(ours, shapes.thin))
      .cost = {"Heron's formula, double", adding_up<Real>(ours), adding_up<double>(heron)};
  Thin outside{.aspect = shapes.thin.aspect, .farthest = 4};
  const Bound far{10, "u (largest weight)^2 (1 + u distance / height)"};
  family.add<Real>("barycentric, outside",
                   std::string("needles and caps at any angle, to ") + shapes.aspect +
                       " times longer than wide; points to 1e4 sides outside",
                   far, worst_weights<Real>(ours, outside));
  outside = {.aspect = shapes.thinnest, .along_axis = true, .farthest = 4};
  family.add<Real>("barycentric, outside of the thinnest",
                   "needles and caps along an axis, to u^-1.5 times longer than wide; points to "
                   "1e4 sides outside",
                   far, worst_weights<Real>(ours, outside));
}

template <class T>
void add_single_number(Family& family, const Shapes& shapes) {
  family.add<T>("barycentric, refused", shapes.text(), {0, "called degenerate"},
                count_refused<T>(shapes.thin));
  family.add<T>("barycentric, order of the corners",
                "triangles of any shape, flat ones too; points inside",
                {0, "other weights, to the last digit"}, count_of_order<T>(shapes.thin.scale));
  family.add<T>("barycentric, flat",
                "corners equal or on a line through the origin, as nearly as they can be written",
                {0, "not called degenerate"}, count_missed_flats<T>());
  family.add<T>("barycentric, anything",
                "triangles of any shape; points of anything the type can hold", {0, "NaN"},
                count_nan<T>(ours));
  family.add<T>("distance_to a Floor", "heights, origins and directions of 1e-6 to 1e6", {2, "ulp"},
                worst_floor<T>());
  family.add<T>("point_on a Floor, height", "any ray that meets it",
                {0, "not the floor's to the bit"}, count_off_floor<T>());
}

}  // namespace

Family claims_of_triangles() {
  Family family{"Triangles and the floor",
                "Exact: areas along the normal in 50 digits, checked against Cramer's rule on dot "
                "products in 100. The last rows are the areas by Heron's formula."};
  const Shapes in_float{{.aspect = 5, .scale = 60}, "1e5", "1e-18 to 1e18", 10.8L};
  const Shapes in_double{{.aspect = 13, .scale = 900}, "1e13", "1e-270 to 1e270", 24};
  add_weights<float>(family, in_float);
  add_weights<double>(family, in_double);
  add_weights<long double>(family, in_double);
  add_weights<Pack<float>>(family, in_float);
  add_weights<Pack<double>>(family, in_double);
  add_single_number<float>(family, in_float);
  add_single_number<double>(family, in_double);
  add_single_number<long double>(family, in_double);
  const std::string function = "weights by Heron's formula";
  family
      .add<double>(function,
                   "needles and caps at any angle, to 1e4 times longer than wide; points inside",
                   {3, "u (largest weight)^2"}, worst_weights<double>(heron, {.aspect = 4}))
      .expect = Expect::beyond;
  family
      .add<float>(function, "triangles of any shape; points of anything the type can hold",
                  {0, "NaN"}, count_nan<float>(heron))
      .expect = Expect::beyond;
  return family;
}

}  // namespace texmap::extremes
