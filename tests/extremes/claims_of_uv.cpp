// Claims of common/texture/uv.hpp and conventions.hpp: (u, v) of a direction.
#include "claims.hpp"
#include "published/uv.hpp"
#include "references.hpp"
#include "texture/conventions.hpp"
#include "texture/uv.hpp"

namespace texmap::extremes {
namespace {

/// A vector 10^`least` to 10^`most` radians from a pole; its length is a few numbers off 1.
template <class T>
Vec3<T> near_pole(Dice& dice, long double least, long double most) {
  const long double sine = dice.power_of_ten(least, most);
  const long double turn = dice.uniform(0, 6.283185307179586L);
  Vec3<T> p = number_cast<T>(Vec3<long double>{
      sine * std::cos(turn), dice.sign() * std::sqrt(1 - sine * sine), sine * std::sin(turn)});
  for (int steps = dice.below(5); steps > 0; --steps)
    p.y = std::nextafter(p.y, static_cast<T>(dice.sign()) * std::numeric_limits<T>::max());
  return p;
}

/// A vector just before or behind the seam at -x, or on it with either sign of zero.
template <class T>
Vec3<T> near_seam(Dice& dice) {
  using Limits = std::numeric_limits<T>;
  const T size = dice.once_in(8) ? T(0) : dice.number<T>(Limits::min_exponent - Limits::digits, 0);
  return {-dice.number<T>(-2, 2), static_cast<T>(dice.uniform(-1, 1)),
          static_cast<T>(dice.sign()) * size};
}

/// Any finite vector but zero, with the hard ones often.
template <class T>
Vec3<T> any_vector(Dice& dice) {
  using Limits = std::numeric_limits<T>;
  const auto any = [&dice]() -> Vec3<T> {
    const int kind = dice.below(4);
    if (kind == 0) return {dice.finite<T>(), dice.finite<T>(), dice.finite<T>()};
    if (kind == 1)
      return scaled(number_cast<T>(dice.direction()),
                    dice.within(Limits::min_exponent - 8, Limits::max_exponent - 1));
    if (kind == 2) return scaled(near_pole<T>(dice, -8, -1), dice.within(-20, 20));
    return near_seam<T>(dice);
  };
  Vec3<T> p = any();
  while (p.x == 0 && p.y == 0 && p.z == 0) p = any();
  return p;
}
template <class T>
Vec3<T> anything(Dice& dice) {
  return {dice.anything<T>(), dice.anything<T>(), dice.anything<T>()};
}

/// The exact (u, v) in a convention, from that in rtiow.
Uv<Digits50> in_convention(Convention convention, const Uv<Digits50>& uv) {
  if (convention == Convention::daily) return {1 - uv.u, 1 - uv.v};
  if (convention == Convention::lecture)
    return {uv.u < 0.25 ? Digits50(uv.u + 0.75) : Digits50(uv.u - 0.25), uv.v};
  return uv;
}

/// A mapping's error in texels of a map of 8192 by 4096: the larger of u (around the circle) and v.
template <class Real, class Mapping, class Draw>
auto worst_place(Mapping mapping, Convention convention, Draw draw) {
  using T = Scalar<Real>;
  return worst_lanes<Real>(1, draw, mapping, [convention](const Uv<T>& got, const Vec3<T>& p) {
    if (!std::isfinite(got.u) || !std::isfinite(got.v)) return infinity<double>();
    const Uv<Digits50> exact = in_convention(convention, exact_uv(exactly(p)));
    // On the axis every u is right.
    const double u =
        p.x == 0 && p.z == 0 ? 0 : static_cast<double>(around(Digits50(got.u), exact.u) * 8192);
    return std::max(u, static_cast<double>(abs(got.v - exact.v) * 4096));
  });
}

/// Vectors that have no place in [0, 1) x [0, 1].
template <class Real, class Mapping, class Draw>
auto count_outside(Mapping mapping, Draw draw) {
  return count_lanes<Real>(8, draw, [mapping](const Vec3<Real>& p) {
    const Uv<Real> uv = mapping(p);
    return !(uv.u >= Real(0) && uv.u < Real(1) && uv.v >= Real(0) && uv.v <= Real(1));
  });
}

/// Vectors with a zero coordinate that get another place when the zero changes its sign.
template <class Real>
auto count_signs_of_zero() {
  using T = Scalar<Real>;
  return count_lanes<Real>(
      1,
      [](Dice& dice) {
        const auto coordinate = [&] {
          return dice.once_in(2) ? T(0) : static_cast<T>(dice.uniform(-1, 1));
        };
        return Vec3<T>{coordinate(), coordinate(), coordinate()};
      },
      [](const Vec3<Real>& p) {
        const auto negated = [](const Real& x) { return select(x == Real(0), -x, x); };
        const Uv<Real> uv = uv_rtiow(p);
        Mask<Real> same = mask_of<Real>(true);
        for (const Vec3<Real>& q :
             {Vec3<Real>{negated(p.x), p.y, p.z}, Vec3<Real>{p.x, negated(p.y), p.z},
              Vec3<Real>{p.x, p.y, negated(p.z)}})
          same = same && uv_rtiow(q).u == uv.u && uv_rtiow(q).v == uv.v;
        return !same;
      });
}

/// v near the lower pole, in its own units: it must shrink with the angle and keep all its digits.
template <class Real>
auto worst_at_pole() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        Vec3<T> p = near_pole<T>(dice, -30, -1);
        p.y = -abs(p.y);
        return p;
      },
      [](const Vec3<Real>& p) { return uv_rtiow(p); },
      [](const Uv<T>& uv, const Vec3<T>& p) { return ulps_off(uv.v, exact_uv(exactly(p)).v); });
}

