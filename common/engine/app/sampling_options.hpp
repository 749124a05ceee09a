// The options of chapters that gather light over many samples.
#pragma once
#include "engine/render/transfer.hpp"
#include "sampling/sampler_kind.hpp"
#include "scene/lens.hpp"
#include "scene/sky.hpp"
#include "texture/light_texture.hpp"

namespace texmap {

class CommandLine;

/// The user's choices of samples and light.
struct SamplingOptions {
  SamplerKind sampler = SamplerKind::sobol;
  int samples = 100;  ///< rays per pixel, unless --samples is given
  int seed = 0;
  int bounces = 50;
  double time_limit = 0;    ///< seconds; 0: no limit
  double target_error = 0;  ///< in levels of 255; 0: no limit
  TexelLight decoding = TexelLight::linear;
  Transfer transfer = Transfer::srgb;
  Lens lens;
  bool gradient = false;  ///< a sky that changes; else uniform

  void declare(CommandLine& line);
  /// The options that are not about a texture or its sky: samples, limits, lens.
  void declare_gathering(CommandLine& line);
  /// Sets the meaning of the texture's bytes, and the sky.
  void apply_to(LightTexture& texture, GradientSky& sky) const;
};

}  // namespace texmap
