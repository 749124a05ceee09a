// The page docs/numbers.md, one row a function, and the whole report, one row a claim.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "claims.hpp"

namespace texmap::extremes {

/// The two cells of a row that are measured.
struct Cells {
  std::string worst;
  std::string cost;
  double off = 0;  ///< the number behind `worst`, for the summary; 0 where nothing was measured
};

struct Pages {
  std::string page;    ///< the worst of each function, and how to read it
  std::string report;  ///< a table a family, a row a claim
};

/// The page and the report. What is measured of a claim is what `measured` says of it.
[[nodiscard]] Pages pages_of(const std::vector<Family>& families,
                             const std::function<Cells(const Claim&)>& measured);

/// The page without its measured cells: what page and claims must agree on.
[[nodiscard]] std::string without_measured_cells(const std::string& page);

/// A number with two digits, such as 0.00071 or 3.4.
[[nodiscard]] std::string two_digits(double number);

/// Ratio of a function's time to its reference's: both run alternately, the shortest times count.
[[nodiscard]] double cost_ratio(const Cost& cost, int rounds);

}  // namespace texmap::extremes
