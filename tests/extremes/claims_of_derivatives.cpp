// Claims of common/number/dual.hpp: derivatives of unchanged code, by two parameters.
#include <array>
#include <tuple>

#include "claims.hpp"
#include "number/dual.hpp"
#include "references.hpp"
#include "scene/sphere.hpp"
#include "texture/conventions.hpp"

namespace texmap::extremes {
namespace {

/// A point and how it moves for a step of each parameter.
template <class Real>
using Moving = std::array<Vec3<Real>, 3>;

template <class Real>
Vec3<Dual<Real>> dual_of(const Moving<Real>& p) {
  return {{p[0].x, p[1].x, p[2].x}, {p[0].y, p[1].y, p[2].y}, {p[0].z, p[1].z, p[2].z}};
}

/// Value and derivatives, as a vector that a lane can be taken of.
template <class Real>
Vec3<Real> parts(const Dual<Real>& x) {
  return {x.value, x.dx, x.dy};
}

/// A vector of any direction, or 1e-12 to 0.1 radians from a pole, or at the seam, and two steps
/// that are shorter than the vector. Lengths are 1e-15 to 1e15.
template <class T>
Moving<T> any_moving(Dice& dice) {
  Vec3<long double> p = dice.direction();
  if (dice.once_in(3)) {
    const long double sine = dice.power_of_ten(-12, -1);
    p = {p.x * sine, p.y < 0 ? -1.0L : 1.0L, p.z * sine};
  }
  if (dice.once_in(4)) p = {-std::abs(p.x), p.y, dice.once_in(2) ? 0 : p.z * 1e-9L};
  const int size = dice.within(-50, 50);
  const auto step = [&] {
    return scaled(number_cast<T>(dice.direction() * dice.power_of_ten(-6, 0)), size);
  };
  const Vec3<T> place = scaled(number_cast<T>(p), size);
  const Vec3<T> across = step();
  return {place, across, step()};
}

/// How far the derivatives of u and v are off, in unit roundoffs of the longest that a step of that
/// length can have. Exact: central differences, with steps so small that 50 digits see no curve.
template <class T>
double uv_gradient_off(const std::tuple<Vec3<T>, Vec3<T>>& got, const Moving<T>& at) {
  const auto& [u, v] = got;
  const Vec3<Digits50> p = exactly(at[0]);
  const Digits50 from_axis = sqrt(p.x * p.x + p.z * p.z);
  const auto one_step = [&](const Vec3<Digits50>& step, T by_u, T by_v) {
    const Digits50 small = Digits50("1e-18") * from_axis / length(step);
    const auto ahead = exact_uv(p + step * small);
    const auto behind = exact_uv(p - step * small);
    const Digits50 round = ahead.u - behind.u;
    const Digits50 along_u = round - floor(round + Digits50(0.5));  // perhaps over the seam
    const Digits50 unit = roundoff<T>() * length(step) / (2 * circle<Digits50>());
    return std::max(
        units_off(by_u, along_u / (2 * small), unit / from_axis),
        units_off(by_v, Digits50(ahead.v - behind.v) / (2 * small), 2 * unit / length(p)));
  };
  return std::max(one_step(exactly(at[1]), u.y, v.y), one_step(exactly(at[2]), u.z, v.z));
}

template <class Real>
Measurement worst_uv_gradient() {
  return worst_lanes<Real>(
      1, any_moving<Scalar<Real>>,
      [](const Moving<Real>& p) {
        const Uv<Dual<Real>> uv = uv_rtiow(dual_of(p));
        return std::tuple(parts(uv.u), parts(uv.v));
      },
      uv_gradient_off<Scalar<Real>>);
}

/// Whether the value differs from the plain number's, for the whole way from a ray to (u, v).
template <class Real>
Measurement value_differs() {
  using T = Scalar<Real>;
  const auto way = [](const auto& from) {
    const Sphere<> globe{.center = {0.25, 0, 0}, .radius = 1};
    using Number = std::remove_cvref_t<decltype(from.x)>;
    const Ray<Number> ray{from, normalize(from * Number(-1))};
    const Number distance = distance_to(globe, ray);
    const Uv<Number> uv = uv_of(Convention::lecture, normal_at(globe, ray, distance));
    return std::tuple(distance, uv.u, uv.v);
  };
  return count_lanes<Real>(
      1,
      [](Dice& dice) {
        return Moving<T>{number_cast<T>(dice.direction() * dice.power_of_ten(0.3L, 2)),
                         number_cast<T>(dice.direction()), number_cast<T>(dice.direction())};
      },
      [way](const Moving<Real>& p) {
        const auto [distance, u, v] = way(dual_of(p));
        const auto [plain_distance, plain_u, plain_v] = way(p[0]);
        return !(distance.value == plain_distance && u.value == plain_u && v.value == plain_v);
      });
}

/// A camera's ray at a unit sphere, 1.5 to 20 radii away, within 0.9 radii of its center.
template <class T>
Moving<T> any_look(Dice& dice) {
  const Vec3<long double> towards = dice.direction();
  const Vec3<long double> beside = dice.across(towards) * dice.uniform(0, 0.9L);
  const Vec3<long double> eye = towards * dice.uniform(1.5L, 20);
  const Vec3<T> direction = number_cast<T>(beside - eye);
  return {number_cast<T>(eye), direction, number_cast<T>(dice.across(towards) * 0.01L)};
}

/// The distance's derivative by a parameter that moves the direction.
template <class Real>
Measurement worst_distance_gradient() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1, any_look<T>,
      [](const Moving<Real>& look) {
        const Ray<Dual<Real>> ray{dual_of(Moving<Real>{look[0]}),
                                  dual_of(Moving<Real>{look[1], look[2]})};
        return parts(distance_to(Sphere<>{}, ray));
      },
      [](const Vec3<T>& got, const Moving<T>& look) {
        const Vec3<Digits50> step = exactly(look[2]);
        const Digits50 small("1e-18");
        const auto at = [&](const Digits50& t) {
          return exact_meeting(exactly(look[0]), exactly(look[1]) + step * t, Digits50(1)).distance;
        };
        const Digits50 slope = (at(small) - at(-small)) / (2 * small);
        return units_off(got.y, slope, roundoff<T>() * length(step) * length(exactly(look[0])));
      });
}

