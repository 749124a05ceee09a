// Claims of common/texture/uv.hpp and conventions.hpp: (u, v) of a direction.
#include "claims.hpp"
#include "conventions.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "references.hpp"
#include "seed_formulas.hpp"
#include "uv.hpp"

namespace texmap::extremes {
namespace {

/// A vector within `least` to `most` radians (as powers of ten) of a pole, its length a few numbers off 1.
template <class T>
Vec3<T> near_pole(Dice& dice, long double least, long double most) {
  const long double sine = dice.power_of_ten(least, most);
  const long double turn = dice.uniform(0, 6.283185307179586L);
  Vec3<T> p = rounded<T>({sine * std::cos(turn), dice.sign() * std::sqrt(1 - sine * sine), sine * std::sin(turn)});
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
  return {-dice.number<T>(-2, 2), static_cast<T>(dice.uniform(-1, 1)), static_cast<T>(dice.sign()) * size};
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
        p = scaled(rounded<T>(dice.direction()), dice.within(Limits::min_exponent - 8, Limits::max_exponent - 1));
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
  if (convention == Convention::lecture) return {uv.u < 0.25 ? Digits50(uv.u + 0.75) : Digits50(uv.u - 0.25), uv.v};
  return uv;
}

/// How a mapping's (u, v) differs from the exact one, in texels of a map of 8192 by 4096: the worse of u (round the circle) and
/// v.
template <class T>
double texels_off(const Uv<T>& got, const Vec3<T>& p, Convention convention) {
  if (!std::isfinite(got.u) || !std::isfinite(got.v)) return std::numeric_limits<double>::infinity();
  const ExactUv<Digits50> exact = in_convention(convention, exact_uv(exactly<Digits50>(p)));
  // On the axis every u is right.
  const double u = p.x == 0 && p.z == 0 ? 0 : static_cast<double>(around(Digits50(got.u), exact.u) * 8192);
  return std::max(u, static_cast<double>(abs(got.v - exact.v) * 4096));
}

template <class Real, class Mapping, class Draw>
auto worst_place(Mapping mapping, Convention convention, Draw draw) {
  return worst_over([=](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] { return draw(dice); });
    const Uv<Real> uv = mapping(gathered<Real>(each));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Uv<Scalar<Real>> got{lane(uv.u, k), lane(uv.v, k)};
      worst.see(texels_off(got, each[k], convention), [&] { return described(each[k]); });
    }
  });
}

/// Vectors that have no place in [0, 1) x [0, 1], of all that can be written down.
template <class Real, class Mapping, class Draw>
auto count_outside(Mapping mapping, Draw draw) {
  return worst_over(8, [=](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] { return draw(dice); });
    const Uv<Real> uv = mapping(gathered<Real>(each));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const bool inside = lane(uv.u, k) >= 0 && lane(uv.u, k) < 1 && lane(uv.v, k) >= 0 && lane(uv.v, k) <= 1;
      worst.count(!inside, [&] { return described(each[k]); });
    }
  });
}

/// Vectors on an axis or in a plane of two that lie elsewhere when a zero among their coordinates changes its sign.
template <class Real>
auto count_signs_of_zero() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] {
      const auto coordinate = [&] { return dice.once_in(2) ? T(0) : static_cast<T>(dice.uniform(-1, 1)); };
      return Vec3<T>{coordinate(), coordinate(), coordinate()};
    });
    const Vec3<Real> p = gathered<Real>(each);
    const Uv<Real> uv = uv_rtiow(p);
    const auto negated = [](const Real& x) { return select(x == Real(0), -x, x); };
    for (const Vec3<Real>& q :
         {Vec3<Real>{negated(p.x), p.y, p.z}, Vec3<Real>{p.x, negated(p.y), p.z}, Vec3<Real>{p.x, p.y, negated(p.z)}}) {
      const Uv<Real> other = uv_rtiow(q);
      for (std::size_t k = 0; k < lanes<Real>; ++k) {
        worst.count(lane(uv.u, k) != lane(other.u, k) || lane(uv.v, k) != lane(other.v, k), [&] { return described(each[k]); });
      }
    }
  });
}

/// v beside the lower pole, in its own units: it must shrink with the angle and keep all its digits.
template <class Real>
auto worst_at_pole() {
  return worst_over([](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] {
      Vec3<Scalar<Real>> p = near_pole<Scalar<Real>>(dice, -30, -1);
      p.y = -abs(p.y);
      return p;
    });
    const Uv<Real> uv = uv_rtiow(gathered<Real>(each));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Digits50 exact = exact_uv(exactly<Digits50>(each[k])).v;
      worst.see(ulps_off(lane(uv.v, k), exact), [&] { return described(each[k]); });
    }
  });
}

struct Bounds {
  double place;       ///< texels
  double convention;  ///< texels, in the conventions made from rtiow
  double pole;        ///< ulp
};

