// Tests of engine/app/gather_session.hpp: how many samples a limit allows, what the user is told.
#include <doctest.h>

#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/app/gather_session.hpp"

namespace texmap::test {
namespace {

SamplingOptions limits(double levels, double seconds) {
  SamplingOptions options;
  options.target_error = levels;
  options.time_limit = seconds;
  options.seed = 7;
  return options;
}

/// What the options gather from films of one pixel; every other pattern is darker by `difference`.
struct Gathered {
  std::vector<int> samples;
  std::set<std::uint32_t> patterns;
  std::atomic<double> told = -1;
  Film film{1, 1, 0};

  Gathered(const SamplingOptions& options, int most, double difference) {
    film = gather_within_limits(options, most, told, [&](int count, std::uint32_t pattern) {
      samples.push_back(count);
      patterns.insert(pattern);
      Film made(1, 1, count);
      const double light = samples.size() % 2 == 1 ? 1 : 1 - difference;
      made.set_light(0, 0, {light, light, light});
      return made;
    });
  }
};

TEST_CASE(
    "a limit draws pairs of patterns that double, each with a pattern of its own, until the error, "
    "the time or the number is reached") {
  struct Row {
    double levels, seconds;
    int most;
    std::vector<int> samples;
  };
  for (const Row& row : {Row{0.001, 0, 200, {8, 8, 16, 16, 32, 32}}, Row{0.001, 0, 2, {1, 1}},
                         Row{0.001, 0, 15, {7, 7}}, Row{255 * 0.26, 0, 1 << 20, {8, 8}},
                         Row{255 * 0.24, 0, 64, {8, 8, 16, 16}}, Row{0, 1e-9, 1 << 20, {8, 8}}}) {
    const Gathered all(limits(row.levels, row.seconds), row.most, 0.5);
    CHECK(all.samples == row.samples);
    CHECK(all.patterns.size() == all.samples.size());
    CHECK(all.film.samples() == std::accumulate(row.samples.begin(), row.samples.end(), 0));
    CHECK(all.film.error == doctest::Approx(0.25).epsilon(1e-9));
    CHECK(all.told == all.film.error);
    CHECK(all.film.light(0, 0).r == doctest::Approx(0.75).epsilon(1e-9));
  }
  CHECK(Gathered(limits(0, 0), 100, 0).patterns == std::set<std::uint32_t>{7});  // the seed alone
  CHECK_THROWS_WITH_AS(
      Gathered(limits(0, 1), 1, 0.5),
      "--samples 1: --time-limit and --target-error need two samples per pixel to estimate the "
      "error",
      UsageError);
}

TEST_CASE("what is said of an error is in levels, and nothing where none is known") {
  CHECK(remark_on_error(infinity<double>()).empty());
  CHECK(remark_on_error(0.01) == ", mean error 2.55 levels so far");
  Film film(1, 1, 16);
  CHECK(describe_error(film, {}) == "16 sample per pixel: too few to estimate the error\n");
  film.error = 0.01;
  CHECK(describe_error(film, {}) ==
        "16 samples per pixel, mean error at most about 2.55 levels of 255\n");
  CHECK(describe_error(film, limits(3, 0)) ==
        "16 samples per pixel, mean error about 2.55 levels of 255\n");
}

}  // namespace
}  // namespace texmap::test
