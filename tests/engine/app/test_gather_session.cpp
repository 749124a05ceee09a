// Tests of engine/app/gather_session.hpp: how many samples a limit allows, what the user is told.
#include <doctest.h>

#include <set>
#include <string>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/app/gather_session.hpp"

namespace texmap::test {
namespace {

SamplingOptions until_error(double levels) {
  SamplingOptions options;
  options.target_error = levels;
  return options;
}
SamplingOptions until_time(double seconds) {
  SamplingOptions options;
  options.time_limit = seconds;
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

TEST_CASE("without a limit all samples are one pattern, chosen by the seed") {
  for (const int most : {1, 2, 100}) {
    SamplingOptions options;
    options.seed = 7;
    const Gathered all(options, most, 0);
    CHECK(all.samples == std::vector<int>{most});
    CHECK(all.patterns == std::set<std::uint32_t>{7});
    CHECK(all.told == -1);
  }
}

TEST_CASE("a limit draws pairs of patterns that double, each with a pattern of its own") {
  // The error never falls: as many pairs as `most` allows.
  const Gathered all(until_error(0.001), 200, 0.5);
  CHECK(all.samples == std::vector<int>{8, 8, 16, 16, 32, 32});
  CHECK(all.patterns.size() == all.samples.size());
  CHECK(all.film.samples() == 112);
  CHECK(all.film.error == doctest::Approx(0.25).epsilon(1e-9));
  CHECK(all.told == all.film.error);
  CHECK(all.film.light(0, 0).r == doctest::Approx(0.75).epsilon(1e-9));
}

TEST_CASE("the error that was asked for ends it") {
  CHECK(Gathered(until_error(255 * 0.26), 1 << 20, 0.5).samples.size() == 2);
  CHECK(Gathered(until_error(255 * 0.24), 64, 0.5).samples.size() == 4);
  CHECK(Gathered(until_time(1e-9), 1 << 20, 0.5).samples.size() == 2);
}

TEST_CASE(
    "from 2 to 15 samples a limit draws both halves of them, and 1 is refused with the reason") {
  for (int most = 2; most < 16; ++most) {
    const Gathered few(until_error(0.001), most, 0.5);
    CAPTURE(most);
    CHECK(few.samples == std::vector<int>{most / 2, most / 2});
    CHECK(few.film.error == doctest::Approx(0.25).epsilon(1e-9));
  }
  for (const SamplingOptions& options : {until_error(1), until_time(1)}) {
    CHECK_THROWS_WITH_AS(
        Gathered(options, 1, 0.5),
        "--samples 1: --time-limit and --target-error need two samples per pixel to estimate the "
        "error",
        UsageError);
  }
}

TEST_CASE("what is said of an error is in levels, and nothing where none is known") {
  CHECK(remark_on_error(infinity<double>()).empty());
  CHECK(remark_on_error(0.01) == ", mean error 2.55 levels so far");
  Film film(1, 1, 16);
  CHECK(describe_error(film, {}) == "16 sample per pixel: too few to estimate the error\n");
  film.error = 0.01;
  CHECK(describe_error(film, {}) ==
        "16 samples per pixel, mean error at most about 2.55 levels of 255\n");
  CHECK(describe_error(film, until_error(3)) ==
        "16 samples per pixel, mean error about 2.55 levels of 255\n");
}

}  // namespace
}  // namespace texmap::test
