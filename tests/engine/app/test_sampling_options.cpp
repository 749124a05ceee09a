// Tests of engine/app/sampling_options.hpp: what each option takes, and what it does to a scene.
#include <doctest.h>

#include <string>
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

TEST_CASE("without options a pixel gets 100 samples of Sobol's pattern, through a pinhole") {
  const SamplingOptions options = typed({});
  CHECK(options.sampler == SamplerKind::sobol);
  CHECK(options.samples == 100);
  CHECK(options.seed == 0);
  CHECK(options.bounces == 50);
  CHECK(options.time_limit == 0);
  CHECK(options.target_error == 0);
  CHECK(options.decoding == TexelLight::linear);
  CHECK(options.transfer == Transfer::srgb);
  CHECK_FALSE(options.lens.blurs());
  CHECK_FALSE(options.gradient);
}

TEST_CASE("each option sets its own number and leaves the others") {
  const SamplingOptions options =
      typed({"--seed", "3", "--bounces", "4", "--time-limit", "5.5", "--target-error", "6.5",
             "--defocus", "7.5", "--focus", "8", "--shift", "-9", "--sky", "gradient"});
  CHECK(options.seed == 3);
  CHECK(options.bounces == 4);
  CHECK(options.time_limit == 5.5);
  CHECK(options.target_error == 6.5);
  CHECK(options.lens.defocus_degrees == 7.5);
  CHECK(options.lens.focus_distance == 8);
  CHECK(options.lens.shift == -9);
  CHECK(options.gradient);
  CHECK(options.samples == 100);
}

TEST_CASE("each number is taken up to both ends of its range, and refused beyond with the range") {
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
  for (const Row& row : table) {
    CAPTURE(row.option);
    CHECK(complaint(row.option, row.lowest) == "nothing was thrown");
    CHECK(complaint(row.option, row.highest) == "nothing was thrown");
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
  CHECK_FALSE(typed({"--sky", "constant"}).gradient);
}

TEST_CASE("the options give a texture its meaning, and the sky the colors of the books") {
  LightTexture texture;
  GradientSky sky;
  const auto is = [](const Rgb& color, double r, double g, double b) {
    return color.r == r && color.g == g && color.b == b;
  };
  typed({"--decode", "raw", "--sky", "gradient"}).apply_to(texture, sky);
  CHECK(texture.light == TexelLight::encoded);
  CHECK(is(sky.below, 1, 1, 1));
  CHECK(is(sky.above, 0.5, 0.7, 1));
  typed({}).apply_to(texture, sky);
  CHECK(texture.light == TexelLight::linear);
  CHECK(is(sky.below, 0.7, 0.8, 1));
  CHECK(is(sky.above, 0.7, 0.8, 1));
}

}  // namespace
}  // namespace texmap::test
