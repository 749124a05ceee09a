// How docs/numbers.md is laid out, and how costs are timed.
#include "page.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

namespace texmap::extremes {
namespace {

constexpr const char* heading =
    "# Numbers\n"
    "\n"
    "What the functions of the course claim, and what was measured. This page is written by "
    "`./course numbers`; a test holds its functions,\n"
    "domains and bounds against the claims in `tests/extremes`, and another measures each "
    "claim and fails when a bound is exceeded.\n"
    "\n"
    "| column | meaning |\n"
    "|---|---|\n"
    "| function | what is claimed about; of a function with several promises, which |\n"
    "| number | `float`, `double`, `extended` (long double, 64 digits in base 2 on this kind "
    "of machine), or a pack of them, compared lane by lane |\n"
    "| domain | the inputs for which the bound holds; sizes are drawn so that every exponent "
    "is as likely as any other, and corners are drawn often |\n"
    "| bound | the largest error that is allowed there; 0 stands for none at all |\n"
    "| measured | the worst that was seen over some ten thousand inputs, against 50-digit "
    "arithmetic |\n"
    "| cost | time for one number, as a multiple of what the cell names, timed alternately "
    "in one run, the shortest of several; it depends on the machine, the rest hardly does |\n"
    "\n"
    "Units: **ulp**, a unit in the last place of the exact result. **u**, the unit roundoff: "
    "half the distance from 1 to the next number, 6e-8 in\n"
    "float, 1.1e-16 in double. **texel**, one of 8192 by 4096 on the whole sphere. Rows in "
    "*italics* are the source documents' or the textbooks' forms in\n"
    "the same test: there the bound is the one that is not kept, and a test fails if they "
    "ever keep it, since it would then see nothing.\n";

std::string plain(double number) {
  std::ostringstream text;
  text.precision(4);
  text << number;
  return text.str();
}

}  // namespace

std::string two_digits(double number) {
  if (number == 0) return "0";
  std::ostringstream text;
  if (number >= 10 && number < 1e7) {
    const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
    text << static_cast<long>(std::round(number / unit) * unit);
    return text.str();
  }
  text.precision(2);
  text << number;
  return text.str();
}

std::string page_of(const std::vector<Family>& families,
                    const std::function<Cells(const Claim&)>& measured) {
  std::string page = heading;
  for (const Family& family : families) {
    page += "\n## " + family.title + "\n\n" + family.introduction + "\n\n";
    page += "| function | number | domain | bound | measured | cost |\n|---|---|---|---|---|---|\n";
    for (const Claim& claim : family.claims) {
      const Cells cells = measured(claim);
      const std::string star = claim.expect == Expect::beyond ? "*" : "";
      page += "| " + star + claim.function + star + " | " + claim.number + " | " + claim.domain +
              " | " + plain(claim.bound) + " " + claim.unit + " | " + cells.worst + " | " +
              cells.cost + " |\n";
    }
  }
  return page;
}

std::string without_measured_cells(const std::string& page) {
  std::istringstream lines(page);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    // A row of a family's table has six cells, and so seven bars.
    if (std::count(line.begin(), line.end(), '|') == 7) {
      line.resize(line.rfind('|', line.size() - 2));
      line.resize(line.rfind('|'));
    }
    result += line + '\n';
  }
  return result;
}

double cost_ratio(const Cost& cost, int rounds) {
  double ours = std::numeric_limits<double>::infinity();
  double theirs = ours;
  volatile double kept = 0;  // what is computed must be needed
  const auto seconds = [&kept](const std::function<double()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    kept = kept + work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  for (int round = 0; round < rounds; ++round) {
    ours = std::min(ours, seconds(cost.work));
    theirs = std::min(theirs, seconds(cost.reference));
  }
  return ours / theirs;
}

}  // namespace texmap::extremes