template <class Real>
void add_number(std::vector<Claim>& claims, const Bounds& bounds) {
  using T = Scalar<Real>;
  const auto vectors = [](Dice& dice) { return any_vector<T>(dice); };
  const auto rtiow = [](const auto& p) { return uv_rtiow(p); };
  const Cost cost{"seed 2's acos form, double",
                  working_through(inputs_of_cost<Real>(drawn_direction<Real>),
                                  [](const Vec3<Real>& p) {
                                    const Uv<Real> uv = uv_rtiow(p);
                                    return uv.u + uv.v;
                                  }),
                  working_through(inputs_of_cost<double>(drawn_direction<double>), [](const Vec3<double>& p) {
                    const Uv<double> uv = seeds::uv_next_week_v4(p);
                    return uv.u + uv.v;
                  })};
  claims.push_back({.function = "uv_rtiow",
                    .number = name_of<Real>,
                    .domain = "any finite vector but zero, of any length, each coordinate with any exponent, subnormal too; "
                              "poles; both sides of the seam",
                    .bound = bounds.place,
                    .unit = "texel",
                    .worst = worst_place<Real>(rtiow, Convention::rtiow, vectors),
                    .cost = cost});
  claims.push_back({.function = "uv_rtiow, v beside the lower pole",
                    .number = name_of<Real>,
                    .domain = "1e-30 to 0.1 rad from -y, length off 1 by up to 4 numbers",
                    .bound = bounds.pole,
                    .unit = "ulp",
                    .worst = worst_at_pole<Real>()});
  claims.push_back({.function = "uv_rtiow, range",
                    .number = name_of<Real>,
                    .domain = "anything the type can hold, infinities and NaN too",
                    .unit = "outside u in [0, 1), v in [0, 1]",
                    .worst = count_outside<Real>(rtiow, [](Dice& dice) {
                      return Vec3<T>{dice.anything<T>(), dice.anything<T>(), dice.anything<T>()};
                    })});
  claims.push_back({.function = "uv_rtiow, sign of zero",
                    .number = name_of<Real>,
                    .domain = "vectors on an axis or in a plane of two, the zero vector too",
                    .unit = "elsewhere for -0 than for 0",
                    .worst = count_signs_of_zero<Real>()});
  for (const Convention convention : {Convention::daily, Convention::lecture}) {
    const char* const name = convention == Convention::daily ? "daily" : "lecture";
    const auto mapping = [convention](const auto& p) { return uv_of(convention, p); };
    claims.push_back({.function = std::string("uv_of, ") + name,
                      .number = name_of<Real>,
                      .domain = "as uv_rtiow",
                      .bound = bounds.convention,
                      .unit = "texel",
                      .worst = worst_place<Real>(mapping, convention, vectors)});
    claims.push_back({.function = std::string("uv_of, ") + name + ", range",
                      .number = name_of<Real>,
                      .domain = "anything the type can hold, infinities and NaN too",
                      .unit = "outside u in [0, 1), v in [0, 1]",
                      .worst = count_outside<Real>(mapping, [](Dice& dice) {
                        return Vec3<T>{dice.anything<T>(), dice.anything<T>(), dice.anything<T>()};
                      })});
  }
}

/// What the seeds' form does where ours keeps its bound.
template <class T>
void add_seeds(std::vector<Claim>& claims, double bound) {
  const auto poles = [](Dice& dice) { return near_pole<T>(dice, -8, -1); };
  const auto acos_form = [](const auto& p) { return seeds::uv_next_week_v4(p); };
  const auto without_nan = [](const auto& p) {  // the library clamp that the textbooks add
    return seeds::uv_next_week_v4(Vec3<T>{p.x, clamp(p.y, T(-1), T(1)), p.z});
  };
  claims.push_back({.function = "seed 2's v by acos, clamped",
                    .number = name_of<T>,
                    .domain = "1e-8 to 0.1 rad from a pole",
                    .bound = bound,
                    .unit = "texel",
                    .worst = worst_place<T>(without_nan, Convention::rtiow, poles),
                    .expect = Expect::beyond});
  claims.push_back({.function = "seed 2's v by acos, range",
                    .number = name_of<T>,
                    .domain = "1e-8 to 0.1 rad from a pole, length off 1 by up to 4 numbers",
                    .unit = "outside u in [0, 1), v in [0, 1]",
                    .worst = count_outside<T>(acos_form, poles),
                    .expect = Expect::beyond});
}

}  // namespace

Family claims_of_uv() {
  Family family{"Texture coordinates",
                "Errors in texels of a map of 8192 by 4096, on u measured round the circle. Exact: the angles by atan2 in 50 "
                "digits; checked against the inverse cosine in 100.",
                {}};
  add_number<float>(family.claims, {.place = 1e-3, .convention = 1e-3, .pole = 4});
  add_number<double>(family.claims, {.place = 2e-12, .convention = 2e-12, .pole = 4});
  add_number<long double>(family.claims, {.place = 1e-15, .convention = 1e-15, .pole = 4});
#ifdef TEXMAP_HAVE_PACKS
  add_number<Pack<float>>(family.claims, {.place = 1e-3, .convention = 1e-3, .pole = 5});
  add_number<Pack<double>>(family.claims, {.place = 2e-12, .convention = 2e-12, .pole = 5});
#endif
  add_seeds<float>(family.claims, 1e-3);
  add_seeds<double>(family.claims, 2e-12);
  return family;
}

}  // namespace texmap::extremes
