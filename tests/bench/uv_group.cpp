// The group of (u, v).
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "uv_job.hpp"

namespace texmap::bench {
namespace {

/// A job on unit vectors, evenly spread over the sphere and the same each time.
std::shared_ptr<const UvJob> job_of(int degree) {
  const auto job = std::make_shared<UvJob>(degree);
  auto& [floats, doubles] = job->columns;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (std::size_t row = 0; row < UvJob::rows; ++row) {
    const double turn = 2 * std::numbers::pi * part(random);
    const double height = 2 * part(random) - 1;
    const double radius = std::sqrt(1 - height * height);
    floats.x[row] = static_cast<float>(doubles.x[row] = radius * std::cos(turn));
    floats.y[row] = static_cast<float>(doubles.y[row] = radius * std::sin(turn));
    floats.z[row] = static_cast<float>(doubles.z[row] = height);
  }
  return job;
}

}  // namespace

void UvJob::run(const Variant& variant) const {
  run_in_number(*this, variant.number, variant.instructions);
}

Group uv_group() {
  Group group = described("uv");
  const auto add = [&group](const std::string& line, std::string_view letters, int degree) {
    const double per_run = static_cast<double>(UvJob::rows) * UvJob::repeats;
    for (const Variant& variant : variants_of(letters))
      group.rows.push_back(row_of(line, "uv", variant, per_run, [=] { return job_of(degree); }));
  };
  add("atan2 and acos", "df", -1);
  add("uv_rtiow", "dfDF", 0);
  add("degree 17", "fF", 17);
  add("degree 35", "dD", 35);
  return group;
}

}  // namespace texmap::bench
