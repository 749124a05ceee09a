// The highlight by the user's formula and the plan's power.
#pragma once
#include "engine/draw/settings.hpp"
#include "engine/fast/kernel_plan.hpp"
#include "engine/run/phong_options.hpp"

namespace texmap {

template <class Real>
Real PhongOptions::highlight(const PhongMaterial& material, const LightSample<Real>& light,
                             const Vec3<Real>& normal, const Vec3<Real>& to_eye) const {
  if constexpr (all_numbers) {
    if (formula == HighlightFormula::phong && power_terms != 0 && material.specular != 0) {
      return highlight_by(PlannedPower{power_terms, material.shininess}, material, light, normal,
                          to_eye);
    }
  }
  return texmap::highlight(formula, material, light, normal, to_eye);
}

}  // namespace texmap