constexpr auto rtiow = [](const auto& p) { return uv_rtiow(p); };
constexpr auto next_week = [](const auto& p) { return published::uv_next_week_v4(p); };

}  // namespace

Family claims_of_uv() {
  Family family{"Texture coordinates",
                "Errors in texels of a map of 8192 by 4096, on u measured round the circle. Exact: "
                "the angles by atan2 in 50 digits."};
  const Bound inside{0, "outside u in [0, 1), v in [0, 1]"};
  for_each_number([&]<class Real>() {
    using T = Scalar<Real>;
    const Bound place{by_number<Real>(1e-3, 2e-12, 1e-15), "texel"};
    const std::string all = "anything the type can hold, infinities and NaN too";
    family.add<Real>("uv_rtiow",
                     "any finite vector but zero, of any length, each coordinate with any "
                     "exponent, subnormal too; poles; both sides of the seam",
                     place, worst_place<Real>(rtiow, Convention::rtiow, any_vector<T>));
    family.add<Real>("uv_rtiow, v near the lower pole",
                     "1e-30 to 0.1 rad from -y, length off 1 by up to 4 numbers", {5, "ulp"},
                     worst_at_pole<Real>());
    family.add<Real>("uv_rtiow, range", all, inside, count_outside<Real>(rtiow, anything<T>));
    family.add<Real>("uv_rtiow, sign of zero",
                     "vectors on an axis or in a plane of two, the zero vector too",
                     {0, "elsewhere for -0 than for 0"}, count_signs_of_zero<Real>());
    for (const Convention convention : {Convention::daily, Convention::lecture}) {
      const std::string name = convention == Convention::daily ? "uv_of, daily" : "uv_of, lecture";
      const auto mapping = [convention](const auto& p) { return uv_of(convention, p); };
      family.add<Real>(name, "as uv_rtiow", place,
                       worst_place<Real>(mapping, convention, any_vector<T>));
      family.add<Real>(name + ", range", all, inside, count_outside<Real>(mapping, anything<T>));
    }
  });
  for_each<float, double>([&]<class T>() {
    const auto poles = [](Dice& dice) { return near_pole<T>(dice, -8, -1); };
    const auto without_nan = [](const auto& p) {  // the library clamp that the textbooks add
      return published::uv_next_week_v4(Vec3<T>{p.x, clamp(p.y, T(-1), T(1)), p.z});
    };
    family.add_broken<T>("Next Week's v by acos, clamped", "1e-8 to 0.1 rad from a pole",
                         {by_number<T>(1e-3, 2e-12, 0.0), "texel"},
                         worst_place<T>(without_nan, Convention::rtiow, poles));
    family.add_broken<T>("Next Week's v by acos, range",
                         "1e-8 to 0.1 rad from a pole, length off 1 by up to 4 numbers", inside,
                         count_outside<T>(next_week, poles));
  });
  return family;
}

}  // namespace texmap::extremes
