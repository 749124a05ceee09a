// Draws lessons that gather light: the number of samples, and the report.
#include "engine/run/gather_session.hpp"

#include <algorithm>
#include <chrono>

#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"

namespace texmap {

Film gather_within_limits(const SamplingOptions& options, int most,
                          std::atomic<double>& error_so_far, const GatherPattern& gather) {
  auto pattern = static_cast<std::uint32_t>(options.seed);
  if (options.time_limit == 0 && options.target_error == 0) return gather(most, pattern);
  usage_error_if(most < 2,
                 "--samples 1: --time-limit and --target-error need two samples per pixel to "
                 "estimate the error");

  const auto start = std::chrono::steady_clock::now();
  int pair = std::min(8, most / 2);
  Film first = gather(pair, pattern);
  Film second = gather(pair, ++pattern);
  for (;;) {
    const double error = error_of_halves(first, second);
    error_so_far = error;
    pair = std::min(2 * pair, most_samples);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool done = options.target_error > 0 && 255 * error <= options.target_error;
    const double next = seconds * pair / static_cast<double>(first.samples());
    const bool late = options.time_limit > 0 && seconds + next > options.time_limit;
    if (done || late || 2 * (first.samples() + pair) > most) {
      first.add(second);
      first.error = error;
      return first;
    }
    first.add(gather(pair, ++pattern));
    second.add(gather(pair, ++pattern));
  }
}

std::string remark_on_error(double error) {
  return error < infinity<double>() ? text(", mean error %.2f levels so far", 255 * error) : "";
}

std::string describe_error(const Film& film, const SamplingOptions& options) {
  if (!(film.error < infinity<double>())) {
    return text("%ld sample per pixel: too few to estimate the error\n", film.samples());
  }
  const bool limited = options.time_limit > 0 || options.target_error > 0;
  return text("%ld samples per pixel, mean error %s %.2f levels of 255\n", film.samples(),
              limited ? "about" : "at most about", film.error * 255);
}

}  // namespace texmap
