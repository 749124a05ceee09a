// The group of (u, v).
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "engine/files/text.hpp"
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

/// The stated worst case of a polynomial, as in common/engine/fast/kernel_plan.cpp.
template <class T>
std::string worst_texels(int degree) {
  return with_uv_mapping(degree, [](const auto& mapping) -> std::string {
    using Mapping = std::decay_t<decltype(mapping)>;
    if constexpr (requires { Mapping::template worst<T>; }) {
      const UvError worst = Mapping::template worst<T>;
      return text("%.1e", std::max(worst.u * 8192, worst.v * 4096));
    }
    return "";
  });
}

}  // namespace

void UvJob::run(const Variant& variant) const {
  run_in_number(*this, variant.number, variant.instructions);
}

Group uv_group() {
  Group group = described("uv");
  const auto add = [&group](const std::string& line, std::string_view letters,
                            const std::string& note, int degree) {
    const double per_run = static_cast<double>(UvJob::rows) * UvJob::repeats;
    for (const Variant& variant : variants_of(letters))
      group.rows.push_back(row_of(
          line, "uv", variant, per_run, [=] { return job_of(degree); }, note));
  };
  add("atan2 and acos", "df", "0.3 in float at the poles", -1);
  add("uv_rtiow", "dfDF", "0.001 in float, 2e-12 in double", 0);
  for (const int degree : {5, 9, 13, 17, 23, 29, 35}) {
    const bool for_float = degree < 20;
    add("degree " + std::to_string(degree), for_float ? "fF" : "dD",
        for_float ? worst_texels<float>(degree) : worst_texels<double>(degree), degree);
  }
  return group;
}

}  // namespace texmap::bench
