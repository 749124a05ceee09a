// Tests that docs/numbers.md has the claims' functions and bounds; not what was measured.
#include <doctest.h>

#include <fstream>
#include <sstream>

#include "page.hpp"
#include "support/shown_values.hpp"

namespace texmap::extremes {
namespace {

std::string without_measurements(const std::vector<Family>& families, double worst) {
  return without_measured_cells(pages_of(families, [=](const Claim&) { return worst; }).page);
}

TEST_CASE("the page has the functions and bounds of the claims") {
  std::ifstream file(TEXMAP_TESTS_DIR "/../docs/numbers.md", std::ios::binary);
  REQUIRE_MESSAGE(file, "docs/numbers.md is missing; ./course numbers writes it");
  std::ostringstream text;
  text << file.rdbuf();
  std::istringstream page(without_measured_cells(text.str()));
  std::istringstream expected(without_measurements(all_claims(), 1));
  while (page && expected) {
    std::string line;
    std::string wanted;
    std::getline(page, line);
    std::getline(expected, wanted);
    REQUIRE_MESSAGE(line == wanted, "./course numbers writes the page again");
  }
  CHECK(!page == !expected);
}

TEST_CASE("a changed bound or function is noticed, a changed measurement is not") {
  std::vector<Family> families = all_claims();
  const std::string page = without_measurements(families, 1);
  CHECK(without_measurements(families, 3) == page);
  const auto changed = [&](const Claim& claim) {
    families.back().claims.back() = claim;
    return without_measurements(families, 1) != page;
  };
  const Claim claim = families.back().claims.back();
  Claim other = claim;
  other.bound = 2 * claim.bound + 1;
  CHECK(changed(other));
  CHECK_FALSE(changed(claim));
  other = claim;
  other.function = "another";
  CHECK(changed(other));
}

TEST_CASE("every cell of the page stays in its column") {
  for (const Family& family : all_claims()) {
    for (const Claim& claim : family.claims) {
      CAPTURE(claim.function);
      CHECK((claim.function + claim.number + claim.domain + claim.unit).find('|') ==
            std::string::npos);
      CHECK_FALSE((claim.number.empty() || claim.domain.empty() || claim.unit.empty()));
    }
  }
}

TEST_CASE("a row counts a function's bounds and names the one that was nearest to being reached") {
  Family rays{"Rays", ""};
  const auto add = [&](const std::string& function, double bound) -> Claim& {
    return rays.add<float>(function, "inputs of " + function, {bound, "ulp"}, {});
  };
  add("a", 4);
  add("a, below", 8);
  add("b", 0);
  add("c", 1).expect = Expect::beyond;
  const auto shows = [&](double a, double below, const std::string& text) {
    const auto pages = pages_of({rays}, [=](const Claim& asked) {
      return asked.function == "a" ? a : asked.function == "a, below" ? below : 9;
    });
    return pages.page.find(text) != std::string::npos;
  };
  const std::string start = "| a | 4 ulp, 8 ulp | 2 searched | ";
  CHECK(shows(3, 5, start + "a, float: 3 of 4 ulp | inputs of a |"));
  CHECK(shows(2, 5, start + "a, below, float: 5 of 8 ulp | inputs of a, below |"));
  CHECK(shows(0, 0, start + "| |"));
  CHECK(shows(3, 5, "3 bounds on 2 functions hold. 1 forms"));
  CHECK_FALSE(shows(3, 5, "| c |"));
}

TEST_CASE("measured numbers have two digits") {
  CHECK(two_digits(0) == "0");
  CHECK(two_digits(0.000714) == "0.00071");
  CHECK(two_digits(3.4159) == "3.4");
  CHECK(two_digits(12.7) == "13");
  CHECK(two_digits(31849) == "32000");
  CHECK(two_digits(2.5e18) == "2.5e+18");
}

}  // namespace
}  // namespace texmap::extremes
