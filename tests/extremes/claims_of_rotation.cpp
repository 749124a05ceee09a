// Claims of common/math/rotation.hpp: turning about the vertical axis.
#include "claims.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "references.hpp"
#include "rotation.hpp"
#include "uv.hpp"

namespace texmap::extremes {
namespace {

/// An angle in degrees: of any size, or whole, or a few numbers beside a quarter turn.
template <class T>
T any_angle(Dice& dice, int largest) {
  T degrees = dice.number<T>(std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits, largest);
  if (dice.once_in(4)) degrees = static_cast<T>(dice.within(0, 100000));
  if (dice.once_in(4)) {
    degrees = static_cast<T>(90 * dice.within(0, 1000));
    for (int steps = dice.below(4); steps > 0; --steps) degrees = std::nextafter(degrees, dice.once_in(2) ? T(0) : T(1e6L));
  }
  return dice.sign() < 0 ? -degrees : degrees;
}

/// Sine and cosine in units in the last place.
template <class T>
double ulps(const SineCosine<T>& got, const ExactAngle<Digits50>& exact) {
  return std::max(ulps_off(got.sine, exact.sine), ulps_off(got.cosine, exact.cosine));
}
/// The angle itself in texels on the equator: what a wrong one does to a picture.
template <class T>
double texels(const SineCosine<T>& got, const ExactAngle<Digits50>& exact) {
  const Digits50 off = atan2(exact.sine, exact.cosine) - atan2(Digits50(got.sine), Digits50(got.cosine));
  return static_cast<double>(around(Digits50(abs(off) / (2 * circle<Digits50>())), Digits50(0)) * 8192);
}

template <class T, class Function>
auto worst_angle(Function function, int largest, double (*off)(const SineCosine<T>&, const ExactAngle<Digits50>&)) {
  return worst_over([=](Dice& dice, Worst& worst) {
    const T degrees = any_angle<T>(dice, largest);
    worst.see(off(function(degrees), exact_angle(degrees)), [&] { return described(degrees); });
  });
}

/// What a whole turn by one angle does to the length of a vector.
template <class Real>
auto worst_length() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    const auto degrees = any_angle<double>(dice, 1000);
    const auto each = drawn<Real>([&] { return rounded<T>(dice.direction()); });
    const Vec3<Real> turned = rotation_y(degrees)(gathered<Real>(each));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Vec3<Digits50> before = exactly<Digits50>(each[k]);
      const Vec3<Digits50> after = exactly<Digits50>(lane_of(turned, k));
      const Digits50 drift = abs(sqrt(dot(after, after) / dot(before, before)) - 1);
      worst.see(static_cast<double>(drift / roundoff<T>()), [&] { return described(degrees) + " " + described(each[k]); });
    }
  });
}

/// u of a turned direction against the exact u plus the exact part of a turn. The angle is the picture's, a double.
template <class Real>
auto worst_shift(int largest) {
  using T = Scalar<Real>;
  return worst_over([largest](Dice& dice, Worst& worst) {
    const bool whole_texels = dice.once_in(2);
    const double degrees = whole_texels ? 360.0 / 8192 * dice.within(-100000, 100000) : any_angle<double>(dice, largest);
    const ExactAngle<Digits50> angle = exact_angle(degrees);
    const auto each = drawn<Real>([&] { return rounded<T>(dice.direction()); });
    const Uv<Real> uv = uv_rtiow(rotation_y(degrees)(gathered<Real>(each)));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Digits50 before = exact_uv(exactly<Digits50>(each[k])).u;
      const Digits50 turn = atan2(angle.sine, angle.cosine) / (2 * circle<Digits50>());
      Digits50 expected = before + turn;
      expected -= floor(expected);
      const auto off = static_cast<double>(around(Digits50(lane(uv.u, k)), expected) * 8192);
      worst.see(off, [&] { return described(degrees) + " degrees, " + described(each[k]); });
    }
  });
}

/// Sine and cosine as most programs have them.
template <class T>
SineCosine<T> through_radians(T degrees) {
  const T radians = degrees * pi<T>() / T(180);
  return {std::sin(radians), std::cos(radians)};
}

template <class T>
Cost cost_of_angle() {
  const auto angles = inputs_of_cost<T>([](Dice& dice) { return static_cast<T>(dice.uniform(-720, 720)); });
  const std::vector<double> doubles(angles.begin(), angles.end());
  return {"sin and cos of degrees pi / 180, double",
          working_through(angles,
                          [](T degrees) {
                            const SineCosine<T> angle = sine_cosine_of_degrees(degrees);
                            return angle.sine + angle.cosine;
                          }),
          working_through(doubles, [](double degrees) {
            const SineCosine<double> angle = through_radians(degrees);
            return angle.sine + angle.cosine;
          })};
}

template <class T>
void add_angle(std::vector<Claim>& claims, int largest, const char* range, double bound) {
  claims.push_back({.function = "sine_cosine_of_degrees",
                    .number = name_of<T>,
                    .domain = std::string("any angle from the smallest number to ") + range +
                              " degrees; whole degrees; quarter turns and their neighbours",
                    .bound = bound,
                    .unit = "ulp",
                    .worst = worst_angle<T>([](T degrees) { return sine_cosine_of_degrees(degrees); }, largest, ulps<T>),
                    .cost = cost_of_angle<T>()});
}

/// What most programs' form does where ours keeps its bound.
template <class T>
void add_radians(std::vector<Claim>& claims, double bound) {
  claims.push_back({.function = "sine and cosine of degrees pi / 180",
                    .number = name_of<T>,
                    .domain = "any angle from the smallest number to 1e9 degrees",
                    .bound = bound,
                    .unit = "texel",
                    .worst = worst_angle<T>([](T degrees) { return through_radians(degrees); }, 30, texels<T>),
                    .expect = Expect::beyond});
}

template <class Real>
void add_turn(std::vector<Claim>& claims, double length, double shift) {
  claims.push_back({.function = "RotationY, change of length",
                    .number = name_of<Real>,
                    .domain = "unit vectors; angles as above, kept in double",
                    .bound = length,
                    .unit = "u",
                    .worst = worst_length<Real>()});
  claims.push_back({.function = "uv_rtiow of a turned direction, u",
                    .number = name_of<Real>,
                    .domain = "unit vectors; angles of whole texels, and as above",
                    .bound = shift,
                    .unit = "texel",
                    .worst = worst_shift<Real>(1000)});
}

}  // namespace

Family claims_of_rotation() {
  Family family{"Rotation",
                "Exact: the angle reduced in whole numbers, its sine and cosine in 50 digits; checked against the sine of the "
                "unreduced angle in 100. The last rows reduce in radians, as most programs do.",
                {}};
  std::vector<Claim>& claims = family.claims;
  add_angle<float>(claims, 127, "1e38", 3);
  add_angle<double>(claims, 1000, "1e300", 3);
  add_angle<long double>(claims, 16000, "1e4800", 3);
  add_turn<float>(claims, 2, 1e-3);
  add_turn<double>(claims, 2, 2e-12);
  add_turn<long double>(claims, 2048, 4e-13);
#ifdef TEXMAP_HAVE_PACKS
  add_turn<Pack<float>>(claims, 2, 1e-3);
  add_turn<Pack<double>>(claims, 2, 2e-12);
#endif
  add_radians<float>(claims, 1e-3);
  add_radians<double>(claims, 2e-12);
  return family;
}

}  // namespace texmap::extremes
