// Tests of the claims about functions: each bound holds, is at most 8 times too wide, and other
// forms break it.
#include <doctest.h>

#include <sstream>

#include "claims.hpp"

namespace texmap::extremes {
namespace {

/// Inputs for each claim; fewer where sanitizers or an unoptimized build make references slow.
constexpr int inputs = TEXMAP_EXTREMES_INPUTS;
constexpr bool enough_for_the_worst = inputs >= 1000;

void hold(const Family& family) {
  for (const Claim& claim : family.claims) {
    const Worst worst = claim.worst(inputs, 1);
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
TEST_CASE("arithmetic keeps its bounds") { hold(claims_of_arithmetic()); }

TEST_CASE("a claim is measured alike on every run, and otherwise with another seed") {
  const Claim claim = claims_of_uv().claims[1];
  CHECK(claim.worst(50, 1).off == claim.worst(50, 1).off);
  CHECK(claim.worst(50, 1).off != claim.worst(50, 3).off);
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
