// A scene converted once to the number that draws it.
#pragma once
#include <vector>

#include "scene/camera.hpp"
#include "scene/paint.hpp"
#include "scene/sky.hpp"

namespace texmap {

/// A sphere with its inverse radius.
template <class Real>
struct PreparedSphere : Sphere<Real> {
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

/// A sky with its uniformity known.
template <class Real>
struct PreparedSky {
  Color<Real> below, above;
  bool constant;

  [[nodiscard]] bool is_constant() const { return constant; }
  /// As GradientSky's.
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    if (constant) return below;
    const Real height = (ray.direction.y + Real(1)) * Real(0.5);
    return mix(below, above, height);
  }
};
template <class Real>
[[nodiscard]] PreparedSky<Real> prepare(const GradientSky& sky) {
  return {number_cast<Real>(sky.below), number_cast<Real>(sky.above), sky.is_constant()};
}
/// Any other sky is drawn as it is.
template <class Real, class Sky>
[[nodiscard]] const Sky& prepare(const Sky& sky) {
  return sky;
}

/// An object that refers to the paint of another.
template <class Real, class Paint>
struct PreparedObject {
  PreparedSphere<Real> shape;
  const Paint& paint;
};

/// What all samples of a picture have in common: the argument of lessons that gather light.
template <class Real, class Paint, class Sky = PreparedSky<Real>>
struct PreparedScene {
  View<Real> view;
  std::vector<PreparedObject<Real, Paint>> objects;
  Sky sky;

  /// The same view and sky without objects.
  [[nodiscard]] PreparedScene without_objects() const { return {view, {}, sky}; }
};

/// The scene in the number Real. `objects` and a sky that is no GradientSky must live as long.
template <class Real, class Paint, class Sky>
[[nodiscard]] auto prepare_scene(const View<>& view, const std::vector<Painted<Paint>>& objects,
                                 const Sky& sky) {
  PreparedScene<Real, Paint, decltype(prepare<Real>(sky))> scene{
      number_cast<Real>(view), {}, prepare<Real>(sky)};
  for (const Painted<Paint>& object : objects)
    scene.objects.push_back({prepare<Real>(object.shape), object.paint});
  return scene;
}

}  // namespace texmap
