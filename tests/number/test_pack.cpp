// Tests of common/number/kinds/pack.hpp and pack2.hpp: in each lane a pack, or a pair of packs,
// behaves as a single number does.
#include <doctest.h>

#include <string>
#include <vector>

#include "number/kinds/pack2.hpp"
#include "number/operations.hpp"
#include "support/lanes.hpp"

#define TEXMAP_PACKS Pack<float>, Pack<double>, Pack2<Pack<float>>, Pack2<Pack<double>>

namespace texmap::test {
namespace {

/// Numbers at which arithmetic is apt to go wrong, with either sign.
template <class T>
std::vector<T> corners() {
  using Limits = std::numeric_limits<T>;
  std::vector<T> all = {Limits::quiet_NaN()};
  for (const double x : {0., 1., .5, .1, 2., 3., 1.5, 2.5, 7.25, 255., 0x1p24, 1e15, 1e30, 1e-30}) {
    all.push_back(static_cast<T>(x));
    all.push_back(-static_cast<T>(x));
  }
  for (const T x :
       {Limits::max(), Limits::min(), Limits::denorm_min(), Limits::epsilon(), infinity<T>()}) {
    all.push_back(x);
    all.push_back(-x);
  }
  return all;
}

TEST_CASE_TEMPLATE("every operation works lane by lane and rounds as single numbers do", Real,
                   TEXMAP_PACKS) {
  const auto table = corners<Scalar<Real>>();
  const auto from = [&table](std::size_t start) {
    return from_lanes<Real>([&](std::size_t i) { return table[(start + i) % table.size()]; });
  };
  const auto check = [&](const std::string& name, const auto& operation) {
    CAPTURE(name);
    for (std::size_t i = 0; i < table.size(); ++i) {
      for (std::size_t j = 0; j < table.size(); ++j) {
        CAPTURE(table[i]);
        CAPTURE(table[j]);
        check_each_lane<Real>(operation, from(i), from(j));
      }
    }
  };
  for_each_arithmetic(check);
  check("copysign", [](auto a, auto b) { return copysign(a, b); });
  check("ldexp", [](auto a, auto) { return ldexp(a, 3); });
  for_each_choice(check);
}

// Not among them: atan2 of (0, 0) and of two infinities, where packs give NaN.
TEST_CASE_TEMPLATE("exp, log1p and atan2 in a lane are those of a plain double, to the last bit",
                   Real, Pack<double>, Pack2<Pack<double>>) {
  Dice dice(5);
  for_each_function([&dice](const std::string& name, const auto& function) {
    CAPTURE(name);
    for (int i = 0; i < 20000; ++i) {
      const auto drawn = [&dice](std::size_t) { return dice.anything<double>(); };
      const Real a = from_lanes<Real>(drawn);
      const Real b = from_lanes<Real>(drawn);
      const auto both_are = [&](const Real& size) { return abs(a) == size && abs(b) == size; };
      const bool undefined =
          name == "atan2" && (any(both_are(Real(0))) || any(both_are(infinity<Real>())));
      if (!undefined) check_each_lane<Real>(function, a, b);
    }
  });
}

}  // namespace
}  // namespace texmap::test