/// What a hand-made difference of plain numbers is off: the way without duals.
template <class T>
Measurement worst_plain_difference() {
  return worst_lanes<T>(
      1, any_moving<T>,
      [](const Moving<T>& p) {
        const T small = std::sqrt(std::numeric_limits<T>::epsilon());
        const Uv<T> here = uv_rtiow(p[0]);
        const Uv<T> across = uv_rtiow(p[0] + p[1] * small);
        const Uv<T> down = uv_rtiow(p[0] + p[2] * small);
        return std::tuple(Vec3<T>{T(0), (across.u - here.u) / small, (down.u - here.u) / small},
                          Vec3<T>{T(0), (across.v - here.v) / small, (down.v - here.v) / small});
      },
      uv_gradient_off<T>);
}

/// True where du/dx at the seam is not the limit from either side.
template <class Real>
Measurement jumps_at_seam() {
  using T = Scalar<Real>;
  return count_lanes<Real>(
      1,
      [](Dice& dice) {
        return Vec3<T>{static_cast<T>(-dice.power_of_ten(-3, 3)),
                       static_cast<T>(dice.uniform(-2, 2)), T(0)};
      },
      [](const Vec3<Real>& p) {
        const auto slope = [&](const Real& z, Convention convention) {
          const Real one(1), zero(0);
          return uv_of(convention,
                       Vec3<Dual<Real>>{{p.x, zero, zero}, {p.y, zero, one}, {z, one, zero}});
        };
        const auto close = [](const Real& a, const Real& b) {
          return abs(a - b) <= Real(16) * unit_roundoff<Real>() * abs(b);
        };
        Mask<Real> smooth = mask_of<Real>(true);
        const Real aside = p.x * unit_roundoff<Real>() * Real(0.0625);
        for (const Convention convention :
             {Convention::daily, Convention::rtiow, Convention::lecture}) {
          const Uv<Dual<Real>> on = slope(p.z, convention);
          for (const Real& z : {-p.z, aside, -aside}) {
            const Uv<Dual<Real>> near = slope(z, convention);
            smooth = smooth && close(near.u.dx, on.u.dx) && close(near.v.dy, on.v.dy) &&
                     !(on.u.dx == Real(0));
          }
        }
        return !smooth;
      });
}

}  // namespace

Family claims_of_derivatives() {
  Family family{"Derivatives",
                "Dual numbers run through unchanged mappings. Errors in unit roundoffs of the "
                "steepest slope that a step of that length can have there. Exact: central "
                "differences with steps of 1e-18 in 50 digits."};
  for_each_number([&]<class Real>() {
    family.add<Real>("Dual, value", "rays at a sphere from 2 to 100 radii, through to (u, v)",
                     {0, "values other than the plain number's"}, value_differs<Real>());
    family.add<Real>("Dual, uv_rtiow",
                     "vectors of length 1e-15 to 1e15, 1e-12 rad from a pole and farther, the seam",
                     {16, "u"}, worst_uv_gradient<Real>());
    family.add<Real>("Dual, distance_to", "1.5 to 20 radii away, within 0.9 radii of the center",
                     {6, "u"}, worst_distance_gradient<Real>());
    family.add<Real>("Dual, seam", "directions at -x in every convention, and 2^-28 u away",
                     {0, "jumps of the slope"}, jumps_at_seam<Real>());
  });
  for_each<float, double>([&]<class T>() {
    family.add_broken<T>("one-sided difference of plain numbers", "as Dual, uv_rtiow", {16, "u"},
                         worst_plain_difference<T>());
  });
  return family;
}

}  // namespace texmap::extremes
