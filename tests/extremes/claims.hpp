// What the course claims of its functions: for which inputs, and how far from the exact answer at most.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

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

/// How many numbers a cost is measured with.
constexpr std::size_t cost_inputs = 2048;

}  // namespace texmap::extremes
