// What the course claims of its functions: for which inputs, and how far from the exact answer at most.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "dice.hpp"
#include "number.hpp"
#include "pack.hpp"

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

/// A claim's measurement: `one_input(dice, worst)` draws an input from the domain and reports what it sees there.
///
/// @param times  how many to draw for each input that is asked for, more than 1 where they cost little
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

/// How many of the 256 bytes are `changed(byte)`; their domain is too small to draw from.
template <class Changed>
[[nodiscard]] auto count_bytes(Changed changed) {
  return [=](int, std::uint64_t) {
    Worst worst;
    for (int byte = 0; byte < 256; ++byte) worst.count(changed(byte), [&] { return std::to_string(byte); });
    return worst;
  };
}

/// Two programs that do the same amount of work, the function's and that of something well known. Each gives a number that
/// depends on all of its work, so that none of it can be left out.
struct Cost {
  std::string relative_to;
  std::function<double()> work;
  std::function<double()> reference;
};

/// Whether the bound is to hold, or is another function's and must be seen to break: otherwise the measurement sees nothing.
enum class Expect { within, beyond };

/// A function's domain and the bound on its error there.
struct Claim {
  std::string function;
  std::string number;  ///< the type it is measured with
  std::string domain;
  double bound = 0;
  std::string unit;                                            ///< of the bound: ulp, texel, or what is counted
  std::function<Worst(int inputs, std::uint64_t seed)> worst;  ///< over inputs of the domain
  Cost cost{};
  Expect expect = Expect::within;
};

struct Family {
  std::string title;
  std::string introduction;
  std::vector<Claim> claims;
};

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
  return {claims_of_uv(),       claims_of_spheres(),  claims_of_secondary_rays(), claims_of_triangles(),
          claims_of_rotation(), claims_of_textures(), claims_of_shading(),        claims_of_arithmetic()};
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
#ifdef TEXMAP_HAVE_PACKS
template <>
inline const char* const name_of<Pack<float>> = "pack of float";
template <>
inline const char* const name_of<Pack<double>> = "pack of double";
#endif

/// A program that calls `function` with every one of the inputs.
template <class Inputs, class Function>
[[nodiscard]] std::function<double()> working_through(Inputs inputs, Function function) {
  return [inputs, function] {
    auto sum = function(inputs[0]);
    for (const auto& input : inputs) sum = sum + function(input);
    return static_cast<double>(lane(sum, 0));
  };
}

/// Inputs for a cost: `draw(dice)` as often as makes 2048 numbers, packs counting for as many as they hold.
template <class Real, class Draw>
[[nodiscard]] auto inputs_of_cost(const Draw& draw) {
  Dice dice(1);
  std::vector<decltype(draw(dice))> inputs;
  for (std::size_t i = 0; i < 2048 / lanes<Real>; ++i) inputs.push_back(draw(dice));
  return inputs;
}

}  // namespace texmap::extremes
