// The options of chapters that gather light over many samples.
#pragma once
#include <vector>

#include "engine/render/transfer.hpp"
#include "sampling/sampler_kind.hpp"
#include "scene/lens.hpp"
#include "scene/stage.hpp"
#include "texture/light_texture.hpp"

namespace texmap {

class CommandLine;

struct SamplingOptions {
  SamplerKind sampler = SamplerKind::sobol;
  int samples = 64;  ///< rays per pixel, unless --samples is given
  int seed = 0;
  int bounces = 50;
  double time_limit = 0;    ///< seconds; 0: no limit
  double target_error = 0;  ///< in levels of 255; 0: no limit
  TexelLight decoding = TexelLight::linear;
  Transfer transfer = Transfer::srgb;
  Lens lens{};
  bool book = false;      ///< the book's scene: the globe alone; else on a ground
  bool gradient = false;  ///< a sky that changes; else uniform

  /// All options of a scene with a texture.
  void declare(CommandLine& line);
  /// The options that are not about a texture or its sky: samples, limits, lens.
  void declare_gathering(CommandLine& line);
  /// Sets the meaning of the texture's bytes, and the sky. Then the scene of --scene: a ground
  /// under the globe, which is the first object, or the book's camera.
  template <class Object>
  void apply_to(std::vector<Object>& objects, Stage& stage) const {
    apply_to(objects.front().paint.texture, stage.sky);
    objects.resize(1);
    const ImageTexture gray{Image(1, 1, {200, 200, 200})};
    if (!book) objects.push_back({{.center = {0, -1002, 0}, .radius = 1000}, {{}, gray}});
    if (book) stage.camera = {.eye = {0, 0, 12}, .target = {0, 0, 0}, .fov_y_degrees = 20};
  }
  void apply_to(LightTexture& texture, GradientSky& sky) const;
};

}  // namespace texmap
