// Tests that docs/numbers.md has the claims' functions and bounds; not what was measured.
#include <doctest.h>

#include <fstream>
#include <sstream>

#include "page.hpp"
#include "support/shown_values.hpp"

namespace texmap::extremes {
namespace {

std::string committed_page() {
  std::ifstream file(TEXMAP_TESTS_DIR "/../docs/numbers.md", std::ios::binary);
  REQUIRE_MESSAGE(file, "docs/numbers.md is missing; ./course numbers writes it");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Cells unmeasured(const Claim&) { return {"1", "2", 1}; }

/// The first line in which two pages differ.
std::string first_difference(const std::string& page, const std::string& expected) {
  std::istringstream one(page);
  std::istringstream other(expected);
  for (;;) {
    std::string line;
    std::string wanted;
    const bool more = static_cast<bool>(std::getline(one, line));
    const bool more_wanted = static_cast<bool>(std::getline(other, wanted));
    if (!more && !more_wanted) return "";
    if (line != wanted) return "page: " + line + "\nclaims: " + wanted;
  }
}

TEST_CASE("the page has the functions and bounds of the claims") {
  const std::string difference =
      first_difference(without_measured_cells(committed_page()),
                       without_measured_cells(pages_of(all_claims(), unmeasured).page));
  CHECK_MESSAGE(difference.empty(), difference << "\n./course numbers writes the page again");
}

TEST_CASE("a changed bound or function is noticed, a changed measurement is not") {
  std::vector<Family> families = all_claims();
  const auto now = [&] { return without_measured_cells(pages_of(families, unmeasured).page); };
  const std::string page = now();
  CHECK(without_measured_cells(pages_of(families, [](const Claim&) {
                                 return Cells{"3", "4", 3};
                               }).page) == page);
  Claim& claim = families.back().claims.back();
  claim.bound = 2 * claim.bound + 1;
  CHECK(now() != page);
  claim.bound = all_claims().back().claims.back().bound;
  CHECK(now() == page);
  claim.function = "another";
  CHECK(now() != page);
  families.back().claims.pop_back();
  CHECK(now() != page);
}

TEST_CASE("every cell of the page stays in its column") {
  for (const Family& family : all_claims()) {
    for (const Claim& claim : family.claims) {
      CAPTURE(claim.function);
      CHECK((claim.function + claim.number + claim.domain + claim.unit + claim.cost.relative_to)
                .find('|') == std::string::npos);
      CHECK_FALSE(claim.number.empty());
      CHECK_FALSE(claim.domain.empty());
      CHECK_FALSE(claim.unit.empty());
    }
  }
}

TEST_CASE("a row counts a function's bounds and names the one that was nearest to being reached") {
  const auto claim = [](const char* function, double bound, Expect expect) {
    return Claim{.function = function,
                 .number = "float",
                 .domain = std::string("inputs of ") + function,
                 .bound = bound,
                 .unit = "ulp",
                 .measurement = {},
                 .expect = expect};
  };
  const std::vector<Family> families = {
      {.title = "Rays",
       .introduction = "",
       .claims = {claim("a", 4, Expect::within), claim("a, below", 8, Expect::within),
                  claim("b", 0, Expect::within), claim("c", 1, Expect::beyond)}}};
  const auto shows = [&](double a, double below, const std::string& text) {
    const auto pages = pages_of(families, [=](const Claim& asked) {
      return Cells{"", "", asked.function == "a" ? a : asked.function == "a, below" ? below : 9};
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

TEST_CASE("a cost is the ratio of two times") {
  const auto count_to = [](int n) {
    return [n] {
      volatile double sum = 0;
      for (int i = 0; i < n; ++i) sum = sum + i;
      return static_cast<double>(sum);
    };
  };
  const double ratio = cost_ratio({"a tenth", count_to(200000), count_to(20000)}, 20);
  CHECK(ratio > 5);
  CHECK(ratio < 20);
}

}  // namespace
}  // namespace texmap::extremes
