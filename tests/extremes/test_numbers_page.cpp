// Tests that docs/numbers.md has the claims' functions and bounds; not what was measured.
#include <doctest.h>

#include <sstream>

#include "page.hpp"
#include "support/shown_values.hpp"
#include "support/temporary_folder.hpp"

namespace texmap::extremes {
namespace {

/// The page as it is, or with other claims' functions and bounds, without what is measured.
std::string page_of(const std::vector<Family>& families, double worst) {
  const std::string page = test::text_in(TEXMAP_TESTS_DIR "/../docs/numbers.md");
  const std::string in_short = pages_of(families, [=](const Claim&) { return worst; }).in_short;
  return without_measured_cells(families.empty() ? page : with_in_short(page, in_short));
}

TEST_CASE("the page has the functions and bounds of the claims") {
  std::istringstream page(page_of({}, 0));
  std::istringstream expected(page_of(all_claims(), 1));
  for (std::string line, wanted; std::getline(expected, wanted);) {
    std::getline(page, line);
    REQUIRE_MESSAGE(line == wanted, "./course numbers writes the page again");
  }
}

TEST_CASE("a changed bound or function is noticed, a changed measurement is not") {
  std::vector<Family> families = all_claims();
  const std::string page = page_of(families, 1);
  CHECK(page_of(families, 3) == page);
  Claim& claim = families.back().claims.back();
  claim.bound = 2 * claim.bound + 1;
  CHECK(page_of(families, 1) != page);
  claim = all_claims().back().claims.back();
  claim.function = "another";
  CHECK(page_of(families, 1) != page);
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
    return pages.in_short.find(text) != std::string::npos;
  };
  const std::string start = "| a | 4 ulp, 8 ulp | 2 searched | ";
  CHECK(shows(3, 5, start + "a, float: 3 of 4 ulp | inputs of a |"));
  CHECK(shows(2, 5, start + "a, below, float: 5 of 8 ulp | inputs of a, below |"));
  CHECK(shows(0, 0, start + "| |"));
  CHECK(shows(3, 5, "3 bounds on 2 functions hold. 1 forms"));
  CHECK_FALSE(shows(3, 5, "| c |"));
}

}  // namespace
}  // namespace texmap::extremes
