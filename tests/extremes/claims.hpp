// What the course claims of its functions: for which inputs, and how far off they are at most.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "describe.hpp"
#include "digits.hpp"
#include "number/kinds/pack.hpp"
#include "number/number.hpp"

namespace texmap::extremes {

/// The worst that was seen.
struct Worst {
  double off = 0;
  std::string where;  ///< the input that did it

  /// @param describe  gives the input as text; called for a new worst only
  template <class Describe>
  void see(double now, const Describe& describe) {
    if (now <= off) return;
    off = std::isnan(now) ? std::numeric_limits<double>::infinity() : now;
    where = describe();
  }
  /// For claims that count: one more, if it happened.
  template <class Describe>
  void count(bool happened, const Describe& describe) {
    if (!happened) return;
    off += 1;
    if (where.empty()) where = describe();
  }
};

/// A claim's measurement: `one_input(dice, worst)` draws an input and reports its error.
///
/// @param times  how many to draw for each input that is asked for; more than 1 where it is cheap
template <class OneInput>
[[nodiscard]] auto worst_over(int times, OneInput one_input) {
  return [=](int inputs, std::uint64_t seed) {
    Dice dice(seed);
    Worst worst;
    for (int i = 0; i < times * inputs; ++i) one_input(dice, worst);
    return worst;
  };
}
template <class OneInput>
[[nodiscard]] auto worst_over(OneInput one_input) {
  return worst_over(1, one_input);
}

/// Sees what `function` gives for inputs of all lanes, lane by lane.
///
/// @param draw      gives one lane's input
/// @param function  called with all lanes' inputs as one thing of packs
/// @param off       called with one lane's result and input: its error, or whether it is wrong
/// @param given     what the lanes share, as text
template <class Real, class Draw, class Function, class Off>
void see_lanes(Worst& worst, const Draw& draw, const Function& function, const Off& off,
               const std::function<std::string()>& given = {}) {
  const auto each = drawn<Real>(draw);
  const auto got = function(packed<Real>([&](std::size_t i) { return each[i]; }, each[0]));
  for (std::size_t k = 0; k < lanes<Real>; ++k) {
    const auto now = off(lane_of(got, k), each[k]);
    const auto where = [&] { return described(each[k]) + (given ? ", " + given() : ""); };
    if constexpr (std::is_same_v<decltype(now), const bool>) {
      worst.count(now, where);
    } else {
      worst.see(now, where);
    }
  }
}
/// A claim's measurement of such lanes that share nothing; `draw` is called with the dice.
template <class Real, class Draw, class Function, class Off>
[[nodiscard]] auto worst_lanes(int times, Draw draw, Function function, Off off) {
  return worst_over(times, [=](Dice& dice, Worst& worst) {
    see_lanes<Real>(
        worst, [&] { return draw(dice); }, function, off);
  });
}
template <class Real, class Draw, class Function, class Off>
[[nodiscard]] auto worst_lanes(Draw draw, Function function, Off off) {
  return worst_lanes<Real>(1, draw, function, off);
}

/// How many of the 256 bytes are `changed(byte)`; their domain is too small to draw from.
template <class Changed>
[[nodiscard]] auto count_bytes(Changed changed) {
  return [=](int, std::uint64_t) {
    Worst worst;
    for (int byte = 0; byte < 256; ++byte)
      worst.count(changed(byte), [&] { return std::to_string(byte); });
    return worst;
  };
}

/// Two programs that do the same amount of work: the function's, and that of a well-known function.
/// Each returns a number that depends on all of its work, so that no work can be left out.
struct Cost {
  std::string relative_to;
  std::function<double()> work;
  std::function<double()> reference;
};

/// Whether the bound must hold, or must break because it is another function's: a measurement that
/// never breaks sees nothing.
enum class Expect { within, beyond };

/// A function's domain and the bound on its error there.
struct Claim {
  std::string function;
  std::string number;  ///< the type it is measured with
  std::string domain;
  double bound = 0;
  std::string unit;  ///< of the bound: ulp, texel, or what is counted
  std::function<Worst(int inputs, std::uint64_t seed)> worst;  ///< over inputs of the domain
  Cost cost{};
  Expect expect = Expect::within;
};

/// What the page calls a type.
template <class Real>
inline const char* const name_of = "";
template <>
inline const char* const name_of<float> = "float";
template <>
inline const char* const name_of<double> = "double";
template <>
inline const char* const name_of<long double> = "extended";
template <>
inline const char* const name_of<Pack<float>> = "pack of float";
template <>
inline const char* const name_of<Pack<double>> = "pack of double";

/// The largest error that is allowed; 0 of something counted allows none.
struct Bound {
  double most;
  const char* unit;
};

struct Family {
  std::string title;
  std::string introduction;
  std::vector<Claim> claims{};

  /// Adds a row: a claim about `function` in Real. Set cost and Expect::beyond on the result.
  template <class Real>
  Claim& add(std::string function, std::string domain, const Bound& bound,
             std::function<Worst(int, std::uint64_t)> worst) {
    claims.push_back({.function = std::move(function),
                      .number = name_of<Real>,
                      .domain = std::move(domain),
                      .bound = bound.most,
                      .unit = bound.unit,
                      .worst = std::move(worst)});
    return claims.back();
  }
};

/// Calls `each.operator()<Number>()` for every number that the course draws with.
template <class Each>
void for_each_number(const Each& each) {
  each.template operator()<float>();
  each.template operator()<double>();
  each.template operator()<long double>();
  each.template operator()<Pack<float>>();
  each.template operator()<Pack<double>>();
}

[[nodiscard]] Family claims_of_arithmetic();
[[nodiscard]] Family claims_of_uv();
[[nodiscard]] Family claims_of_spheres();
[[nodiscard]] Family claims_of_secondary_rays();
[[nodiscard]] Family claims_of_triangles();
[[nodiscard]] Family claims_of_rotation();
[[nodiscard]] Family claims_of_textures();
[[nodiscard]] Family claims_of_shading();

/// All of them, in the order of the page.
[[nodiscard]] inline std::vector<Family> all_claims() {
  return {claims_of_uv(),        claims_of_spheres(),   claims_of_secondary_rays(),
          claims_of_triangles(), claims_of_rotation(),  claims_of_textures(),
          claims_of_shading(),   claims_of_arithmetic()};
}

/// A program that calls `function` with every one of the inputs.
template <class Inputs, class Function>
[[nodiscard]] std::function<double()> working_through(Inputs inputs, Function function) {
  return [inputs, function] {
    auto sum = function(inputs[0]);
    for (const auto& input : inputs) sum = sum + function(input);
    return static_cast<double>(lane(sum, 0));
  };
}

/// Inputs for a cost: `draw(dice)` until there are 2048 numbers; a pack counts as its lanes.
template <class Real, class Draw>
[[nodiscard]] auto inputs_of_cost(const Draw& draw) {
  Dice dice(1);
  std::vector<decltype(draw(dice))> inputs;
  for (std::size_t i = 0; i < 2048 / lanes<Real>; ++i) inputs.push_back(draw(dice));
  return inputs;
}

}  // namespace texmap::extremes
