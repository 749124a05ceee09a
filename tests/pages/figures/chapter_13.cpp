// The figures of chapter 13's page.
#include "13_speed_for_accuracy/ways.hpp"
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
  const View<> view = view_of_sheet(globe, 1312, 1090);
  figures.emplace_back("13.pixels", whole(static_cast<long long>(view.width) * view.height));

  std::vector<Row> places = {
      {Part::places, {NumberKind::float_}},
      {Part::places, {NumberKind::float_, Instructions::baseline, 5}},
      {Part::places, {NumberKind::double_}},
      {Part::places, {NumberKind::float_, Instructions::baseline, 5, Filter::bilinear}}};
  find_errors(places, globe, view, 0, [] {});
  figures.emplace_back("13.float_seen", whole(places[0].changed));
  figures.emplace_back("13.float_may", whole(places[0].may_change));
  figures.emplace_back("13.degree_5_seen", whole(places[1].changed));
  figures.emplace_back("13.degree_5_may", whole(places[1].may_change));
  figures.emplace_back("13.degree_5_levels", std::to_string(places[1].levels));
  figures.emplace_back("13.double_may", whole(places[2].may_change));
  figures.emplace_back("13.bilinear_5_seen", whole(places[3].changed));
  figures.emplace_back("13.bilinear_5_levels", std::to_string(places[3].levels));

  Row curve{Part::curves, {.curve = Curve::three}};
  find_errors({&curve, 1}, globe, view, 0, [] {});
  figures.emplace_back("13.curve_3_seen", whole(curve.changed));
  figures.emplace_back("13.curve_3_levels", std::to_string(curve.levels));

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
