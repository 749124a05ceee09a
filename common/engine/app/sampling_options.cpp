// The options of chapters that gather light over many samples.
#include "engine/app/sampling_options.hpp"

#include "engine/app/command_line.hpp"

namespace texmap {

void SamplingOptions::declare_gathering(CommandLine& line) {
  line.choice<SamplerKind>("--sampler", sampler,
                           {{"random", SamplerKind::random},
                            {"stratified", SamplerKind::stratified},
                            {"multi-jitter", SamplerKind::multi_jitter},
                            {"sobol", SamplerKind::sobol}},
                           "how samples are spread; --samples says how many");
  line.whole("--seed", seed, 0, 1000000000,
             "another number draws the same light with other errors");
  line.whole("--bounces", bounces, 1, 1000, "how often a path may bounce");
  line.decimal("--time-limit", time_limit, 0, 1e6,
               "stop after so many seconds; --samples is then the most");
  line.decimal("--target-error", target_error, 0, 255,
               "stop when the mean error is below so many levels of 255");
  line.choice<Transfer>(
      "--gamma", transfer,
      {{"srgb", Transfer::srgb}, {"sqrt", Transfer::sqrt}, {"2.2", Transfer::stb}},
      "from light to bytes: the sRGB curve, the books' square root, or the power 1/2.2");
  line.decimal("--defocus", lens.defocus_degrees, 0, 90,
               "angle of the cone of rays through a lens, in degrees");
  line.decimal("--focus", lens.focus_distance, 0.001, 1e6,
               "distance of what a lens draws sharp; chapter 07's globe begins at 10");
  line.decimal("--shift", lens.shift, -100, 100,
               "the scene moves up by so much during the exposure");
}

void SamplingOptions::declare(CommandLine& line) {
  declare_gathering(line);
  line.choice<TexelLight>(
      "--decode", decoding,
      {{"srgb", TexelLight::linear}, {"stb", TexelLight::stb}, {"raw", TexelLight::encoded}},
      "from the texture's bytes to light: the sRGB curve, the power 2.2 kept in bytes (Next Week "
      "since 2024), or the bytes as they are (before)");
  line.choice<bool>("--sky", gradient, {{"constant", false}, {"gradient", true}},
                    "uniform, or white below and blue above");
}

void SamplingOptions::apply_to(ImageTexture& texture, GradientSky<>& sky) const {
  texture.light = decoding;
  sky = gradient ? GradientSky<>{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}}
                 : GradientSky<>{.below = {0.7, 0.8, 1.0}, .above = {0.7, 0.8, 1.0}};
}

}  // namespace texmap
