// The options of chapters with a highlight.
#include "engine/app/phong_options.hpp"

#include "engine/app/budget_options.hpp"
#include "engine/app/command_line.hpp"
#include "engine/app/session.hpp"
#include "engine/kernels/kernel_plan.hpp"
#include "engine/system/system.hpp"

namespace texmap {

void PhongOptions::declare(CommandLine& line) {
  line.decimal("--blend", blend, 0, 1,
               "mix X parts of texture with 1 - X parts of light; without this option the stage "
               "multiplies them");
  line.decimal("--shininess", shininess, 0, 1e30,
               "Phong's exponent, by default 500 in the lecture's scene");
  line.choice<PhongScene>("--scene", scene,
                          {{"stage", PhongScene::stage}, {"lecture", PhongScene::lecture}},
                          "which scene to draw; the lecture's picture is 800x400");
  line.choice<HighlightFormula>(
      "--highlight", formula,
      {{"phong", HighlightFormula::phong}, {"lecture", HighlightFormula::lecture}},
      "Phong's highlight, or the lecture's, which has a wrong sign");
  line.wishes.budget =
      "the allowed error of Phong's highlight: exact or levels=1; prints which fast formula it "
      "chooses";
  line.wishes.plans.emplace_back([this](const Session& session) { plan(session); });
}

PhongScene PhongOptions::resolve(const Session& session) {
  const bool lecture = scene == PhongScene::lecture;
  blends = lecture || session.was_given("--blend");
  if (lecture && !session.was_given("--shininess")) shininess = 500;
  return scene;
}

void PhongOptions::plan(const Session& session) {
  const KernelPlan plan = plan_highlight(read_budget(session.settings.budget));
  if (!session.settings.quiet && session.was_given("--budget")) print(plan.text);
  power_terms = plan.power_terms;
}

void PhongOptions::apply_to(PhongMaterial& globe) const {
  globe.specular = 0.3;
  globe.shininess = shininess;
}

}  // namespace texmap
