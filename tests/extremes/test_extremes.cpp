// Tests of the claims about functions: each bound holds, is at most 8 times too wide, and other
// forms break it.
#include <doctest.h>

#include <atomic>
#include <sstream>
#include <thread>

#include "claims.hpp"
#include "support/shown_values.hpp"

namespace texmap::extremes {
namespace {

/// Inputs for each claim; fewer where sanitizers or an unoptimized build make references slow.
constexpr int inputs = TEXMAP_EXTREMES_INPUTS;
constexpr bool enough_for_the_worst = inputs >= 1000;

/// The worst of each claim; two are searched at a time.
std::vector<Worst> worst_of(const std::vector<Claim>& claims) {
  std::vector<Worst> worst(claims.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < claims.size();)
      worst[i] = searched(claims[i].measurement, inputs, 1);
  };
  std::thread other(work);
  work();
  other.join();
  return worst;
}

void hold(const Family& family) {
  const std::vector<Worst> found = worst_of(family.claims);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Claim& claim = family.claims[i];
    const Worst& worst = found[i];
    std::ostringstream report;
    report << claim.function << ", " << claim.number << ": " << worst.off << " " << claim.unit
           << " for a bound of " << claim.bound;
    MESSAGE(report.str());
    INFO("domain: " << claim.domain);
    INFO("at: " << worst.where);
    INFO(report.str());
    if (claim.expect == Expect::beyond) {
      CHECK_MESSAGE(worst.off > claim.bound, "the measurement does not see what it is made to see");
      continue;
    }
    CHECK(worst.off <= claim.bound);
    if (enough_for_the_worst) CHECK_MESSAGE(worst.off >= claim.bound / 8, "the bound is idle");
  }
}

TEST_CASE("texture coordinates keep their bounds") { hold(claims_of_uv()); }
TEST_CASE("rays and spheres keep their bounds") { hold(claims_of_spheres()); }
TEST_CASE("rays that go on from a hit keep their bounds") { hold(claims_of_secondary_rays()); }
TEST_CASE("triangles and the floor keep their bounds") { hold(claims_of_triangles()); }
TEST_CASE("rotations keep their bounds") { hold(claims_of_rotation()); }
TEST_CASE("textures keep their bounds") { hold(claims_of_textures()); }
TEST_CASE("light, colors and the camera keep their bounds") { hold(claims_of_shading()); }
TEST_CASE("derivatives keep their bounds") { hold(claims_of_derivatives()); }
TEST_CASE("maps, footprints and edges keep their bounds") { hold(claims_of_maps()); }
TEST_CASE("arithmetic keeps its bounds") { hold(claims_of_arithmetic()); }

TEST_CASE("a claim is measured the same on every run, and differently with another seed") {
  const Claim claim = claims_of_uv().claims[1];
  CHECK(searched(claim.measurement, 50, 1).off == searched(claim.measurement, 50, 1).off);
  CHECK(searched(claim.measurement, 50, 1).off != searched(claim.measurement, 50, 3).off);
}

TEST_CASE("the search finds what draws do not meet: a peak 1e-7 wide") {
  // Highest at 0.7, and above 0.99 only within 1e-7 of it.
  const Measurement peak = worst_over([](Dice& dice, Worst& worst) {
    const double x = dice.between(0, 1);
    worst.see(1 / (1 + std::sqrt(std::fabs(x - 0.7)) * 31), [&] { return described(x); });
  });
  CHECK(sampled(peak, 2000, 1).off < 0.9);
  const Worst found = searched(peak, 2000, 1);
  CHECK(found.off > 0.99);
  CHECK(found.where.substr(0, 6) == "0.7000");
}

TEST_CASE("a tape's draws come again, and what is missing at its end is drawn and kept") {
  Dice::Tape tape{5, 6};
  Dice first(tape, 1);
  CHECK(first.bits() == 5);
  CHECK(first.bits() == 6);
  const std::uint64_t drawn = first.bits();
  CHECK(drawn == Dice(1).bits());
  CHECK(tape == Dice::Tape{5, 6, drawn});
  CHECK(first.taken() == 3);
  Dice again(tape, 2);
  CHECK(again.bits() == 5);
  CHECK(again.taken() == 1);
}

TEST_CASE("a NaN is worse than any number, and the first input that fails is kept") {
  Worst worst;
  worst.see(1, [] { return "one"; });
  worst.see(std::numeric_limits<double>::quiet_NaN(), [] { return "no number"; });
  worst.see(2, [] { return "two"; });
  CHECK(worst.off == infinity<double>());
  CHECK(worst.where == "no number");
  Worst count;
  count.count(false, [] { return "never"; });
  count.count(true, [] { return "first"; });
  count.count(true, [] { return "second"; });
  CHECK(count.off == 2);
  CHECK(count.where == "first");
}

}  // namespace
}  // namespace texmap::extremes
