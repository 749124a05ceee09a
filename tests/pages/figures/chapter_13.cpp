// The figures of chapter 13's page.
#include "13_speed_for_accuracy/noise.hpp"
#include "13_speed_for_accuracy/sheet.hpp"
#include "13_speed_for_accuracy/trials.hpp"
#include "engine/app/texture_file.hpp"
#include "engine/kernels/turns.hpp"
#include "figures.hpp"

namespace texmap::test {
namespace {

using namespace chapter_13;

/// The fit's worst error with exact arithmetic, in texels of a texture 2048 wide.
template <int Degree>
std::string texels_of_fit() {
  return digits(2048 * ArcTangentFit<Degree>::worst, 2);
}

}  // namespace

void figures_of_13(Figures& figures) {
  figures.emplace_back("13.fit_5_texels", texels_of_fit<5>());
  figures.emplace_back("13.fit_9_texels", texels_of_fit<9>());
  figures.emplace_back("13.fit_17_texels", texels_of_fit<17>());

  const Globe globe(TextureFile{"earth.png"}.load());
  const SheetLayout layout(1312, 1090);
  const View<> view = globe.view(layout.panel_width, layout.panel_height);
  figures.emplace_back("13.pixels", whole(static_cast<long long>(view.width) * view.height));

  std::vector<Trial> places;
  places.push_back({{NumberKind::float_}});
  places.push_back({{NumberKind::float_, Instructions::baseline, 5}});
  places.push_back({{NumberKind::double_}});
  places.push_back({{NumberKind::float_, Instructions::baseline, 5, Filter::bilinear}});
  find_errors_of_places(places, globe, view, [] {});
  figures.emplace_back("13.float_seen", whole(places[0].errors.changed));
  figures.emplace_back("13.float_may", whole(places[0].errors.may_change));
  figures.emplace_back("13.degree_5_seen", whole(places[1].errors.changed));
  figures.emplace_back("13.degree_5_may", whole(places[1].errors.may_change));
  figures.emplace_back("13.degree_5_levels", std::to_string(places[1].errors.levels));
  figures.emplace_back("13.double_may", whole(places[2].errors.may_change));
  figures.emplace_back("13.bilinear_5_seen", whole(places[3].errors.changed));
  figures.emplace_back("13.bilinear_5_levels", std::to_string(places[3].errors.levels));

  std::vector<Trial> curves;
  curves.push_back({{.curve = Curve::three}});
  find_errors_of_curves(curves, globe, view, [] {});
  figures.emplace_back("13.curve_3_seen", whole(curves[0].errors.changed));
  figures.emplace_back("13.curve_3_levels", std::to_string(curves[0].errors.levels));

  // The sheet's last row: 16 samples against 256 of `sobol`.
  const auto levels = [&](SamplerKind kind, int samples, std::uint32_t seed) {
    return levels_of(
        sampled(globe, view, {.number = NumberKind::double_pack}, Sampler(kind, samples, seed), 0));
  };
  const std::vector<double> converged = levels(SamplerKind::sobol, 256, 1);
  for (const SamplerKind kind : {SamplerKind::random, SamplerKind::sobol}) {
    figures.emplace_back(std::string("13.off_") + name_of(kind),
                         decimals(rms_difference(levels(kind, 16, 0), converged), 2));
  }
}

}  // namespace texmap::test
