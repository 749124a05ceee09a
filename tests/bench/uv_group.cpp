// The group of (u, v).
#include <memory>

#include "support/dice.hpp"
#include "uv_job.hpp"

namespace texmap::bench {
namespace {

/// A job on unit vectors, evenly spread over the sphere and the same each time.
std::shared_ptr<const UvJob> job_of(int degree) {
  const auto job = std::make_shared<UvJob>(degree);
  auto& [floats, doubles] = job->columns;
  test::Dice dice;
  for (std::size_t row = 0; row < UvJob::rows; ++row) {
    const Vec3d p = dice.direction<double>();
    floats.x[row] = static_cast<float>(doubles.x[row] = p.x);
    floats.y[row] = static_cast<float>(doubles.y[row] = p.y);
    floats.z[row] = static_cast<float>(doubles.z[row] = p.z);
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
