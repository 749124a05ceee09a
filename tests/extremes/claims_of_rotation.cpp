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

/// Sine and cosine of an angle in degrees, reduced in whole numbers: every floating-point number is
/// a whole number times a power of two, and whole numbers have exact remainders.
template <class T>
OnCircle<Digits50> exact_angle(T degrees) {
  int exponent = 0;
  const T mantissa = std::frexp(std::fabs(degrees), &exponent);
  const auto whole =
      static_cast<std::uint64_t>(std::ldexp(mantissa, std::numeric_limits<T>::digits));
  exponent -= std::numeric_limits<T>::digits;
  Digits50 turn;
  if (exponent >= 0) {
    std::uint64_t rest = whole % 360;
    for (int i = 0; i < exponent; ++i) rest = rest * 2 % 360;
    turn = rest;
  } else if (exponent > -80) {
    // whole / 2^-exponent modulo 360, as (whole mod 360 2^-exponent) / 2^-exponent.
    const boost::multiprecision::uint256_t period = boost::multiprecision::uint256_t(360)
                                                    << -exponent;
    turn = ldexp(Digits50(static_cast<boost::multiprecision::uint256_t>(whole % period)), exponent);
  } else {
    turn = ldexp(Digits50(whole), exponent);
  }
  const Digits50 radians = turn * circle<Digits50>() / 180;
  // The sines of whole quarter turns are known; 50 digits of pi would miss them.
  const bool upright = turn == 90 || turn == 270;
  const bool level = turn == 0 || turn == 180;
  const Digits50 sine = level ? Digits50(0) : sin(radians);
  return {upright ? Digits50(0) : cos(radians), degrees < 0 ? Digits50(-sine) : sine};
}

/// The angle in turns.
Digits50 turns_of(const OnCircle<Digits50>& angle) {
  return atan2(angle.sine, angle.cosine) / (2 * circle<Digits50>());
}

/// Sine and cosine in units in the last place.
template <class T>
double ulps(const OnCircle<T>& got, const OnCircle<Digits50>& exact) {
  return std::max(ulps_off(got.sine, exact.sine), ulps_off(got.cosine, exact.cosine));
}
/// The angle itself in texels on the equator: what a wrong one does to a picture.
template <class T>
double texels(const OnCircle<T>& got, const OnCircle<Digits50>& exact) {
  const Digits50 off = abs(turns_of(exact) - turns_of({got.cosine, got.sine}));
  return static_cast<double>(around(off, 0) * 8192);
}

template <class T, class Function>
auto worst_angle(Function function, int largest,
                 double (*off)(const OnCircle<T>&, const OnCircle<Digits50>&)) {
  return worst_over(1, [=](Dice& dice, Worst& worst) {
    const T degrees = any_angle<T>(dice, largest);
    worst.see(off(function(degrees), exact_angle(degrees)), [&] { return described(degrees); });
  });
}

/// What a whole turn by one angle does to the length of a vector.
template <class Real>
auto worst_length() {
  using T = Scalar<Real>;
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const auto degrees = any_angle<double>(dice, 1000);
    see_lanes<Real>(
        worst, [&] { return number_cast<T>(dice.direction()); }, rotation_y(degrees),
        [](const Vec3<T>& turned, const Vec3<T>& p) {
          const Vec3<Digits50> before = exactly(p);
          const Vec3<Digits50> after = exactly(turned);
          return static_cast<double>(abs(sqrt(dot(after, after) / dot(before, before)) - 1) /
                                     roundoff<T>());
        },
        [&] { return described(degrees) + " degrees"; });
  });
}

/// u of a turned direction, compared with the exact u plus the exact turn. Angles are doubles.
template <class Real>
auto worst_shift() {
  using T = Scalar<Real>;
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const bool whole_texels = dice.once_in(2);
    const double degrees =
        whole_texels ? 360.0 / 8192 * dice.within(-100000, 100000) : any_angle<double>(dice, 1000);
    const Digits50 turn = turns_of(exact_angle(degrees));
    see_lanes<Real>(
        worst, [&] { return number_cast<T>(dice.direction()); },
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

}  // namespace

Family claims_of_rotation() {
  Family family{"Rotation",
                "Exact: the angle reduced in whole numbers, its sine and cosine in 50 digits. The "
                "last rows reduce in radians, as most programs do."};
  for_each<float, double, long double>([&]<class T>() {
    family.add<T>("on_circle_of_degrees",
                  std::string("any angle from the smallest number to ") +
                      by_number<T>("1e38", "1e300", "1e4800") +
                      " degrees; whole degrees; quarter turns and their neighbours",
                  {3, "ulp"}, worst_angle<T>(ours, by_number<T>(127, 1000, 16000), ulps<T>));
  });
  for_each_number([&]<class Real>() {
    family.add<Real>("RotationY, change of length", "unit vectors; angles as above, kept in double",
                     {by_number<Real>(3.5, 3.5, 4096.), "u"}, worst_length<Real>());
    family.add<Real>("uv_rtiow of a turned direction, u",
                     "unit vectors; angles of whole texels, and as above",
                     {by_number<Real>(1e-3, 2e-12, 4e-13), "texel"}, worst_shift<Real>());
  });
  for_each<float, double>([&]<class T>() {
    family.add_broken<T>(
        "sine and cosine of degrees pi / 180", "any angle from the smallest number to 1e9 degrees",
        {by_number<T>(1e-3, 2e-12, 0.), "texel"}, worst_angle<T>(through_radians, 30, texels<T>));
  });
  return family;
}

}  // namespace texmap::extremes
