// The figures of chapter 14's page, in its text.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "14_numerical_extremes/exhibits.hpp"
#include "14_numerical_extremes/lesson.hpp"
#include "engine/app/command_line.hpp"
#include "engine/app/session.hpp"
#include "figures.hpp"

namespace texmap::test {

using namespace chapter_14;

void figures_of_14(Figures& figures) {
  // The sum of a million steps of 0.1, as the exhibit `turns` adds them.
  const float sum = ManyTurns::sum_of_steps<float>();
  figures.emplace_back("14.sum_of_tenths", whole(static_cast<long long>(sum)));
  // How far v moves from the pole to the next height that float has, in texels of 4096.
  const double step = std::acos(1 - 0x1p-24) / std::numbers::pi * 4096;
  figures.emplace_back("14.step_at_the_pole", digits(step, 2));

  CommandLine line("figures", "");
  Session session("figures", line, Lesson::about);
  const std::vector<Exhibit> exhibits = Lesson{}.exhibits();
  const Sheet sheet = draw_sheet(exhibits, session);
  const auto mistakes = [&](const std::string& name, Variant variant) {
    const auto found = std::find_if(exhibits.begin(), exhibits.end(),
                                    [&](const Exhibit& exhibit) { return exhibit.name == name; });
    return sheet.mistakes.at(static_cast<std::size_t>(found - exhibits.begin())).at(variant);
  };
  const auto texels = [&](const std::string& name, Variant variant, int decimal_places) {
    return decimals(static_cast<double>(mistakes(name, variant).texels), decimal_places);
  };
  figures.emplace_back("14.far_published_double", texels("from-1e7", published_double, 0));
  figures.emplace_back("14.far_robust_float", texels("from-1e7", robust_float, 4));
  figures.emplace_back("14.far_home_float", texels("far-home", published_float, 1));
  figures.emplace_back("14.holes_in_float", whole(mistakes("cracks", published_float).missed));
  figures.emplace_back("14.holes_in_double", whole(mistakes("cracks", published_double).missed));
}

}  // namespace texmap::test
