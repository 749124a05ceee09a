// Claims of common/math/rotation.hpp: turning about the vertical axis.
#include "claims.hpp"
#include "math/rotation.hpp"
#include "references.hpp"
#include "texture/uv.hpp"

namespace texmap::extremes {
namespace {

/// An angle in degrees: of any size, or whole, or a few numbers from a quarter turn.
template <class T>
T any_angle(Dice& dice, int largest) {
  T degrees = dice.number<T>(std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits,
                             largest);
  if (dice.once_in(4)) degrees = static_cast<T>(dice.within(0, 100000));
  if (dice.once_in(4)) {
    degrees = static_cast<T>(90 * dice.within(0, 1000));
    for (int steps = dice.below(4); steps > 0; --steps)
      degrees = std::nextafter(degrees, dice.once_in(2) ? T(0) : T(1e6L));
  }
  return dice.sign() < 0 ? -degrees : degrees;
}

/// Sine and cosine in units in the last place.
template <class T>
double ulps(const OnCircle<T>& got, const ExactAngle<Digits50>& exact) {
  return std::max(ulps_off(got.sine, exact.sine), ulps_off(got.cosine, exact.cosine));
}
/// The angle itself in texels on the equator: what a wrong one does to a picture.
template <class T>
double texels(const OnCircle<T>& got, const ExactAngle<Digits50>& exact) {
  const Digits50 off =
      atan2(exact.sine, exact.cosine) - atan2(Digits50(got.sine), Digits50(got.cosine));
  return static_cast<double>(around(Digits50(abs(off) / (2 * circle<Digits50>())), Digits50(0)) *
                             8192);
}

template <class T, class Function>
auto worst_angle(Function function, int largest,
                 double (*off)(const OnCircle<T>&, const ExactAngle<Digits50>&)) {
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
    see_lanes<Real>(
        worst, [&] { return rounded<T>(dice.direction()); }, rotation_y(degrees),
        [](const Vec3<T>& turned, const Vec3<T>& p) {
          const Vec3<Digits50> before = exactly(p);
          const Vec3<Digits50> after = exactly(turned);
          const Digits50 drift = abs(sqrt(dot(after, after) / dot(before, before)) - 1);
          return static_cast<double>(drift / roundoff<T>());
        },
        [&] { return described(degrees) + " degrees"; });
  });
}

/// u of a turned direction, compared with the exact u plus the exact turn. Angles are doubles.
template <class Real>
auto worst_shift(int largest) {
  using T = Scalar<Real>;
  return worst_over([largest](Dice& dice, Worst& worst) {
    const bool whole_texels = dice.once_in(2);
    const double degrees = whole_texels ? 360.0 / 8192 * dice.within(-100000, 100000)
                                        : any_angle<double>(dice, largest);
    const ExactAngle<Digits50> angle = exact_angle(degrees);
    const Digits50 turn = atan2(angle.sine, angle.cosine) / (2 * circle<Digits50>());
    see_lanes<Real>(
        worst, [&] { return rounded<T>(dice.direction()); },
        [&](const Vec3<Real>& p) { return uv_rtiow(rotation_y(degrees)(p)); },
        [&](const Uv<T>& uv, const Vec3<T>& p) {
          Digits50 expected = exact_uv(exactly(p)).u + turn;
          expected -= floor(expected);
          return static_cast<double>(around(Digits50(uv.u), expected) * 8192);
        },
        [&] { return described(degrees) + " degrees"; });
  });
}

constexpr auto ours = [](auto degrees) { return on_circle_of_degrees(degrees); };
/// Sine and cosine as most programs have them.
constexpr auto through_radians = []<class T>(T degrees) {
  const T radians = degrees * pi<T>() / T(180);
  return OnCircle<T>{std::cos(radians), std::sin(radians)};
};

template <class T>
Cost cost_of_angle() {
  const auto angles =
      inputs_of_cost<T>([](Dice& dice) { return static_cast<T>(dice.uniform(-720, 720)); });
  const auto sum_of = [](auto function) {
    return [function](auto degrees) {
      const auto angle = function(degrees);
      return angle.sine + angle.cosine;
    };
  };
  return {
      "sin and cos of degrees pi / 180, double", working_through(angles, sum_of(ours)),
      working_through(std::vector<double>(angles.begin(), angles.end()), sum_of(through_radians))};
}

template <class T>
void add_angle(Family& family, int largest, const std::string& range) {
  family
      .add<T>("on_circle_of_degrees",
              "any angle from the smallest number to " + range +
                  " degrees; whole degrees; quarter turns and their neighbours",
              {3, "ulp"}, worst_angle<T>(ours, largest, ulps<T>))
      .cost = cost_of_angle<T>();
}

template <class Real>
void add_turn(Family& family, double length, double shift) {
  family.add<Real>("RotationY, change of length", "unit vectors; angles as above, kept in double",
                   {length, "u"}, worst_length<Real>());
  family.add<Real>("uv_rtiow of a turned direction, u",
                   "unit vectors; angles of whole texels, and as above", {shift, "texel"},
                   worst_shift<Real>(1000));
}

/// What most programs' form does where ours keeps its bound.
template <class T>
void add_radians(Family& family, double bound) {
  family
      .add<T>("sine and cosine of degrees pi / 180",
              "any angle from the smallest number to 1e9 degrees", {bound, "texel"},
              worst_angle<T>(through_radians, 30, texels<T>))
      .expect = Expect::beyond;
}

}  // namespace

Family claims_of_rotation() {
  Family family{"Rotation",
                "Exact: the angle reduced in whole numbers, its sine and cosine in 50 digits; "
                "checked against the sine of the unreduced angle in 100. The last rows reduce in "
                "radians, as most programs do."};
  add_angle<float>(family, 127, "1e38");
  add_angle<double>(family, 1000, "1e300");
  add_angle<long double>(family, 16000, "1e4800");
  add_turn<float>(family, 3.5, 1e-3);
  add_turn<double>(family, 3.5, 2e-12);
  add_turn<long double>(family, 4096, 4e-13);
  add_turn<Pack<float>>(family, 3.5, 1e-3);
  add_turn<Pack<double>>(family, 3.5, 2e-12);
  add_radians<float>(family, 1e-3);
  add_radians<double>(family, 2e-12);
  return family;
}

}  // namespace texmap::extremes
