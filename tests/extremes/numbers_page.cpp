// numbers_page: measures every claim, with many inputs, and its cost, and writes docs/numbers.md
// and the whole report.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>

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
  if (argc != 3) {
    std::cerr
        << "usage: numbers_page PAGE REPORT   measures every claim and writes both, as a rule "
           "docs/numbers.md and out/numbers.md\n";
    return 2;
  }
  const auto [page, report] = texmap::extremes::pages_of(texmap::extremes::all_claims(), measured);
  for (const auto& [name, text] : {std::pair(argv[1], page), std::pair(argv[2], report)}) {
    std::error_code already_there;
    std::filesystem::create_directories(std::filesystem::path(name).parent_path(), already_there);
    std::ofstream file(name, std::ios::binary);
    file << text << std::flush;
    if (file) continue;
    std::cerr << "error: cannot write " << name << '\n';
    return 1;
  }
  return 0;
}
