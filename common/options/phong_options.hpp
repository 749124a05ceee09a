// The options of chapters with a highlight.
#pragma once
#include <span>
#include <vector>

#include "budget_options.hpp"
#include "phong.hpp"
#include "studio.hpp"

namespace texmap {

/// The scenes that can be drawn with a highlight.
enum class PhongScene {
  stage,    ///< seed 0's four spheres
  lecture,  ///< seed 4's globe over a yellow ground
};

/// What the user can say about light and texture.
struct PhongOptions {
  double blend = 0.3;     ///< weight of the texture where it is blended with the light, 0 to 1
  bool blends = false;    ///< false: the light multiplies the texture, as in the chapters before
  double shininess = 50;  ///< Phong's exponent of the globe
  PhongScene scene = PhongScene::stage;
  HighlightFormula formula = HighlightFormula::phong;
  BudgetOptions budget;
  BudgetPower power;  ///< Phong's, once settled

  void declare(CommandLine& line) {
    line.decimal("--blend", blend, 0, 1, "mix texture T with light 1 - T; the stage multiplies them unless this is given");
    line.decimal("--shininess", shininess, 0, 1e30, "Phong's exponent of the globe; 500 in the lecture's scene");
    line.choice<PhongScene>("--scene", scene, {{"stage", PhongScene::stage}, {"lecture", PhongScene::lecture}}, "what to draw");
    line.choice<HighlightFormula>("--highlight", formula,
                                  {{"phong", HighlightFormula::phong}, {"lecture", HighlightFormula::lecture}},
                                  "Phong's highlight, or the lecture's with its wrong sign");
    budget.declare(line, "how far off Phong's highlight may be: exact or levels=1; says which kernel it takes");
  }

  /// After parsing: sets what depends on other options. The lecture always blends, and has an exponent of its own.
  ///
  /// @return  the scene to draw
  PhongScene settle(const Studio& studio) {
    const bool lecture = scene == PhongScene::lecture;
    blends = lecture || studio.typed("--blend");
    if (lecture && !studio.typed("--shininess")) shininess = 500;
    power = budget.settle_power(studio, shininess);
    return scene;
  }

  /// Gives the globe its gloss.
  void polish(Finish& globe) const {
    globe.specular = 0.3;
    globe.shininess = shininess;
  }

  /// The highlight by the formula and the kernel that were chosen; 0 without any for a finish that has no gloss.
  template <class Real>
  [[nodiscard]] Real highlight(const Finish& finish, const Illumination<Real>& lamp, const Vec3<Real>& normal,
                               const Vec3<Real>& to_eye) const {
    if (formula == HighlightFormula::lecture || power.terms == 0 || finish.specular == 0) {
      return texmap::highlight(formula, finish, lamp, normal, to_eye);
    }
    return highlight_by(power, finish, lamp, normal, to_eye);
  }

  /// The objects that cast shadows: the lecture's scene has none.
  template <class Object>
  [[nodiscard]] std::span<const Object> casters(const std::vector<Object>& objects) const {
    return scene == PhongScene::lecture ? std::span<const Object>() : std::span<const Object>(objects);
  }
};

}  // namespace texmap
