// Look-ups: a column and a row in each lane, and what a table has there.
#pragma once
#include "number/number.hpp"

namespace texmap {

/// The three plain numbers that `table` returns for a column and a row; each lane reads its own.
template <class Real, class Table>
[[nodiscard]] inline std::array<Real, 3> look_up(const Table& table, const Real& column,
                                                 const Real& row) {
  const auto columns = all_lanes(column);
  const auto rows = all_lanes(row);
  std::array<std::array<Scalar<Real>, lanes<Real>>, 3> channels;
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const auto entry = table(static_cast<int>(columns[i]), static_cast<int>(rows[i]));
    for (std::size_t k = 0; k < 3; ++k) channels[k][i] = static_cast<Scalar<Real>>(entry[k]);
  }
  const auto packed = [&](std::size_t k) {
    return from_lanes<Real>([&](std::size_t i) { return channels[k][i]; });
  };
  return {packed(0), packed(1), packed(2)};
}

}  // namespace texmap
