// Claims of common/scene/triangle.hpp, edge_function.hpp and floor.hpp: triangles, and the floor.
#include "claims.hpp"
#include "published/triangle.hpp"
#include "scene/edge_function.hpp"
#include "scene/floor.hpp"
#include "scene/triangle.hpp"

namespace texmap::extremes {
namespace {

/// A triangle with corners that every number holds, and a point.
template <class T>
struct Case {
  Triangle triangle;
  Vec3<T> p;

  [[nodiscard]] std::string text() const {
    const auto& [a, b, c] = triangle;
    return described(std::array{a, b, c}) + " at " + described(p);
  }
};

template <class T>
Point as_corner(const Vec3<long double>& p) {  // triangles of a scene are double
  using Corner = std::conditional_t<(sizeof(T) > sizeof(double)), double, T>;
  return number_cast<double>(number_cast<Corner>(p));
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
  const Vec3<long double> along = thin.along_axis ? Vec3<long double>{1, 0, 0} : dice.direction();
  const Vec3<long double> across =
      (thin.along_axis ? Vec3<long double>{0, 0, 1} : dice.across(along)) *
      dice.power_of_ten(-thin.aspect, 0);
  // A cap's top is over its base, a needle's at its end.
  const long double foot = dice.once_in(2) ? dice.uniform(0, 1) : 1;
  const Vec3<long double> from = dice.direction() * (thin.along_axis ? 0.0L : dice.uniform(0, 1));
  const int size = dice.within(-thin.scale, thin.scale);
  const auto corner = [&](const Vec3<long double>& p) { return scaled(as_corner<T>(p), size); };
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
  return {triangle,
          scaled(number_cast<T>(from + along * (at_b + at_c * foot) + across * at_c), size)};
}

/// A triangle whose corners are equal or on a line: each a rounded multiple of one vector.
template <class T>
Triangle draw_flat(Dice& dice) {
  const Vec3<long double> along = dice.direction() * dice.power_of_ten(-6, 6);
  const auto corner = [&] {
    return as_corner<T>(along * (dice.once_in(3) ? 1.0L : dice.uniform(-4, 4)));
  };
  return {corner(), corner(), corner()};
}

/// Any shape, flat ones too.
template <class T>
Case<T> draw_any(Dice& dice, int scale) {
  Case<T> one = draw_thin<T>(dice, {.aspect = 20, .scale = scale});
  if (dice.once_in(3)) one.triangle = draw_flat<T>(dice);
  return one;
}

template <class T>
double weights_off(const Barycentric<T>& got, const Case<T>& one) {
  const Vec3<Digits50> a = exactly(one.triangle.a);
  const Vec3<Digits50> b = exactly(one.triangle.b);
  const Vec3<Digits50> c = exactly(one.triangle.c);
  const Vec3<Digits50> p = exactly(one.p);
  const Vec3<Digits50> n = cross(b - a, c - a);
  const Vec3<Digits50> exact =
      Vec3<Digits50>{dot(n, cross(b - p, c - p)), dot(n, cross(c - p, a - p)),
                     dot(n, cross(a - p, b - p))} *
      Digits50(1 / dot(n, n));
  // Far outside, weights are large; errors grow with them, and where p sees the sides as almost
  // one line also with the distance over the triangle's height.
  const Digits50 most = std::max(Digits50(1), largest(exact));
  const Digits50 longest = std::max({length(b - a), length(c - a), length(c - b)});
  const Digits50 reach_over_height = length(p - a) * longest / length(n);
  const Digits50 unit = roundoff<T>() * most * most * (1 + roundoff<T>() * reach_over_height);
  return std::max({units_off(got.a, exact.x, unit), units_off(got.b, exact.y, unit),
                   units_off(got.c, exact.z, unit)});
}

/// How far the weights are off. All lanes have the same case; the last one is checked.
template <class Real, class Function>
Measurement worst_weights(Function function, const Thin& thin) {
  using T = Scalar<Real>;
  return worst_over(1, [=](Dice& dice, Worst& worst) {
    const Case<T> one = draw_thin<T>(dice, thin);
    const Barycentric<Real> got = function(one.triangle, number_cast<Real>(one.p));
    const std::size_t k = lanes<Real> - 1;
    if (thin.farthest > 0 && lane(select(got.degenerate, Real(1), Real(0)), k) > 0) return;
    worst.see(weights_off<T>({lane(got.a, k), lane(got.b, k), lane(got.c, k), false}, one),
              [&] { return one.text(); });
  });
}

/// Cases as `draw(dice)` gives them that are `wrong`.
template <class Draw, class Wrong>
Measurement count_cases(Draw draw, Wrong wrong) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    const auto one = draw(dice);
    worst.see(wrong(one), [&] { return one.text(); });
  });
}

