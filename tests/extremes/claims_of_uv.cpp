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
  Vec3<T> p = rounded<T>(
      {sine * std::cos(turn), dice.sign() * std::sqrt(1 - sine * sine), sine * std::sin(turn)});
  for (int steps = dice.below(5); steps > 0; --steps) {
    p.y = std::nextafter(p.y, static_cast<T>(dice.sign()) * std::numeric_limits<T>::max());
  }
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
  for (;;) {
    Vec3<T> p;
    switch (dice.below(4)) {
      case 0:
        p = {dice.finite<T>(), dice.finite<T>(), dice.finite<T>()};
        break;
      case 1:
        p = scaled(rounded<T>(dice.direction()),
                   dice.within(Limits::min_exponent - 8, Limits::max_exponent - 1));
        break;
      case 2:
        p = scaled(near_pole<T>(dice, -8, -1), dice.within(-20, 20));
        break;
      default:
        p = near_seam<T>(dice);
    }
    if (p.x != 0 || p.y != 0 || p.z != 0) return p;
  }
}

/// The exact (u, v) in a convention, from that in rtiow.
ExactUv<Digits50> in_convention(Convention convention, const ExactUv<Digits50>& uv) {
  if (convention == Convention::daily) return {1 - uv.u, 1 - uv.v};
  if (convention == Convention::lecture)
    return {uv.u < 0.25 ? Digits50(uv.u + 0.75) : Digits50(uv.u - 0.25), uv.v};
  return uv;
}

/// A mapping's error in texels of a map of 8192 by 4096: the larger of u (around the circle) and v.
template <class T>
double texels_off(const Uv<T>& got, const Vec3<T>& p, Convention convention) {
  if (!std::isfinite(got.u) || !std::isfinite(got.v))
    return std::numeric_limits<double>::infinity();
  const ExactUv<Digits50> exact = in_convention(convention, exact_uv(exactly(p)));
  // On the axis every u is right.
  const double u =
      p.x == 0 && p.z == 0 ? 0 : static_cast<double>(around(Digits50(got.u), exact.u) * 8192);
  return std::max(u, static_cast<double>(abs(got.v - exact.v) * 4096));
}

template <class Real, class Mapping, class Draw>
auto worst_place(Mapping mapping, Convention convention, Draw draw) {
  using T = Scalar<Real>;
  return worst_lanes<Real>(draw, mapping, [convention](const Uv<T>& got, const Vec3<T>& p) {
    return texels_off(got, p, convention);
  });
}

/// Vectors that have no place in [0, 1) x [0, 1], of all that can be written down.
template <class Real, class Mapping, class Draw>
auto count_outside(Mapping mapping, Draw draw) {
  using T = Scalar<Real>;
  return worst_lanes<Real>(8, draw, mapping, [](const Uv<T>& uv, const Vec3<T>&) {
    return !(uv.u >= 0 && uv.u < 1 && uv.v >= 0 && uv.v <= 1);
  });
}

/// Vectors with a zero coordinate that get another place when the zero changes its sign.
template <class Real>
auto count_signs_of_zero() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      [](Dice& dice) {
        const auto coordinate = [&] {
          return dice.once_in(2) ? T(0) : static_cast<T>(dice.uniform(-1, 1));
        };
        return Vec3<T>{coordinate(), coordinate(), coordinate()};
      },
      [](const Vec3<Real>& p) {
        const auto negated = [](const Real& x) { return select(x == Real(0), -x, x); };
        std::array<Real, 8> places;
        std::size_t i = 0;
        for (const Vec3<Real>& q :
             {p, Vec3<Real>{negated(p.x), p.y, p.z}, Vec3<Real>{p.x, negated(p.y), p.z},
              Vec3<Real>{p.x, p.y, negated(p.z)}}) {
          const Uv<Real> uv = uv_rtiow(q);
          places[i++] = uv.u;
          places[i++] = uv.v;
        }
        return places;
      },
      [](const std::array<T, 8>& places, const Vec3<T>&) {
        for (std::size_t i = 2; i < 8; ++i) {
          if (places[i] != places[i % 2]) return true;
        }
        return false;
      });
}

