// How docs/numbers.md is laid out, and how costs are timed.
#include "page.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace texmap::extremes {
namespace {

constexpr const char* title =
    "# Numbers\n"
    "\n"
    "What the functions of the course claim, and what was measured. This page is written by "
    "`./course numbers`; a test holds its functions,\n"
    "domains and bounds against the claims in `tests/extremes`, and another measures each "
    "claim and fails when a bound is exceeded.\n";

constexpr const char* how_to_read =
    "\n"
    "## How to read the tables\n"
    "\n"
    "| column | meaning |\n"
    "|---|---|\n"
    "| function | what is claimed about; of a function with several promises, which |\n"
    "| number | `float`, `double`, `extended` (long double, 64 digits in base 2 on this kind "
    "of machine), or a pack of them, compared lane by lane |\n"
    "| domain | the inputs for which the bound holds; sizes are drawn so that every exponent "
    "is as likely as any other, and corners are drawn often |\n"
    "| bound | the largest error that is allowed there; 0 means that no error is allowed |\n"
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

/// A heading's address on the page: small letters, a hyphen for each blank.
std::string address_of(const std::string& heading) {
  std::string address = "#";
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c))) {
      address += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ') {
      address += '-';
    }
  }
  return address;
}

/// A family's claims, counted.
struct Counts {
  std::set<std::string> functions{};  ///< of the bounds that hold
  long hold = 0;
  long broken = 0;                      ///< bounds that other forms must break
  std::map<std::string, long> rungs{};  ///< of the ladder of certainty

  void add(const Claim& claim) {
    if (claim.expect == Expect::beyond) {
      ++broken;
      return;
    }
    ++hold;
    functions.insert(claim.function.substr(0, claim.function.find(',')));
    const std::string certainty = certainty_of(claim);
    ++rungs[certainty.substr(0, certainty.find_first_of(" ,"))];
  }
};

/// Of a family, the bound that holds and was nearest to being reached.
struct NearestBound {
  const Claim* claim = nullptr;
  double off = 0;

  void see(const Claim& now, double measured) {
    if (now.expect == Expect::beyond || !(now.bound > 0) || !(measured > 0)) return;
    if (claim != nullptr && measured / now.bound <= off / claim->bound) return;
    claim = &now;
    off = measured;
  }
};

/// A row of the summary; like those of the other tables it ends with two measured cells.
std::string summary_of(const Family& family, const Counts& counts, const NearestBound& nearest) {
  std::string row = "| [" + family.title + "](" + address_of(family.title) + ") | " +
                    std::to_string(counts.functions.size()) + " | " + std::to_string(counts.hold) +
                    " | " + std::to_string(counts.broken) + " | ";
  std::string comma;
  for (const auto& [rung, count] : counts.rungs) {
    row += comma + std::to_string(count) + " " + rung;
    comma = ", ";
  }
  if (nearest.claim == nullptr) {
    const bool elsewhere = std::ranges::all_of(
        family.claims, [](const Claim& claim) { return !claim.certainty.empty(); });
    return row + (elsewhere ? " | measured by other tests | |\n" : " | no bound but 0 | |\n");
  }
  const Claim& claim = *nearest.claim;
  return row + " | " + claim.function + ", " + claim.number + ": " + two_digits(nearest.off) +
         " of " + plain(claim.bound) + " " + claim.unit + " | " + claim.domain + " |\n";
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
  std::string rows;
  std::string tables;
  Counts all;
  for (const Family& family : families) {
    tables += "\n## " + family.title + "\n\n" + family.introduction + "\n\n";
    tables +=
        "| function | number | domain | bound | certainty | measured | cost |\n"
        "|---|---|---|---|---|---|---|\n";
    Counts counts;
    NearestBound nearest;
    for (const Claim& claim : family.claims) {
      const Cells cells = measured(claim);
      counts.add(claim);
      all.add(claim);
      nearest.see(claim, cells.off);
      const std::string star = claim.expect == Expect::beyond ? "*" : "";
      tables += "| " + star + claim.function + star + " | " + claim.number + " | " + claim.domain +
                " | " + plain(claim.bound) + " " + claim.unit + " | " + certainty_of(claim) +
                " | " + cells.worst + " | " + cells.cost + " |\n";
    }
    rows += summary_of(family, counts, nearest);
  }
  return title +
         ("\n## In short\n\n" + std::to_string(all.hold) + " bounds on " +
          std::to_string(all.functions.size()) + " functions hold. " + std::to_string(all.broken) +
          " rows are forms from the source documents or from textbooks that break such a "
          "bound,\nas they should: they show that the measurement can see an error. For "
          "each family the table names the bound that was nearest\nto being reached, and the "
          "inputs that it holds for. It leaves out bounds of 0, which allow no error at "
          "all.\n\n"
          "| family | functions | bounds that hold | forms that break theirs | how sure | "
          "nearest to its bound | for these inputs |\n"
          "|---|---|---|---|---|---|---|\n") +
         rows + how_to_read + tables;
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
