// The options --filter, --scene, --wrap, --taps, --floor and --plot.
#pragma once
#include <string>

#include "engine/draw/kinds.hpp"
#include "engine/draw/lesson.hpp"
#include "engine/run/texture_file.hpp"
#include "texture/filters.hpp"

namespace texmap {

struct Offer;

enum class FilterScene {
  both,   ///< the plane to the horizon, a globe close by and one far away
  plane,  ///< the plane alone
  globe,  ///< a globe far away, under the sky
};

struct FilterOptions {
  Filter filter = Filter::anisotropic;
  FilterScene scene = FilterScene::both;
  Wrap wrap = Wrap::repeat;  ///< of the floor; the globe's is spherical
  int taps = 16;
  std::string floor_file = "checkers";
  std::string plot;                       ///< the file for the plot of errors; empty: none
  const CommandLine* declared = nullptr;  ///< where

  void declare(Offer& offer);
  /// The floor's picture as a texture.
  [[nodiscard]] FilteredTexture load_floor() const;
  [[nodiscard]] FilteredTexture load_globe(TextureFile& file) const;
};

/// The base of a lesson that filters: its picture shows the mean light of its pixels.
struct FilteredLesson : LessonHooks, ShowsMeanLight {
  FilterOptions filtering;

  [[nodiscard]] bool needs_footprints() const override {
    return filtering.filter != Filter::nearest && filtering.filter != Filter::bilinear;
  }
};

/// Lets all textures of a lesson be read by a filter.
template <class Lesson>
void read_by(Lesson& lesson, Filter filter, int taps) {
  const auto apply = [&](auto& textured) {
    textured.filter = filter;
    textured.taps = taps;
  };
  apply(lesson.filtering);
  apply(lesson.ground.texture);
  for (auto& object : lesson.objects) apply(object.paint.texture);
}

/// Leaves in a lesson what the user's scene shows.
template <class Lesson>
void keep_scene(Lesson& lesson) {
  if (lesson.filtering.scene == FilterScene::plane) lesson.objects.clear();
  if (lesson.filtering.scene != FilterScene::globe) return;
  lesson.objects.resize(1);
  lesson.objects.front().shape = {.center = {0, 30, -60}, .radius = 1.5};
  lesson.stage.camera.target = {0, 30, -60};  // so high that no plane is seen below it
  lesson.stage.camera.fov_y_degrees = 12;
}

/// A checkerboard of black and white squares as a picture.
[[nodiscard]] Image checkers_image(int size, int squares);

}  // namespace texmap
