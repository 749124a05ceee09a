// The options --decode, --scene and --sky of chapter 07's globe.
#pragma once
#include <vector>

#include "scene/stage.hpp"
#include "texture/light_texture.hpp"

namespace texmap {

struct Offer;

/// The user's choices of chapter 07's scene: what the texture's bytes mean, ground and sky.
struct GlobeOptions {
  TexelLight decoding = TexelLight::linear;
  bool book = false;      ///< the book's scene: the globe alone; else on a ground
  bool gradient = false;  ///< a sky that changes; else uniform

  void declare(Offer& offer);
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
