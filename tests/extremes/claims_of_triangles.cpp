// Claims of common/scene/edge_function.hpp and floor.hpp: weights in a triangle, and the floor.
#include "claims.hpp"
#include "published/triangle.hpp"
#include "scene/edge_function.hpp"
#include "scene/floor.hpp"

namespace texmap::extremes {
namespace {

/// A ray that is aimed at a point of a triangle with corners that every number holds.
template <class T>
struct Case {
  std::array<Point, 3> corners;
  Vec3<T> p;
  Vec3<T> origin;

  [[nodiscard]] std::string text() const {
    return described(corners) + " at " + described(p) + " from " + described(origin);
  }
};

template <class T>
Point as_corner(const Vec3<long double>& p) {  // triangles of a scene are double
  using Corner = std::conditional_t<(sizeof(T) > sizeof(double)), double, T>;
  return number_cast<double>(number_cast<Corner>(p));
}

/// Needles and caps at any angle, up to 10^aspect times longer than wide.
template <class T>
Case<T> draw_thin(Dice& dice, long double aspect) {
  const Vec3<long double> along = dice.direction();
  const Vec3<long double> across = dice.across(along) * dice.power_of_ten(-aspect, 0);
  // A cap's top is over its base, a needle's at its end.
  const long double foot = dice.once_in(2) ? dice.uniform(0, 1) : 1;
  const Vec3<long double> from = dice.direction() * dice.uniform(0, 1);
  long double at_b = dice.uniform(0, 1);
  long double at_c = dice.uniform(0, 1);
  if (at_b + at_c > 1) {
    at_b = 1 - at_b;
    at_c = 1 - at_c;
  }
  return {
      {as_corner<T>(from), as_corner<T>(from + along), as_corner<T>(from + along * foot + across)},
      number_cast<T>(from + along * (at_b + at_c * foot) + across * at_c),
      number_cast<T>(dice.direction() * dice.power_of_ten(-1, 1))};
}

/// The worst of `off(found, one, seen)` where `find(space, seen)` meets a triangle.
template <class T, class Find, class Off>
Measurement worst_crossing(Find find, Off off, long double aspect) {
  return worst_over(16, [=](Dice& dice, Worst& worst) {
    const Case<T> one = draw_thin<T>(dice, aspect);
    const RaySpace<T> space(Ray<T>{one.origin, one.p - one.origin});
    std::array<Vec3<T>, 3> seen;
    for (std::size_t i = 0; i < 3; ++i) seen[i] = seen_along(space, number_cast<T>(one.corners[i]));
    const Crossing<T> found = find(space, seen);
    if (found.met) worst.see(off(found, one, seen), [&] { return one.text(); });
  });
}

/// How far the point at `distance` is from the triangle's plane, in unit roundoffs of corner +
/// origin, in largest parts.
constexpr auto from_the_plane = []<class T>(const Crossing<T>& found, const Case<T>& one,
                                            const auto& /*seen*/) {
  const Vec3<Digits50> a = exactly(one.corners[0]), b = exactly(one.corners[1]);
  const Vec3<Digits50> c = exactly(one.corners[2]), origin = exactly(one.origin);
  const Vec3<Digits50> normal = cross(b - a, c - a);
  const Vec3<Digits50> direction = exactly(one.p - one.origin);
  const Digits50 off = dot(normal, origin + direction * Digits50(found.distance) - a);
  const Digits50 size = std::max({largest(a), largest(b), largest(c)}) + largest(origin);
  return units_off(T(0), off / length(normal), roundoff<T>() * size);
};
/// How far the weights are from those of the places where the ray sees the corners.
constexpr auto from_the_areas = []<class T>(const Crossing<T>& found, const Case<T>& /*one*/,
                                            const std::array<Vec3<T>, 3>& seen) {
  const auto area = [&](std::size_t i, std::size_t k) {
    return Digits50(seen[i].x) * seen[k].y - Digits50(seen[i].y) * seen[k].x;
  };
  const Vec3<Digits50> exact = Vec3<Digits50>{area(1, 2), area(2, 0), area(0, 1)} *
                               (1 / (area(1, 2) + area(2, 0) + area(0, 1)));
  const Vec3<Digits50> off = exactly(Vec3<T>{found.a, found.b, found.c}) - exact;
  return static_cast<double>(largest(off) / roundoff<T>());
};

constexpr auto ours = []<class T>(const RaySpace<T>& space, const std::array<Vec3<T>, 3>& seen) {
  return crossing(space, seen[0], seen[1], seen[2]);
};
/// The textbook's areas, each a difference of two rounded products.
constexpr auto rounded = []<class T>(const RaySpace<T>& space, const std::array<Vec3<T>, 3>& seen) {
  Crossing<T> found = ours(space, seen);
  const auto& [a, b, c] = seen;
  const Vec3<T> at{b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x};
  const T whole = at.x + at.y + at.z;
  found.a = at.x / whole;
  found.b = at.y / whole;
  found.c = at.z / whole;
  found.distance = (found.a * a.z + found.b * b.z + found.c * c.z) / space.direction.z;
  return found;
};

/// How often Heron's weights of a point inside are no numbers.
template <class T>
Measurement count_nan_of_heron(long double aspect) {
  return worst_over(4, [=](Dice& dice, Worst& worst) {
    const Case<T> one = draw_thin<T>(dice, aspect);
    const auto corner = [&](std::size_t i) { return number_cast<T>(one.corners[i]); };
    const auto got = published::barycentric_heron(corner(0), corner(1), corner(2), one.p);
    worst.see(std::isnan(got.a) || std::isnan(got.b) || std::isnan(got.c),
              [&] { return one.text(); });
  });
}

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

/// Powers of ten: how many times longer than wide the triangles are.
template <class T>
constexpr long double aspect = std::is_same_v<T, float> ? 5 : 13;
template <class T>
std::string shapes() {
  return std::string("needles and caps at any angle, to ") + by_number<T>("1e5", "1e13", "1e13") +
         " times longer than wide; origins of 0.1 to 10";
}

}  // namespace

Family claims_of_triangles() {
  Family family{"Triangles and the floor",
                "Exact: areas in 50 digits. The last rows are areas as they round, and those by "
                "Heron's formula."};
  const Bound off_plane{34, "u of corner + origin, in largest parts"};
  const Bound off_areas{10, "u"};
  for_each<float, double, long double>([&]<class T>() {
    family.add<T>("crossing, from the plane", shapes<T>(), off_plane,
                  worst_crossing<T>(ours, from_the_plane, aspect<T>));
    family.add<T>("crossing, weights of the corners as seen", shapes<T>(), off_areas,
                  worst_crossing<T>(ours, from_the_areas, aspect<T>));
    family.add<T>("distance_to a Floor", "heights, origins and directions of 1e-6 to 1e6",
                  {2, "ulp"}, worst_floor<T>());
    family.add<T>("point_on a Floor, height", "any ray that meets it",
                  {0, "not the floor's to the bit"}, count_off_floor<T>());
  });
  const char* by_rounded = "crossing by rounded areas";
  family.add_broken<float>(by_rounded, shapes<float>(), off_plane,
                           worst_crossing<float>(rounded, from_the_plane, aspect<float>));
  family.add_broken<double>(by_rounded, shapes<double>(), off_areas,
                            worst_crossing<double>(rounded, from_the_areas, aspect<double>));
  family.add_broken<float>("weights by Heron's formula", shapes<float>(), {0, "NaN"},
                           count_nan_of_heron<float>(aspect<float>));
  return family;
}

}  // namespace texmap::extremes