/// Other weights, or another verdict of being flat, with the corners in another order.
template <class T>
bool minds_the_order(const Case<T>& one) {
  const auto& [a, b, c] = one.triangle;
  const Barycentric<T> w = barycentric(one.triangle, one.p);
  const Barycentric<T> turned = barycentric<T>({b, c, a}, one.p);
  const Barycentric<T> mirrored = barycentric<T>({a, c, b}, one.p);
  if (w.degenerate) return !(turned.degenerate && mirrored.degenerate);
  return !(turned.a == w.b && turned.b == w.c && turned.c == w.a && mirrored.a == w.a &&
           mirrored.b == w.c && mirrored.c == w.b);
}

/// Weights that are no number, for any shape and any point.
template <class T, class Function>
Measurement count_nan(Function function) {
  return count_cases(
      [](Dice& dice) {
        Case<T> one = draw_any<T>(dice, 0);
        if (dice.once_in(3)) one.p = {dice.anything<T>(), dice.anything<T>(), dice.anything<T>()};
        return one;
      },
      [=](const Case<T>& one) {
        const Barycentric<T> got = function(one.triangle, one.p);
        return std::isnan(got.a) || std::isnan(got.b) || std::isnan(got.c);
      });
}

/// A ray that is aimed at a point of a triangle.
template <class T>
struct Aimed {
  Case<T> at;
  Ray<T> ray;

  [[nodiscard]] std::string text() const { return at.text() + " from " + described(ray.origin); }
};

/// How far the point at a crossing's distance is from the triangle's plane, in unit roundoffs of
/// corner + origin, in largest parts. `distance(space, seen)` is negative where nothing is met.
template <class T, class Distance>
Measurement worst_off_plane(Distance distance, const Thin& thin) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    const Case<T> at = draw_thin<T>(dice, thin);
    const Vec3<T> origin = number_cast<T>(dice.direction() * dice.power_of_ten(-1, 1));
    const Aimed<T> one{at, {origin, at.p - origin}};
    const RaySpace<T> space(one.ray);
    const std::array corners{at.triangle.a, at.triangle.b, at.triangle.c};
    std::array<Vec3<T>, 3> seen;
    for (std::size_t i = 0; i < 3; ++i) seen[i] = seen_along(space, number_cast<T>(corners[i]));
    const T got = distance(space, seen);
    if (got < T(0)) return;
    const auto [a, b, c] =
        std::array{exactly(corners[0]), exactly(corners[1]), exactly(corners[2])};
    const Vec3<Digits50> normal = cross(b - a, c - a);
    const Vec3<Digits50> there =
        exactly(one.ray.origin) + exactly(one.ray.direction) * Digits50(got) - a;
    const Digits50 size = std::max({largest(a), largest(b), largest(c)}) + largest(exactly(origin));
    worst.see(units_off(T(0), dot(normal, there) / length(normal), roundoff<T>() * size),
              [&] { return one.text(); });
  });
}

constexpr auto by_crossing = [](const auto& space, const auto& seen) {
  const auto found = crossing(space, seen[0], seen[1], seen[2]);
  return found.met ? found.distance : -found.distance / found.distance;
};
/// The textbook's areas, each a difference of two rounded products.
constexpr auto by_rounded_areas = [](const auto& space, const auto& seen) {
  if (by_crossing(space, seen) < 0) return by_crossing(space, seen);
  const auto area = [&](int i, int k) { return seen[i].x * seen[k].y - seen[i].y * seen[k].x; };
  const std::array at{area(1, 2), area(2, 0), area(0, 1)};
  return (at[0] * seen[0].z + at[1] * seen[1].z + at[2] * seen[2].z) / (at[0] + at[1] + at[2]) /
         space.direction.z;
};

/// A ray over a floor.
template <class T>
Ray<T> draw_downward(Dice& dice) {
  return {number_cast<T>(dice.direction() * dice.power_of_ten(-6, 6)),
          number_cast<T>(dice.direction() * dice.power_of_ten(-6, 6))};
}

