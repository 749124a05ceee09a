// What docs/numbers.md says in short, one row a function, and the whole report, one row a claim.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "claims.hpp"

namespace texmap::extremes {

struct Pages {
  std::string in_short;  ///< of docs/numbers.md: the worst of each function
  std::string report;    ///< a table a family, a row a claim
};

/// The page and the report.
///
/// @param measured  gives the worst of a claim that has a measurement
[[nodiscard]] Pages pages_of(const std::vector<Family>& families,
                             const std::function<double(const Claim&)>& measured);

/// docs/numbers.md with another section "In short".
/// Errors: std::out_of_range if the page has no such section.
[[nodiscard]] std::string with_in_short(const std::string& page, const std::string& in_short);

/// The page without its measured cells: what page and claims must agree on.
[[nodiscard]] std::string without_measured_cells(const std::string& page);

}  // namespace texmap::extremes
