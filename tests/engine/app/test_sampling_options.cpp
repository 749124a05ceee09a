// Tests of engine/app/sampling_options.hpp: what each option takes, and what it does to a scene.
#include <doctest.h>

#include <string>
#include <tuple>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/app/sampling_options.hpp"

namespace texmap::test {
namespace {

/// The options when these words were typed.
SamplingOptions typed(const std::vector<std::string>& words) {
  SamplingOptions options;
  CommandLine line("light", "gathers light");
  options.declare(line);
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
    CHECK(typed({"--decode", word}).decoding == light);
  for (const auto& [word, transfer] :
       {std::pair{"srgb", Transfer::srgb}, {"sqrt", Transfer::sqrt}, {"2.2", Transfer::stb}})
    CHECK(typed({"--gamma", word}).transfer == transfer);
}

TEST_CASE("the options give a texture its meaning, and the sky the colors of the books") {
  LightTexture texture;
  GradientSky sky;
  typed({"--decode", "raw", "--sky", "gradient"}).apply_to(texture, sky);
  CHECK(texture.light == TexelLight::encoded);
  CHECK(std::tuple(sky.below.b, sky.above.r, sky.above.g, sky.above.b) ==
        std::tuple(1, 0.5, 0.7, 1));
  typed({}).apply_to(texture, sky);
  CHECK(texture.light == TexelLight::linear);
  CHECK(std::tuple(sky.below.r, sky.below.g, sky.above.b) == std::tuple(0.7, 0.8, 1));
  CHECK(sky.is_constant());
}

}  // namespace
}  // namespace texmap::test
