// The options of chapters that gather light over many samples.
#include "engine/app/sampling_options.hpp"

#include "engine/app/command_line.hpp"

namespace texmap {

void SamplingOptions::declare_gathering(CommandLine& line) {
  line.wishes.samples = samples;
  line.wishes.samples_limit = most_samples;
  line.wishes.no_intervals = "it bounds the error of one ray, not the noise of random samples";
  line.choice<SamplerKind>("--sampler", sampler,
                           {{"random", SamplerKind::random},
                            {"stratified", SamplerKind::stratified},
                            {"multi-jitter", SamplerKind::multi_jitter},
                            {"sobol", SamplerKind::sobol}},
                           "the pattern of a pixel's samples; --samples is their number");
  line.whole("--seed", seed, 0, 1000000000,
             "the seed of the random numbers: another seed has different noise");
  line.whole("--bounces", bounces, 1, 1000, "the largest number of bounces of a path");
  line.decimal("--time-limit", time_limit, 0, 1e6,
               "stop after so many seconds, or at --samples if that is earlier; 0 for no limit");
  line.decimal("--target-error", target_error, 0, 255,
               "stop when the estimated mean error is below so many levels of 255, or at "
               "--samples; 0 for no limit");
  line.choice<Transfer>(
      "--gamma", transfer,
      {{"srgb", Transfer::srgb}, {"sqrt", Transfer::sqrt}, {"2.2", Transfer::stb}},
      "how light becomes bytes: the sRGB curve, the books' square root, or the power 1/2.2");
  line.decimal("--defocus", lens.defocus_degrees, 0, 90,
               "blur by a lens: the angle of its cone of rays, in degrees");
  line.decimal("--focus", lens.focus_distance, 0.001, 1e6,
               "the distance at which a lens is sharp; chapter 07's globe begins at 10");
  line.decimal("--shift", lens.shift, -100, 100,
               "blur by motion: the scene moves up by so much during the exposure");
}

void SamplingOptions::declare(CommandLine& line) {
  declare_gathering(line);
  line.wishes.budget =
      "the allowed error: exact, texels=0.01 (a place on the texture) or levels=1 (a byte of the "
      "picture); prints which fast formulas it chooses";
  line.choice<TexelLight>(
      "--decode", decoding,
      {{"srgb", TexelLight::linear}, {"stb", TexelLight::stb}, {"raw", TexelLight::encoded}},
      "how the texture's bytes become light: the sRGB curve, the power 2.2 rounded to bytes (Next "
      "Week since 2024), or the bytes as they are (Next Week before 2024)");
  line.choice<bool>("--sky", gradient, {{"constant", false}, {"gradient", true}},
                    "the sky: uniform, or white below and blue above");
}

void SamplingOptions::apply_to(LightTexture& texture, GradientSky& sky) const {
  texture.light = decoding;
  sky = gradient ? GradientSky{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}}
                 : GradientSky{.below = {0.7, 0.8, 1.0}, .above = {0.7, 0.8, 1.0}};
}

}  // namespace texmap