template <class T>
Measurement worst_floor() {
  return worst_over(1, [](Dice& dice, Worst& worst) {
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
Measurement count_off_floor() {
  return worst_over(20, [](Dice& dice, Worst& worst) {
    const Floor floor{static_cast<double>(static_cast<float>(dice.uniform(-2, 2)))};
    const Ray<T> ray = draw_downward<T>(dice);
    const T distance = distance_to(floor, ray);
    worst.see(distance < infinity<T>() &&
                  point_on(floor, ray, distance).y != static_cast<T>(floor.height),
              [&] { return described(ray); });
  });
}

constexpr auto ours = [](const Triangle& triangle, const auto& p) {
  return barycentric(triangle, p);
};
constexpr auto heron = [](const Triangle& triangle, const auto& p) {
  return published::barycentric_heron(triangle, p);
};

template <class Real>
Thin thin_of() {
  return by_number<Real>(Thin{.aspect = 5, .scale = 60}, Thin{.aspect = 13, .scale = 900},
                         Thin{.aspect = 13, .scale = 900});
}
template <class Real>
std::string shapes() {
  return std::string("needles and caps at any angle, to ") +
         by_number<Real>("1e5", "1e13", "1e13") + " times longer than wide";
}
template <class Real>
std::string sized() {
  return shapes<Real>() + "; sides of " +
         by_number<Real>("1e-18 to 1e18", "1e-270 to 1e270", "1e-270 to 1e270");
}

}  // namespace

Family claims_of_triangles() {
  Family family{"Triangles and the floor",
                "Exact: areas along the normal in 50 digits. The last rows are areas as they "
                "round, and the areas by Heron's formula."};
  const Bound by_weight{3, "u (largest weight)^2"};
  const Bound far{10, "u (largest weight)^2 (1 + u distance / height)"};
  const char* off_plane = "u of corner + origin, in largest parts";
  const std::string any_shape = "triangles of any shape; points of anything the type can hold";
  for_each_number([&]<class Real>() {
    const Thin thin = thin_of<Real>();
    family.add<Real>("barycentric", sized<Real>() + "; points inside", by_weight,
                     worst_weights<Real>(ours, thin));
    family.add<Real>("barycentric, outside", shapes<Real>() + "; points to 1e4 sides outside", far,
                     worst_weights<Real>(ours, {.aspect = thin.aspect, .farthest = 4}));
    family.add<Real>("barycentric, outside of the thinnest",
                     "needles and caps along an axis, to u^-1.5 times longer than wide; points to "
                     "1e4 sides outside",
                     far,
                     worst_weights<Real>(ours, {.aspect = by_number<Real>(10.8L, 24.L, 24.L),
                                                .along_axis = true,
                                                .farthest = 4}));
  });
  for_each<float, double, long double>([&]<class T>() {
    const Thin thin = thin_of<T>();
    family.add<T>("barycentric, refused", sized<T>(), {0, "called degenerate"},
                  count_cases([=](Dice& dice) { return draw_thin<T>(dice, thin); },
                              [](auto& one) { return ours(one.triangle, one.p).degenerate; }));
    family.add<T>(
        "barycentric, order of the corners", "triangles of any shape, flat ones too; points inside",
        {0, "other weights, to the last digit"},
        count_cases([=](Dice& dice) { return draw_any<T>(dice, thin.scale); }, minds_the_order<T>));
    family.add<T>("barycentric, flat",
                  "corners equal or on a line through the origin, as nearly as they can be written",
                  {0, "not called degenerate"},
                  count_cases(
                      [](Dice& dice) {
                        const Triangle flat = draw_flat<T>(dice);
                        return Case<T>{flat, number_cast<T>(dice.direction())};
                      },
                      [](auto& one) { return !ours(one.triangle, one.p).degenerate; }));
    family.add<T>("barycentric, anything", any_shape, {0, "NaN"}, count_nan<T>(ours));
    family.add<T>("crossing, from the plane", shapes<T>() + "; origins of 0.1 to 10",
                  {28, off_plane}, worst_off_plane<T>(by_crossing, {.aspect = thin.aspect}));
    family.add<T>("distance_to a Floor", "heights, origins and directions of 1e-6 to 1e6",
                  {2, "ulp"}, worst_floor<T>());
    family.add<T>("point_on a Floor, height", "any ray that meets it",
                  {0, "not the floor's to the bit"}, count_off_floor<T>());
  });
  family.add_broken<float>("crossing by rounded areas", shapes<float>() + "; origins of 0.1 to 10",
                           {28, off_plane},
                           worst_off_plane<float>(by_rounded_areas, {.aspect = 5}));
  const std::string function = "weights by Heron's formula";
  family.add_broken<double>(
      function, "needles and caps at any angle, to 1e4 times longer than wide; points inside",
      by_weight, worst_weights<double>(heron, {.aspect = 4}));
  family.add_broken<float>(function, any_shape, {0, "NaN"}, count_nan<float>(heron));
  return family;
}

}  // namespace texmap::extremes
