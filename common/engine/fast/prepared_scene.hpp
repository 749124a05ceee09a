// A scene converted once to the number that draws it.
#pragma once
#include <vector>

#include "scene/camera.hpp"
#include "scene/paint.hpp"

namespace texmap {

/// A sphere with its inverse radius.
template <class Real>
struct PreparedSphere : Sphere<Real> {
  using Own = PreparedSphere;
  Real inverse;
};
template <class Real>
[[nodiscard]] PreparedSphere<Real> prepare(const Sphere<>& sphere) {
  return {{number_cast<Real>(sphere.center), Real(sphere.radius), sphere.form},
          inverse_radius<Real>(sphere)};
}
template <class Real>
[[nodiscard]] Real inverse_radius(const PreparedSphere<Real>& sphere) {
  return sphere.inverse;
}

/// An object that refers to the paint of another.
template <class Real, class Paint>
struct PreparedObject {
  PreparedSphere<Real> shape;
  const Paint& paint;
};

/// What all samples of a picture have in common: the argument of lessons that gather light.
template <class Real, class Paint, class Sky>
struct PreparedScene {
  View<Real> view;
  std::vector<PreparedObject<Real, Paint>> objects;
  const Sky& sky;

  /// The same view and sky without objects.
  [[nodiscard]] PreparedScene without_objects() const { return {view, {}, sky}; }
};

/// The scene in the number Real. `objects` and `sky` must live as long.
template <class Real, class Paint, class Sky>
[[nodiscard]] PreparedScene<Real, Paint, Sky> prepare_scene(
    const View<>& view, const std::vector<Painted<Paint>>& objects, const Sky& sky) {
  PreparedScene<Real, Paint, Sky> scene{number_cast<Real>(view), {}, sky};
  for (const Painted<Paint>& object : objects)
    scene.objects.push_back({prepare<Real>(object.shape), object.paint});
  return scene;
}

}  // namespace texmap
