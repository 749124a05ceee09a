// A scene made ready for the number that a picture is drawn with.
#pragma once
#include <vector>

#include "camera.hpp"
#include "painted.hpp"
#include "pixel_patch.hpp"
#include "sky.hpp"

namespace texmap {

/// What all samples of a picture have in common. Scenes are written in double; here they are in the lanes of the packs that
/// draw, once for all samples. Errors: none; each number is rounded once.
template <class Real, class Paint>
struct SceneIn {
  ViewIn<Real> view;
  std::vector<PaintedIn<Real, Paint>> objects;
  GradientSkyIn<Real> sky;

  /// What a pixel sees of the only object; see PixelPatch.
  [[nodiscard]] auto pixel_patch(const Real& column, const Real& row) const requires HasMapping<Paint, Real> {
    return PixelPatch<Real, Paint>(view, objects.front().sphere, objects.front().paint, sky, column, row);
  }
  /// What a pixel sees beside all objects.
  [[nodiscard]] SkyPatch<Real> sky_patch(const Real& column, const Real& row) const { return {view, sky, column, row}; }

  /// The same view of the same sky, and nothing else.
  [[nodiscard]] SceneIn without_objects() const { return {view, {}, sky}; }
};

/// @param objects  are looked at while the scene is in use: they stay where they are
template <class Real, class Paint>
[[nodiscard]] SceneIn<Real, Paint> ready_scene(const View& view, const std::vector<Painted<Paint>>& objects,
                                               const GradientSky& sky) {
  SceneIn<Real, Paint> scene{number_cast<Real>(view), {}, number_cast<Real>(sky)};
  for (const Painted<Paint>& object : objects) scene.objects.push_back({number_cast<Real>(object.sphere), object.paint});
  return scene;
}

}  // namespace texmap
