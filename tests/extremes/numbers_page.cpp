// numbers_page: measures every claim, with many inputs, and its cost, and writes docs/numbers.md.
#include <fstream>
#include <iostream>
#include <string>

#include "claims.hpp"
#include "page.hpp"

namespace {

using texmap::extremes::Cells;
using texmap::extremes::Claim;
using texmap::extremes::Expect;

constexpr int inputs = 20000;

Cells measured(const Claim& claim) {
  if (!claim.certainty.empty()) return {"", "", 0};
  std::cerr << claim.function << ", " << claim.number << '\n';
  const texmap::extremes::Worst seen = searched(claim.measurement, inputs, 2);
  const double worst = seen.off;
  if ((worst <= claim.bound) != (claim.expect == Expect::within)) {
    std::cerr << "warning: " << worst << " for a bound of " << claim.bound << ' ' << claim.unit
              << ", at " << seen.where << '\n';
  }
  Cells cells{texmap::extremes::two_digits(worst), "", worst};
  if (claim.cost.work) {
    cells.cost = texmap::extremes::two_digits(texmap::extremes::cost_ratio(claim.cost, 200)) +
                 " × " + claim.cost.relative_to;
  }
  return cells;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: numbers_page FILE   measures every claim and writes FILE, docs/numbers.md "
                 "as a rule\n";
    return 2;
  }
  const std::string page = texmap::extremes::page_of(texmap::extremes::all_claims(), measured);
  std::ofstream file(argv[1], std::ios::binary);
  file << page << std::flush;
  if (file) return 0;
  std::cerr << "error: cannot write " << argv[1] << '\n';
  return 1;
}
