// Tests of engine/run/sampling_options.hpp and gather_session.hpp: what each option takes, what it
// does to a scene, how many samples a limit allows, and what the user is told.
#include <doctest.h>

#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "engine/run/chosen.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/gather_session.hpp"
#include "engine/run/globe_options.hpp"
#include "engine/run/sampling_options.hpp"

namespace texmap::test {
namespace {

/// The options when these words were typed.
template <class Options = SamplingOptions>
Options typed(const std::vector<std::string>& words) {
  Options options;
  CommandLine line("light", "gathers light");
  Offer offer{.line = line};
  options.declare(offer);
  const bool goes_on = line.parse(words);
  CHECK(goes_on);
  return options;
}

std::string complaint(const std::string& option, const std::string& value) {
  try {
    static_cast<void>(typed({option, value}));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST_CASE("each option sets its own number, up to both ends of its range, and no other") {
  struct Row {
    std::string option, below, lowest, highest, above, range;
  };
  const std::vector<Row> table = {
      {"--seed", "-1", "0", "1000000000", "1000000001", "a whole number from 0 to 1000000000"},
      {"--bounces", "0", "1", "1000", "1001", "a whole number from 1 to 1000"},
      {"--time-limit", "-1e-9", "0", "1000000", "1000000.001", "a number from 0 to 1e+06"},
      {"--target-error", "-1e-9", "0", "255", "255.001", "a number from 0 to 255"},
      {"--defocus", "-1e-9", "0", "90", "90.001", "a number from 0 to 90"},
      {"--focus", "0.0009999", "0.001", "1000000", "1000000.001", "a number from 0.001 to 1e+06"},
      {"--shift", "-100.001", "-100", "100", "100.001", "a number from -100 to 100"},
  };
  const auto numbers = [](const SamplingOptions& o) {
    return std::vector<double>{double{1} * o.seed, double{1} * o.bounces,  o.time_limit,
                               o.target_error,     o.lens.defocus_degrees, o.lens.focus_distance,
                               o.lens.shift};
  };
  const std::vector<double> preset = numbers({});
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Row& row = table[i];
    CAPTURE(row.option);
    for (const std::string& end : {row.lowest, row.highest}) {
      std::vector<double> expected = preset;
      expected[i] = std::stod(end);
      CHECK(numbers(typed({row.option, end})) == expected);
    }
    for (const std::string& beyond : {row.below, row.above})
      CHECK(complaint(row.option, beyond) ==
            row.option + " takes " + row.range + ", not '" + beyond + "'");
  }
}

TEST_CASE("each word chooses what it names") {
  for (const auto& [word, kind] : {std::pair{"random", SamplerKind::random},
                                   {"stratified", SamplerKind::stratified},
                                   {"multi-jitter", SamplerKind::multi_jitter},
                                   {"sobol", SamplerKind::sobol}})
    CHECK(typed({"--sampler", word}).sampler == kind);
  for (const auto& [word, light] : {std::pair{"srgb", TexelLight::linear},
                                    {"stb", TexelLight::stb},
                                    {"raw", TexelLight::encoded}})
    CHECK(typed<GlobeOptions>({"--decode", word}).decoding == light);
  for (const auto& [word, transfer] :
       {std::pair{"srgb", Transfer::srgb}, {"sqrt", Transfer::sqrt}, {"2.2", Transfer::stb}})
    CHECK(typed({"--gamma", word}).transfer == transfer);
}

TEST_CASE("the options give a texture its meaning, and the sky the colors of the books") {
  LightTexture texture;
  GradientSky sky;
  typed<GlobeOptions>({"--decode", "raw", "--sky", "gradient"}).apply_to(texture, sky);
  CHECK(texture.light == TexelLight::encoded);
  CHECK(std::tuple(sky.below.b, sky.above.r, sky.above.g, sky.above.b) ==
        std::tuple(1, 0.5, 0.7, 1));
  typed<GlobeOptions>({}).apply_to(texture, sky);
  CHECK(texture.light == TexelLight::linear);
  CHECK(std::tuple(sky.below.r, sky.below.g, sky.above.b) == std::tuple(0.7, 0.8, 1));
  CHECK(sky.is_constant());
}

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
  for (const Row& row :
       {Row{0.001, 0, 200, {8, 8, 16, 16, 32, 32, 44, 44}}, Row{0.001, 0, 2, {1, 1}},
        Row{0.001, 0, 15, {7, 7}}, Row{255 * 0.26, 0, 1 << 20, {8, 8}},
        Row{255 * 0.24, 0, 65, {8, 8, 16, 16, 8, 8}}, Row{0, 1e-9, 1 << 20, {8, 8}}}) {
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

TEST_CASE("what is said of an error is of 255, and nothing where none is known") {
  CHECK(remark_on_error(infinity<double>()).empty());
  CHECK(remark_on_error(0.01) == ", error of the light 2.55 of 255 so far");
  Film film(1, 1, 16);
  CHECK(describe_error(film, {}) == "16 sample per pixel: too few to estimate the error\n");
  film.error = 0.01;
  CHECK(describe_error(film, {}) ==
        "16 samples per pixel, root mean square error of the light at most about 2.55 of 255\n");
  CHECK(describe_error(film, limits(3, 0)) ==
        "16 samples per pixel, root mean square error of the light about 2.55 of 255\n");
}

}  // namespace
}  // namespace texmap::test
