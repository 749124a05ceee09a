// What the course claims of its functions: for which inputs, and how far off they are at most.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

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
  void see(bool happened, const Describe& describe) {
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

[[nodiscard]] inline Measurement worst_over(int times,
                                            std::function<void(Dice&, Worst&)> one_input) {
  return {.one_input = std::move(one_input), .times = times};
}

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
    worst.see(off(lane_of(got, k), each[k]),
              [&] { return described(each[k]) + (given ? ", " + given() : ""); });
  }
}
/// A claim's measurement of such lanes that share nothing; `draw` is called with the dice.
template <class Real, class Draw, class Function, class Off>
[[nodiscard]] Measurement worst_lanes(int times, Draw draw, Function function, Off off) {
  return worst_over(times, [=](Dice& dice, Worst& worst) {
    see_lanes<Real>(
        worst, [&] { return draw(dice); }, function, off);
  });
}
/// How many lanes' inputs are wrong: `wrong` gives a mask.
template <class Real, class Draw, class Wrong>
[[nodiscard]] Measurement count_lanes(int times, Draw draw, Wrong wrong) {
  return worst_lanes<Real>(
      times, draw, [wrong](const auto& input) { return select(wrong(input), Real(1), Real(0)); },
      [](Scalar<Real> is_wrong, const auto&) { return is_wrong != 0; });
}

/// The worst over the 256 bytes; `off(byte)` is the error of one, or whether it is wrong.
template <class Off>
[[nodiscard]] Measurement worst_byte(Off off) {
  const auto every = [off] {
    Worst worst;
    for (int byte = 0; byte < 256; ++byte)
      worst.see(off(byte), [&] { return std::to_string(byte); });
    return worst;
  };
  return {.every_input = every, .how_many = "256 bytes"};
}

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
[[nodiscard]] std::string name_of() {
  if constexpr (lanes < Real >> 1) return "pack of " + name_of<Scalar<Real>>();
  return std::is_same_v<Real, float>    ? "float"
         : std::is_same_v<Real, double> ? "double"
                                        : "extended";
}

/// What a claim says for float, for double and for long double; for a pack, what its lanes have.
template <class Real, class Value>
[[nodiscard]] Value by_number(Value in_float, Value in_double, Value extended) {
  using T = Scalar<Real>;
  return std::is_same_v<T, float> ? in_float : std::is_same_v<T, double> ? in_double : extended;
}

/// The largest error that is allowed; 0 of something counted allows none.
struct Bound {
  double most;
  const char* unit;
};

struct Family {
  std::string title;
  std::string introduction;
  std::vector<Claim> claims{};

  /// Adds a row: a claim about `function` in Real.
  template <class Real>
  Claim& add(std::string function, std::string domain, const Bound& bound,
             Measurement measurement) {
    claims.push_back({.function = std::move(function),
                      .number = name_of<Real>(),
                      .domain = std::move(domain),
                      .bound = bound.most,
                      .unit = bound.unit,
                      .measurement = std::move(measurement)});
    return claims.back();
  }
  /// A row of a form that must break the bound.
  template <class Real>
  Claim& add_broken(std::string function, std::string domain, const Bound& bound,
                    Measurement measurement) {
    Claim& claim = add<Real>(std::move(function), std::move(domain), bound, std::move(measurement));
    claim.expect = Expect::beyond;
    return claim;
  }
};

/// Calls `each.operator()<Number>()` for these numbers.
template <class... Numbers, class Each>
void for_each(const Each& each) {
  (each.template operator()<Numbers>(), ...);
}
/// For every number that the course draws with.
template <class Each>
void for_each_number(const Each& each) {
  for_each<float, double, long double, Pack<float>, Pack<double>>(each);
}

[[nodiscard]] Family claims_of_uv();
[[nodiscard]] Family claims_of_spheres();
[[nodiscard]] Family claims_of_secondary_rays();
[[nodiscard]] Family claims_of_triangles();
[[nodiscard]] Family claims_of_rotation();
[[nodiscard]] Family claims_of_textures();
[[nodiscard]] Family claims_of_shading();
[[nodiscard]] Family claims_of_derivatives();
[[nodiscard]] Family claims_of_maps();
[[nodiscard]] Family claims_of_arithmetic();
[[nodiscard]] Family claims_of_functions();
[[nodiscard]] Family claims_of_kernels();  ///< held by other tests: they have no measurement

/// All of them, in the order of the page. What is not here is neither shown nor searched.
[[nodiscard]] inline std::vector<Family> all_claims() {
  return {claims_of_uv(),         claims_of_spheres(),     claims_of_secondary_rays(),
          claims_of_triangles(),  claims_of_rotation(),    claims_of_textures(),
          claims_of_shading(),    claims_of_derivatives(), claims_of_maps(),
          claims_of_arithmetic(), claims_of_functions(),   claims_of_kernels()};
}

}  // namespace texmap::extremes
