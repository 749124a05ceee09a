// Tests of the claims about functions: each bound holds, is at most 8 times too wide, and other
// forms break it.
#include <doctest.h>

#include <atomic>
#include <sstream>
#include <thread>

#include "claims.hpp"
#include "support/shown_values.hpp"

namespace texmap::extremes {

/// Inputs for each claim; fewer where sanitizers or an unoptimized build make references slow.
constexpr int inputs = TEXMAP_EXTREMES_INPUTS;
constexpr bool enough_for_the_worst = inputs >= 1000;

TEST_CASE("every bound that the page shows is searched here, and holds; other forms break it") {
  std::vector<Claim> claims;
  for (const Family& family : all_claims()) {
    for (const Claim& claim : family.claims) {
      const bool measured = claim.measurement.one_input || claim.measurement.every_input;
      CHECK_MESSAGE(measured == claim.certainty.empty(), claim.function);
      if (measured) claims.push_back(claim);
    }
  }
  std::vector<Worst> found(claims.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < claims.size();)
      found[i] = searched(claims[i].measurement, inputs, 1);
  };
  std::thread other(work);
  work();
  other.join();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Claim& claim = claims[i];
    std::ostringstream report;
    report << claim.function << ", " << claim.number << ": " << found[i].off << " " << claim.unit
           << " for a bound of " << claim.bound;
    MESSAGE(report.str());
    INFO("domain: " << claim.domain);
    INFO("at: " << found[i].where);
    INFO(report.str());
    if (claim.expect == Expect::beyond) {
      CHECK_MESSAGE(found[i].off > claim.bound, "the measurement does not see what it should see");
      continue;
    }
    CHECK(found[i].off <= claim.bound);
    if (enough_for_the_worst) CHECK_MESSAGE(found[i].off >= claim.bound / 8, "the bound is idle");
  }
}

TEST_CASE("the units of a number are its own") {
  CHECK(ulp_at<double>(1) == Digits50(std::numeric_limits<double>::epsilon()));
  CHECK(ulp_at<float>(Digits50(1.5)) == Digits50(std::numeric_limits<float>::epsilon()));
  CHECK(ulp_at<double>(0) == Digits50(std::numeric_limits<double>::denorm_min()));
  CHECK(ulp_at<float>(Digits50("1e-60")) == Digits50(std::numeric_limits<float>::denorm_min()));
  CHECK(ulp_at<long double>(2) == 2 * Digits50(std::numeric_limits<long double>::epsilon()));
  CHECK(ulps_off(1.0F, Digits50(1)) == 0);
  CHECK(ulps_off(std::nextafter(1.0F, 2.0F), Digits50(1)) == 1);
  CHECK(ulps_off(std::numeric_limits<double>::quiet_NaN(), Digits50(1)) == infinity<double>());
  CHECK(relative_off(1 + std::numeric_limits<float>::epsilon(), Digits50(1)) == 2);
}

TEST_CASE("the search finds what draws do not meet: a peak 1e-7 wide; the same on every run") {
  // Highest at 0.7, and above 0.99 only within 1e-7 of it.
  const Measurement peak = worst_over(1, [](Dice& dice, Worst& worst) {
    const double x = dice.between(0, 1);
    worst.see(1 / (1 + std::sqrt(std::fabs(x - 0.7)) * 31), [&] { return described(x); });
  });
  const Worst found = searched(peak, 2000, 1);
  CHECK(found.off > 0.99);
  CHECK(found.where.substr(0, 6) == "0.7000");
  CHECK(searched(peak, 50, 1).off == searched(peak, 50, 1).off);
  CHECK(searched(peak, 50, 1).off != searched(peak, 50, 3).off);
}

TEST_CASE("a NaN is worse than any number, and the first input that fails is kept") {
  Worst worst;
  worst.see(1., [] { return "one"; });
  worst.see(std::numeric_limits<double>::quiet_NaN(), [] { return "no number"; });
  worst.see(2., [] { return "two"; });
  CHECK(worst.off == infinity<double>());
  CHECK(worst.where == "no number");
  Worst count;
  count.see(false, [] { return "never"; });
  count.see(true, [] { return "first"; });
  count.see(true, [] { return "second"; });
  CHECK(count.off == 2);
  CHECK(count.where == "first");
}

}  // namespace texmap::extremes
