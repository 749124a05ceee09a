// Claims of common/number/kinds/elementary.hpp: the functions that replace the C library's.
#include "claims.hpp"
#include "number/kinds/pack.hpp"

namespace texmap::extremes {
namespace {

/// A number of either sign whose size is up to 10^most, often far less.
template <class T>
T sized(Dice& dice, double most) {
  return static_cast<T>(dice.sign() * dice.power_of_ten(-30, most));
}

template <class Real>
void add_functions(Family& family) {
  using T = Scalar<Real>;
  const double most_exponent = std::numeric_limits<T>::max_exponent * 0.69;
  // Of a function of one or two numbers; `exact` is called with 50 digits.
  const auto add = [&](const char* name, const char* domain, double bound, auto draw,
                       auto function) {
    const bool in_double = std::is_same_v<Real, float>;  // and rounded once
    family.add<Real>(name, domain, {in_double ? 0.501 : bound, "ulp"},
                     worst_lanes<Real>(
                         1, draw, [=](const auto& x) { return function(x[0], x[1]); },
                         [=](T got, const std::array<T, 2>& x) {
                           const Digits50 exact = function(Digits50(x[0]), Digits50(x[1]));
                           return abs(exact) < std::numeric_limits<T>::min() ? 0.0
                                                                             : ulps_off(got, exact);
                         }));
  };
  const auto pair = [](auto x, auto y) {
    return [=](Dice& dice) { return std::array<T, 2>{x(dice), y(dice)}; };
  };
  const auto any = [](Dice& dice) { return sized<T>(dice, 6); };
  const auto zero = [](Dice&) { return T(0); };
  add("atan2", "any two numbers of 1e-30 to 1e6", std::is_same_v<T, float> ? 2.4 : 2.2,
      pair(any, any), [](const auto& y, const auto& x) { return atan2(y, x); });
  const auto exponent = [=](Dice& dice) {
    return dice.once_in(2) ? static_cast<T>(dice.between(-most_exponent, most_exponent))
                           : sized<T>(dice, 1.9);
  };
  add("exp", "any exponent of a normal result", 1, pair(exponent, zero),
      [](const auto& x, const auto&) { return exp(x); });
  const auto above_minus_one = [](Dice& dice) {
    return static_cast<T>(dice.once_in(2) ? -dice.power_of_ten(-20, 0)
                                          : dice.power_of_ten(-20, 15));
  };
  add("log1p", "-1 to 1e15, and as near 0 and -1 as 1e-20", 1, pair(above_minus_one, zero),
      [](const auto& x, const auto&) { return log1p(x); });
  if constexpr (lanes<Real> == 1) {
    const auto ratio = [](Dice& dice) {
      const long double near_one = 1 - dice.power_of_ten(-17, 0);
      return static_cast<T>(dice.sign() * (dice.once_in(2) ? near_one : dice.power_of_ten(-20, 0)));
    };
    // The distance from a quarter turn is the smaller, the more digits the angle has.
    const int most_quarters = std::numeric_limits<T>::digits > 53 ? 10 : 400000;
    const auto angle = [=](Dice& dice) {
      return dice.once_in(2) ? sized<T>(dice, 6)
                             : static_cast<T>(dice.within(-most_quarters, most_quarters) *
                                              std::numbers::pi_v<long double> / 2);
    };
    add("acos", "-1 to 1", 3, pair(ratio, zero),
        [](const auto& x, const auto&) { return acos(x); });
    add("asin", "-1 to 1", 3, pair(ratio, zero),
        [](const auto& x, const auto&) { return asin(x); });
    add("cos", "up to 1e6, near quarter turns, too (extended: 10 of them)", 1, pair(angle, zero),
        [](const auto& x, const auto&) { return cos(x); });
    add("sin", "up to 1e6, near quarter turns, too (extended: 10 of them)", 1, pair(angle, zero),
        [](const auto& x, const auto&) { return sin(x); });
    add("tan", "up to 1e6, near quarter turns, too (extended: 10 of them)", 2.5, pair(angle, zero),
        [](const auto& x, const auto&) { return tan(x); });
    const auto base_and_exponent = [=](Dice& dice) {
      const double logarithm = dice.once_in(2)
                                   ? dice.between(-13.8, 13.8)
                                   : dice.sign() * static_cast<double>(dice.power_of_ten(-4, 0));
      return std::array<T, 2>{
          static_cast<T>(std::exp(logarithm)),
          static_cast<T>(dice.between(-1, 1) * 0.99 * most_exponent / std::abs(logarithm))};
    };
    add("pow", "1e-6 to 1e6, any exponent of a normal result",
        std::numeric_limits<T>::digits > 53 ? 3 : 1.5, base_and_exponent,
        [](const auto& x, const auto& y) { return pow(x, y); });
  }
}

}  // namespace

Family claims_of_functions() {
  Family family{"Elementary functions",
                "Exact: the same functions in 50 digits. In float they are computed in double and "
                "rounded once."};
  for_each_number([&]<class Real>() { add_functions<Real>(family); });
  return family;
}

}  // namespace texmap::extremes
