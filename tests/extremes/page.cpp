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
    "| certainty | how sure the bound is, from the ladder below |\n"
    "| measured | the worst that was found, against 50-digit arithmetic |\n"
    "| cost | time for one number, as a multiple of what the cell names, timed alternately "
    "in one run, the shortest of several; it depends on the machine, the rest hardly does |\n"
    "\n"
    "The ladder of certainty, from the least to the most that can be said of a bound:\n"
    "\n"
    "1. *sampled*: it held for inputs drawn at random. No row of this page stays here: errors "
    "peak in corners that few draws meet.\n"
    "2. *searched*: it held for the worst that a search found. The search draws inputs, changes "
    "the worst of them a little, keeps what is worse, and goes on\n"
    "   (`tests/extremes/search.cpp`). Of the robust form it found a distance 19 ulp off where "
    "20,000 draws had shown 6. It is no proof.\n"
    "3. *exhaustive*: it held for every input there is; the cell says how many.\n"
    "4. *proven*: it follows from the formula for all inputs of the domain, by a program that "
    "checks proofs (Gappa) or on paper in [numerics.md](numerics.md).\n"
    "5. *per picture*: interval arithmetic encloses the exact answer for each pixel of the picture "
    "that is being drawn, whatever the formulas: `--number interval`\n"
    "   shows where the texel is certain (chapters 01 to 06), and where it says so, no bound is "
    "needed.\n"
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
    page +=
        "| function | number | domain | bound | certainty | measured | cost |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const Claim& claim : family.claims) {
      const Cells cells = measured(claim);
      const std::string star = claim.expect == Expect::beyond ? "*" : "";
      page += "| " + star + claim.function + star + " | " + claim.number + " | " + claim.domain +
              " | " + plain(claim.bound) + " " + claim.unit + " | " + certainty_of(claim) + " | " +
              cells.worst + " | " + cells.cost + " |\n";
    }
  }
  return page;
}

std::string without_measured_cells(const std::string& page) {
  std::istringstream lines(page);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    // A row of a family's table has seven cells, and so eight bars.
    if (std::count(line.begin(), line.end(), '|') == 8) {
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
