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
  std::string where{};    ///< the input that did it
  bool describes = true;  ///< or `where` stays empty

  /// @param describe  gives the input as text; called for a new worst only
  template <class Describe>
  void see(double now, const Describe& describe) {
    if (now <= off) return;
    off = std::isnan(now) ? std::numeric_limits<double>::infinity() : now;
    if (describes) where = describe();
  }
  /// For claims that count: one more, if it happened.
  template <class Describe>
  void count(bool happened, const Describe& describe) {
    if (!happened) return;
    off += 1;
    if (describes && where.empty()) where = describe();
  }
};

/// How a claim is measured: over inputs that dice draw, or over every input.
struct Measurement {
  std::function<void(Dice&, Worst&)> one_input{};  ///< draws one and reports its error
  int times = 1;  ///< how many to draw for each that is asked for; more where it is cheap
  std::function<Worst()> every_input{};  ///< instead, where the domain is small
  std::string how_many{};                ///< every input: what they are
};

template <class OneInput>
[[nodiscard]] Measurement worst_over(int times, OneInput one_input) {
  return {.one_input = one_input, .times = times};
}
template <class OneInput>
[[nodiscard]] Measurement worst_over(OneInput one_input) {
  return worst_over(1, one_input);
}

/// The worst of so many inputs as they are drawn.
[[nodiscard]] Worst sampled(const Measurement& measurement, int inputs, std::uint64_t seed);

/// The worst that a search finds among so many inputs: the worst of those drawn are changed a
/// little, again and again, and what is worse is kept. The same on every run.
[[nodiscard]] Worst searched(const Measurement& measurement, int inputs, std::uint64_t seed);

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

/// The worst over the 256 bytes; `one_byte(byte, worst)` reports the error of one.
template <class OneByte>
[[nodiscard]] Measurement worst_byte(OneByte one_byte) {
  const auto every = [one_byte] {
    Worst worst;
    for (int byte = 0; byte < 256; ++byte) one_byte(byte, worst);
    return worst;
  };
  return {.every_input = every, .how_many = "256 bytes"};
}
/// How many of the bytes are `changed(byte)`.
template <class Changed>
[[nodiscard]] Measurement count_bytes(Changed changed) {
  return worst_byte([changed](int byte, Worst& worst) {
    worst.count(changed(byte), [&] { return std::to_string(byte); });
  });
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
  Measurement measurement;
  Cost cost{};
  Expect expect = Expect::within;
  std::string certainty{};  ///< of a bound that other tests hold: its rung on the page's ladder
};

/// The claim's rung on the page's ladder of certainty.
[[nodiscard]] inline std::string certainty_of(const Claim& claim) {
  if (!claim.certainty.empty()) return claim.certainty;
  return claim.measurement.every_input ? "exhaustive, " + claim.measurement.how_many : "searched";
}

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
             Measurement measurement) {
    claims.push_back({.function = std::move(function),
                      .number = name_of<Real>,
                      .domain = std::move(domain),
                      .bound = bound.most,
                      .unit = bound.unit,
                      .measurement = std::move(measurement)});
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
[[nodiscard]] Family claims_of_derivatives();
[[nodiscard]] Family claims_of_maps();
[[nodiscard]] Family claims_of_kernels();  ///< held by other tests: they have no measurement

/// All of them, in the order of the page.
[[nodiscard]] inline std::vector<Family> all_claims() {
  return {claims_of_uv(),         claims_of_spheres(),     claims_of_secondary_rays(),
          claims_of_triangles(),  claims_of_rotation(),    claims_of_textures(),
          claims_of_shading(),    claims_of_derivatives(), claims_of_maps(),
          claims_of_arithmetic(), claims_of_kernels()};
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