/// v near the lower pole, in its own units: it must shrink with the angle and keep all its digits.
template <class Real>
auto worst_at_pole() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
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

/// A program that adds up the u and v of directions.
template <class Real, class Mapping>
auto adding_up(Mapping mapping) {
  return working_through(inputs_of_cost<Real>(drawn_direction<Real>),
                         [mapping](const Vec3<Real>& p) {
                           const Uv<Real> uv = mapping(p);
                           return uv.u + uv.v;
                         });
}

/// @param place  the bound of uv_rtiow and of the conventions made from it, in texels
/// @param pole   that near the pole, in ulp
template <class Real>
void add_number(Family& family, double place, double pole) {
  using T = Scalar<Real>;
  const std::string anything = "anything the type can hold, infinities and NaN too";
  const Bound inside{0, "outside u in [0, 1), v in [0, 1]"};
  const auto any_three = [](Dice& dice) {
    return Vec3<T>{dice.anything<T>(), dice.anything<T>(), dice.anything<T>()};
  };
  family
      .add<Real>("uv_rtiow",
                 "any finite vector but zero, of any length, each coordinate with any exponent, "
                 "subnormal too; poles; both sides of the seam",
                 {place, "texel"}, worst_place<Real>(rtiow, Convention::rtiow, any_vector<T>))
      .cost = {"Next Week's acos form, double", adding_up<Real>(rtiow),
               adding_up<double>(next_week)};
  family.add<Real>("uv_rtiow, v near the lower pole",
                   "1e-30 to 0.1 rad from -y, length off 1 by up to 4 numbers", {pole, "ulp"},
                   worst_at_pole<Real>());
  family.add<Real>("uv_rtiow, range", anything, inside, count_outside<Real>(rtiow, any_three));
  family.add<Real>("uv_rtiow, sign of zero",
                   "vectors on an axis or in a plane of two, the zero vector too",
                   {0, "elsewhere for -0 than for 0"}, count_signs_of_zero<Real>());
  for (const Convention convention : {Convention::daily, Convention::lecture}) {
    const std::string name = convention == Convention::daily ? "uv_of, daily" : "uv_of, lecture";
    const auto mapping = [convention](const auto& p) { return uv_of(convention, p); };
    family.add<Real>(name, "as uv_rtiow", {place, "texel"},
                     worst_place<Real>(mapping, convention, any_vector<T>));
    family.add<Real>(name + ", range", anything, inside, count_outside<Real>(mapping, any_three));
  }
}

/// What the published form does where ours keeps its bound.
template <class T>
void add_published(Family& family, double bound) {
  const auto poles = [](Dice& dice) { return near_pole<T>(dice, -8, -1); };
  const auto without_nan = [](const auto& p) {  // the library clamp that the textbooks add
    return published::uv_next_week_v4(Vec3<T>{p.x, clamp(p.y, T(-1), T(1)), p.z});
  };
  family
      .add<T>("Next Week's v by acos, clamped", "1e-8 to 0.1 rad from a pole", {bound, "texel"},
              worst_place<T>(without_nan, Convention::rtiow, poles))
      .expect = Expect::beyond;
  family
      .add<T>("Next Week's v by acos, range",
              "1e-8 to 0.1 rad from a pole, length off 1 by up to 4 numbers",
              {0, "outside u in [0, 1), v in [0, 1]"}, count_outside<T>(next_week, poles))
      .expect = Expect::beyond;
}

}  // namespace

Family claims_of_uv() {
  Family family{"Texture coordinates",
                "Errors in texels of a map of 8192 by 4096, on u measured round the circle. Exact: "
                "the angles by atan2 in 50 digits; checked against the inverse cosine in 100."};
  add_number<float>(family, 1e-3, 5);
  add_number<double>(family, 2e-12, 5);
  add_number<long double>(family, 1e-15, 5);
  add_number<Pack<float>>(family, 1e-3, 5);
  add_number<Pack<double>>(family, 2e-12, 5);
  add_published<float>(family, 1e-3);
  add_published<double>(family, 2e-12);
  return family;
}

}  // namespace texmap::extremes
