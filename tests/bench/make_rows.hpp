// Makes rows from jobs.
#pragma once
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "bench.hpp"
#include "directions.hpp"
#include "jobs.hpp"
#include "ways.hpp"

namespace texmap::bench {

/// A row for a job.
///
/// @param make  called when the row's turn comes, makes the job and what it needs: gives a pointer to something with run(way)
template <class Make>
[[nodiscard]] Row row_of(std::string line, std::string set, const Way& way, double items, Make make, std::string note = "") {
  Row row{.line = std::move(line),
          .column = std::string(way.name),
          .set = std::move(set),
          .items = items,
          .prepare = {},
          .note = std::move(note)};
  if (is_here(way)) {
    row.prepare = [make, way]() -> Work {
      auto ready = make();
      return [ready, way] { ready->run(way); };
    };
  }
  return row;
}

/// A job with the columns that it reads and writes.
template <class Job>
struct WithColumns {
  Columns input, output;
  Job job;

  void run(const Way& way) { bench::run(job, way); }
};

/// Columns with the coordinates of unit vectors, evenly spread over the sphere and the same each time.
inline void fill_with_directions(Columns& columns, std::size_t first) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    const Vec3<double> p = uniform_direction(Sample2<double>{part(random), part(random)});
    columns.set(first, row, p.x);
    columns.set(first + 1, row, p.y);
    columns.set(first + 2, row, p.z);
  }
}

}  // namespace texmap::bench
