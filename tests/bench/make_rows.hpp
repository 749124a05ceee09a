// Makes rows from jobs.
#pragma once
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "bench.hpp"
#include "jobs.hpp"
#include "variants.hpp"

namespace texmap::bench {

/// A row for a job.
///
/// @param make  called when the row's turn comes, makes the job and what it needs: gives a pointer
///              to something with run(variant)
template <class Make>
[[nodiscard]] Row row_of(std::string line, std::string set, const Variant& variant, double items,
                         Make make, std::string note = "") {
  Row row{.line = std::move(line),
          .column = std::string(variant.name),
          .set = std::move(set),
          .items = items,
          .prepare = {},
          .note = std::move(note)};
  if (is_here(variant)) {
    row.prepare = [make, variant]() -> Work {
      auto ready = make();
      return [ready, variant] { ready->run(variant); };
    };
  }
  return row;
}

/// A job with the columns that it reads and writes.
template <class Job>
struct WithColumns {
  Columns input, output;
  Job job;

  void run(const Variant& variant) { bench::run(job, variant); }
};

/// Columns with the coordinates of unit vectors, evenly spread over the sphere and the same each
/// time.
inline void fill_with_directions(Columns& columns, std::size_t first) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    const double turn = 2 * std::numbers::pi * part(random);
    const double height = 2 * part(random) - 1;
    const double radius = std::sqrt(1 - height * height);
    const Vec3<double> p{radius * std::cos(turn), radius * std::sin(turn), height};
    columns.set(first, row, p.x);
    columns.set(first + 1, row, p.y);
    columns.set(first + 2, row, p.z);
  }
}

}  // namespace texmap::bench
