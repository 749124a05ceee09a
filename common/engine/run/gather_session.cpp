// Draws lessons that gather light: the number of samples, and the report.
#include "engine/run/gather_session.hpp"

#include <algorithm>

#include "engine/files/stopwatch.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"

namespace texmap {

Film gather_within_limits(const SamplingOptions& options, int most,
                          std::atomic<double>& error_so_far, const GatherPattern& gather) {
  auto pattern = static_cast<std::uint32_t>(options.seed);
  if (!options.has_limit()) return gather(most, pattern);
  usage_error_if(most < 2,
                 "--samples 1: --time-limit and --target-error need two samples per pixel to "
                 "estimate the error");

  // 2^32 by the golden ratio: the patterns of this seed are not those of the next.
  const auto next = [&] { return pattern += 0x9E3779B9; };
  const Stopwatch watch;
  int pair = std::min(8, most / 2);
  Film first = gather(pair, pattern);
  Film second = gather(pair, next());
  for (;;) {
    const double error = error_of_halves(first, second);
    error_so_far = error;
    const double seconds = watch.milliseconds() / 1000;
    pair = std::min({2 * pair, most_samples, most / 2 - static_cast<int>(first.samples())});
    const bool done = options.target_error > 0 && 255 * error <= options.target_error;
    const double longer = seconds * pair / static_cast<double>(first.samples());
    const bool late = options.time_limit > 0 && seconds + longer > options.time_limit;
    if (done || late || pair == 0) {
      first.add(second);
      first.error = error;
      return first;
    }
    first.add(gather(pair, next()));
    second.add(gather(pair, next()));
  }
}

std::string remark_on_error(double error) {
  return error < infinity<double>() ? text(", error of the light %.2f of 255 so far", 255 * error)
                                    : "";
}

std::string describe_error(const Film& film, const SamplingOptions& options) {
  if (!(film.error < infinity<double>())) {
    return text("%ld sample per pixel: too few to estimate the error\n", film.samples());
  }
  return text("%ld samples per pixel, root mean square error of the light %s %.2f of 255\n",
              film.samples(), options.has_limit() ? "about" : "at most about", film.error * 255);
}

}  // namespace texmap
