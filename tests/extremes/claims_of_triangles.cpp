// Claims of common/geometry/triangle.hpp and floor.hpp: weights in a triangle, and the floor.
#include "claims.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "floor.hpp"
#include "references.hpp"
#include "seed_triangle.hpp"
#include "triangle.hpp"

namespace texmap::extremes {
namespace {

/// A triangle whose corners every number holds, and a point.
template <class T>
struct Case {
  Triangle triangle;
  Vec3<T> p;
};

template <class T>
Point as_point(const Vec3<long double>& p) {
  const Vec3<T> q = rounded<T>(p);
  return {static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z)};
}

/// A needle or a cap, at any angle to the axes, up to `aspect` (a power of ten) times longer than wide, and a point inside.
template <class T>
Case<T> draw_thin(Dice& dice, long double aspect, int scale) {
  using Corner = std::conditional_t<(sizeof(T) > sizeof(double)), double, T>;  // triangles of a scene are double
  const Vec3<long double> along = dice.direction();
  const Vec3<long double> across = dice.across(along) * dice.power_of_ten(-aspect, 0);
  const long double foot = dice.once_in(2) ? dice.uniform(0, 1) : 1;  // a cap's top is over its base, a needle's at its end
  const Vec3<long double> from = dice.direction() * dice.uniform(0, 1);
  const int size = dice.within(-scale, scale);
  const auto corner = [&](const Vec3<long double>& p) {
    const Point q = as_point<Corner>(p);
    return Point{std::ldexp(q.x, size), std::ldexp(q.y, size), std::ldexp(q.z, size)};
  };
  const Triangle triangle{corner(from), corner(from + along), corner(from + along * foot + across)};
  long double at_b = dice.uniform(0, 1);
  long double at_c = dice.uniform(0, 1);
  if (at_b + at_c > 1) {
    at_b = 1 - at_b;
    at_c = 1 - at_c;
  }
  return {triangle, scaled(rounded<T>(from + along * (at_b + at_c * foot) + across * at_c), size)};
}

template <class T>
double weights_off(const Barycentric<T>& got, const Case<T>& one) {
  const Vec3<Digits50> exact = exact_weights(exactly<Digits50>(one.triangle.a), exactly<Digits50>(one.triangle.b),
                                             exactly<Digits50>(one.triangle.c), exactly<Digits50>(one.p));
  // A point that was rounded out of a thin triangle has large weights, and their errors are relative to those.
  Digits50 largest = 1;
  for (const Digits50& w : {exact.x, exact.y, exact.z}) largest = std::max(largest, Digits50(abs(w)));
  const Digits50 unit = roundoff<T>() * largest * largest;
  return std::max({units_off(got.a, exact.x, unit), units_off(got.b, exact.y, unit), units_off(got.c, exact.z, unit)});
}

template <class Real>
Barycentric<Real> weights_of(const Triangle& triangle, const Vec3<Real>& p) {
  return barycentric(triangle, p);
}

/// The weights of all lanes' points in one triangle; the first lane's triangle is everyone's.
template <class Real, class Function>
auto worst_weights(Function function, long double aspect, int scale) {
  using T = Scalar<Real>;
  return worst_over([=](Dice& dice, Worst& worst) {
    const Case<T> one = draw_thin<T>(dice, aspect, scale);
    const Barycentric<Real> got = function(one.triangle, Vec3<Real>{Real(one.p.x), Real(one.p.y), Real(one.p.z)});
    const std::size_t k = lanes<Real> - 1;
    worst.see(weights_off<T>({lane(got.a, k), lane(got.b, k), lane(got.c, k), false}, one),
              [&] { return described(one.triangle) + " at " + described(one.p); });
  });
}

/// Triangles of this shape that are called degenerate although they are far from it.
template <class T>
auto count_refused(long double aspect, int scale) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    const Case<T> one = draw_thin<T>(dice, aspect, scale);
    worst.count(barycentric(one.triangle, one.p).degenerate, [&] { return described(one.triangle); });
  });
}

/// Corners that are equal or on a line: each a rounded multiple of one vector, or copies.
template <class T>
Triangle draw_flat(Dice& dice) {
  using Corner = std::conditional_t<(sizeof(T) > sizeof(double)), double, T>;
  const Vec3<long double> along = dice.direction() * dice.power_of_ten(-6, 6);
  const auto corner = [&] { return as_point<Corner>(along * (dice.once_in(3) ? 1.0L : dice.uniform(-4, 4))); };
  return {corner(), corner(), corner()};
}

/// Triangles without an area that are not called so.
template <class T>
auto count_missed_flats() {
  return worst_over(4, [](Dice& dice, Worst& worst) {
    const Triangle triangle = draw_flat<T>(dice);
    worst.count(!barycentric(triangle, rounded<T>(dice.direction())).degenerate, [&] { return described(triangle); });
  });
}

/// Weights that are no number, for any shape and any point.
template <class T, class Function>
auto count_nan(Function function) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    Case<T> one = draw_thin<T>(dice, 20, 0);
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
  return {rounded<T>(dice.direction() * dice.power_of_ten(-6, 6)), rounded<T>(dice.direction() * dice.power_of_ten(-6, 6))};
}

