// The options of chapters with a highlight.
#pragma once
#include <span>
#include <vector>

#include "scene/phong.hpp"

namespace texmap {

struct Offer;
class Chosen;

enum class PhongScene {
  stage,    ///< the daily exercise's four spheres
  lecture,  ///< the lecture's globe over a yellow ground
};

/// The user's choices of light and texture.
struct PhongOptions {
  double blend = 0.3;     ///< weight of the texture where it is blended with light, 0 to 1
  double shininess = 50;  ///< Phong's exponent of the globe
  PhongScene scene = PhongScene::stage;
  HighlightFormula formula = HighlightFormula::phong;
  int power_terms = 0;  ///< of a polynomial for Phong's power; 0 for its formula

  void declare(Offer& offer);
  /// After parsing: sets what depends on other options, and returns the scene to draw.
  /// The lecture's scene has its own exponent.
  PhongScene resolve(const Chosen& chosen);
  /// Gives the globe its highlight. It blends in the lecture's scene, and by --blend.
  void apply_to(PhongMaterial& globe, const Chosen& chosen) const;

  /// `highlight` of scene/phong.hpp by the chosen formula; defined in planned_highlight.hpp.
  template <class Real>
  [[nodiscard]] Real highlight(const PhongMaterial& material, const LightSample<Real>& light,
                               const Vec3<Real>& normal, const Vec3<Real>& to_eye) const;

  /// The objects that cast shadows: in the lecture's scene there are none.
  template <class Object>
  [[nodiscard]] std::span<const Object> casters(const std::vector<Object>& objects) const {
    return scene == PhongScene::lecture ? std::span<const Object>()
                                        : std::span<const Object>(objects);
  }
};

}  // namespace texmap
