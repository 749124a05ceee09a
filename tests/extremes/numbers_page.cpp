// numbers_page: measures every claim, with many inputs, and writes docs/numbers.md
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

using texmap::extremes::Claim;
using texmap::extremes::Expect;

constexpr int inputs = 20000;

double measured(const Claim& claim) {
  std::cerr << claim.function << ", " << claim.number << '\n';
  const texmap::extremes::Worst seen = searched(claim.measurement, inputs, 2);
  const double worst = seen.off;
  if ((worst <= claim.bound) != (claim.expect == Expect::within)) {
    std::cerr << "warning: " << worst << " for a bound of " << claim.bound << ' ' << claim.unit
              << ", at " << seen.where << '\n';
  }
  return worst;
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