template <class T>
auto worst_floor() {
  return worst_over([](Dice& dice, Worst& worst) {
    const Floor floor{static_cast<double>(static_cast<float>(dice.sign() * dice.power_of_ten(-6, 6)))};
    const Ray<T> ray = draw_downward<T>(dice);
    const Digits50 exact = (Digits50(floor.height) - Digits50(ray.origin.y)) / Digits50(ray.direction.y);
    const T got = distance_to(floor, ray);
    if (exact <= 0) {
      worst.see(got == infinity<T>() ? 0 : 1e30, [&] { return described(ray); });
    } else {
      worst.see(ulps_off(got, exact), [&] { return described(ray); });
    }
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
    worst.count(point_on(floor, ray, distance).y != static_cast<T>(floor.height), [&] { return described(ray); });
  });
}

constexpr auto ours = [](const Triangle& triangle, const auto& p) { return barycentric(triangle, p); };
constexpr auto heron = [](const Triangle& triangle, const auto& p) { return seeds::barycentric_heron(triangle, p); };
const Triangle ordinary{{0, 0, 0}, {1, 0.25, 0}, {0.5, 1, 0.125}};

template <class Real>
Cost cost_of() {
  return {"Heron's formula, double",
          working_through(inputs_of_cost<Real>(drawn_direction<Real>),
                          [](const Vec3<Real>& p) {
                            const Barycentric<Real> w = barycentric(ordinary, p);
                            return w.a + w.b + w.c;
                          }),
          working_through(inputs_of_cost<double>(drawn_direction<double>), [](const Vec3<double>& p) {
            const Barycentric<double> w = seeds::barycentric_heron(ordinary, p);
            return w.a + w.b + w.c;
          })};
}

template <class Real>
void add_weights(std::vector<Claim>& claims, long double aspect, const char* thin, int scale, const char* range, double bound) {
  claims.push_back({.function = "barycentric",
                    .number = name_of<Real>,
                    .domain = std::string("needles and caps at any angle, to ") + thin + " times longer than wide; sides of " +
                              range + "; points inside",
                    .bound = bound,
                    .unit = "u (largest weight)^2",
                    .worst = worst_weights<Real>(ours, aspect, scale),
                    .cost = cost_of<Real>()});
}

template <class T>
void add_plain_number(std::vector<Claim>& claims, long double aspect, const char* thin, int scale, const char* range) {
  claims.push_back(
      {.function = "barycentric, refused",
       .number = name_of<T>,
       .domain = std::string("needles and caps at any angle, to ") + thin + " times longer than wide; sides of " + range,
       .unit = "called degenerate",
       .worst = count_refused<T>(aspect, scale)});
  claims.push_back({.function = "barycentric, flat",
                    .number = name_of<T>,
                    .domain = "corners equal or on a line through the origin, as nearly as they can be written",
                    .unit = "not called degenerate",
                    .worst = count_missed_flats<T>()});
  claims.push_back({.function = "barycentric, anything",
                    .number = name_of<T>,
                    .domain = "triangles of any shape; points of anything the type can hold",
                    .unit = "NaN",
                    .worst = count_nan<T>(ours)});
  claims.push_back({.function = "distance_to a Floor",
                    .number = name_of<T>,
                    .domain = "heights, origins and directions of 1e-6 to 1e6",
                    .bound = 2,
                    .unit = "ulp",
                    .worst = worst_floor<T>()});
  claims.push_back({.function = "point_on a Floor, height",
                    .number = name_of<T>,
                    .domain = "any ray that meets it",
                    .unit = "not the floor's to the bit",
                    .worst = count_off_floor<T>()});
}

}  // namespace

Family claims_of_triangles() {
  Family family{
      "Triangles and the floor",
      "Exact: Cramer's rule on dot products in 50 digits, checked against areas along the normal in 100. The last rows "
      "are the areas by Heron's formula.",
      {}};
  std::vector<Claim>& claims = family.claims;
  add_weights<float>(claims, 5, "1e5", 60, "1e-18 to 1e18", 3);
  add_weights<double>(claims, 13, "1e13", 900, "1e-270 to 1e270", 3);
  add_weights<long double>(claims, 13, "1e13", 900, "1e-270 to 1e270", 3);
#ifdef TEXMAP_HAVE_PACKS
  add_weights<Pack<float>>(claims, 5, "1e5", 60, "1e-18 to 1e18", 3);
  add_weights<Pack<double>>(claims, 13, "1e13", 900, "1e-270 to 1e270", 3);
#endif
  add_plain_number<float>(claims, 5, "1e5", 60, "1e-18 to 1e18");
  add_plain_number<double>(claims, 13, "1e13", 900, "1e-270 to 1e270");
  add_plain_number<long double>(claims, 13, "1e13", 900, "1e-270 to 1e270");
  claims.push_back({.function = "weights by Heron's formula",
                    .number = name_of<double>,
                    .domain = "needles and caps at any angle, to 1e4 times longer than wide; points inside",
                    .bound = 3,
                    .unit = "u (largest weight)^2",
                    .worst = worst_weights<double>(heron, 4, 0),
                    .expect = Expect::beyond});
  claims.push_back({.function = "weights by Heron's formula",
                    .number = name_of<float>,
                    .domain = "triangles of any shape; points of anything the type can hold",
                    .unit = "NaN",
                    .worst = count_nan<float>(heron),
                    .expect = Expect::beyond});
  return family;
}

}  // namespace texmap::extremes
