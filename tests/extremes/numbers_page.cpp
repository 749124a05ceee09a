// numbers_page: measures every claim, with many inputs, and writes the table of docs/numbers.md and
// the whole report.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
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
    std::cerr << "usage: numbers_page PAGE REPORT   measures every claim, renews the table of PAGE "
                 "(docs/numbers.md) and writes REPORT (out/numbers.md)\n";
    return 2;
  }
  using namespace texmap::extremes;
  std::ifstream old(argv[1], std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(old), {}};
  if (page.empty()) {
    std::cerr << "error: cannot read " << argv[1] << '\n';
    return 1;
  }
  const auto [in_short, report] = pages_of(all_claims(), measured);
  for (const auto& [name, text] :
       {std::pair(argv[1], with_in_short(page, in_short)), std::pair(argv[2], report)}) {
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
