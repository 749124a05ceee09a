// Measures the figures of the pages that no golden picture, law or sum pins: pixels that another
// setting changes, and errors that depend on random numbers or rounding. Prints a name, a blank and
// the value a line, as docs/figures.txt has them.
#include <cmath>
#include <iostream>
#include <map>

#include "01_plain_spheres/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/conventions_compared.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "10_projections/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "12_environment_map/lesson.hpp"
#include "13_speed_for_accuracy/lesson.hpp"
#include "engine/compare/difference.hpp"
#include "engine/draw/develop.hpp"
#include "engine/draw/gather.hpp"
#include "engine/files/find_texture.hpp"
#include "engine/files/load_light.hpp"
#include "engine/files/text.hpp"
#include "engine/run/sky_options.hpp"
#include "support/fragile_triangles.hpp"
#include "support/pictures.hpp"

namespace texmap::test {
namespace {

/// Values by name. A name begins with its chapter: "01.pixels_other_in_float".
using Figures = std::map<std::string, std::string>;
using Words = std::vector<std::string>;

/// A whole number as pages show it: 480,000.
std::string whole(long n) {
  std::string digits = std::to_string(n);
  for (std::size_t place = digits.size(); place > 3;) {
    place -= 3;
    digits.insert(place, 1, ',');
  }
  return digits;
}

std::string decimals(double x, int count) { return text("%.*f", count, x); }

std::string color(Rgb8 pixel) { return text("%d, %d, %d", pixel.r, pixel.g, pixel.b); }

template <class Lesson>
Image drawn(const Words& words = {}) {
  return picture(prepared<Lesson>(words));
}

/// What another number, rounding, exponent, layout or way to raise changes in a lesson's picture.
void figures_of_settings(Figures& figures) {
  const auto changed = [&](const char* name, const Image& a, const Image& b) {
    figures[name] = whole(count_different(a, b));
  };
  const chapter_01::Lesson spheres;
  changed("01.pixels_other_in_float", picture<float>(spheres), picture(spheres));

  auto upside = prepared<chapter_03::Lesson>({"--texture", "uv_map.png"});
  const Image upright = picture(upside);
  std::get<chapter_03::Textured>(upside.objects[chapter_03::middle].paint).texture.v_axis =
      VAxis::down;
  changed("03.pixels_upside_down", picture(upside), upright);

  double largest = 0;
  for (const chapter_04::Relation& relation : chapter_04::measure_relations())
    largest = std::max(largest, relation.residual);
  figures["04.largest_error"] = text("%.2g", largest);
  changed("04.pixels_other_by_rounding", drawn<chapter_03::Lesson>(),
          drawn<chapter_04::Lesson>({"--rounding", "lecture"}));

  const Image before = drawn<chapter_05::Lesson>({"--degrees", "20"});
  const auto spot = [&](const char* shininess) {
    return count_different(drawn<chapter_06::Lesson>({"--shininess", shininess}), before);
  };
  const long wide = spot("50"), narrow = spot("500");
  figures["06.pixels_at_50"] = whole(wide);
  figures["06.pixels_at_500"] = whole(narrow);
  figures["06.spot_factor"] = decimals(static_cast<double>(wide) / static_cast<double>(narrow), 1);
  const auto in_the_dark = [](const Words& words) {
    return color(drawn<chapter_06::Lesson>(words).at(346, 320));
  };
  figures["06.dark_texture"] = in_the_dark({"--blend", "1"});
  figures["06.dark_multiplied"] = in_the_dark({});
  figures["06.dark_blended"] = in_the_dark({"--blend", "0.5"});

  auto layout = prepared<chapter_10::Lesson>();
  const Image right = picture(layout);
  std::get<chapter_10::Textured>(layout.objects[chapter_10::middle].paint).mapping = {
      Projection::cylinder};
  changed("10.pixels_by_cylinder", picture(layout), right);

  const auto globe = [](const Words& words) {
    return picture(prepared<chapter_11::Lesson>(words), 600, 600);
  };
  const Image bumps = globe({});
  changed("11.pixels_with_bumps", bumps, globe({"--bump", "off"}));
  changed("11.pixels_by_blinn", bumps, globe({"--bump", "blinn"}));
}

/// Heron's areas and the usual test of a ray: what they change, and how far they are off.
void figures_of_triangles(Figures& figures) {
  const auto changed_by_heron = []<class Real>(Real) {
    const auto in = [](const Words& words) {
      return picture<Real>(prepared<chapter_08::Lesson>(words), 480, 360);
    };
    return whole(count_different(in({"--weights", "heron"}), in({})));
  };
  figures["08.heron_in_double"] = changed_by_heron(1.0);
  figures["08.heron_in_float"] = changed_by_heron(1.0F);
  for (const int aspect : {16, 256, 4096}) {
    const auto errors = needle_errors<float>(aspect, 2000);
    const std::string length = std::to_string(aspect);
    figures["08.signed_" + length] = whole(std::lround(errors.signed_areas));
    figures["08.heron_" + length] = whole(std::lround(errors.heron));
  }
  const InsideLeaks leaks = leaks_of_usual_test<float>(20000);
  figures["08.usual_cracks"] = whole(leaks.cracks);
  figures["08.usual_doubles"] = whole(leaks.doubles);
}

/// Root mean square difference in levels of 255, as `compare` finds it between the files.
double levels(const Image& a, const Image& b) {
  return measure(a, b, {}, Detail::pixels).root_mean_square_error;
}
double levels(const Film& a, const Film& b) {
  return levels(develop(a, Transfer::srgb), develop(b, Transfer::srgb));
}

/// The errors of the four patterns in chapter 07's picture, drawn small.
void figures_of_samplers(Figures& figures) {
  const auto lesson = prepared<chapter_07::Lesson>();
  const auto film = [&](SamplerKind kind, int samples, std::uint32_t seed = 0) {
    const View<> view = view_of(lesson.stage.camera, 64, 36);
    return gather<Pack<double>>(lesson, lesson.objects, view, {Sampler(kind, samples, seed)}, {},
                                {});
  };
  const Film truth = film(SamplerKind::sobol, 8192, 99);
  std::map<std::string, double> errors;
  using enum SamplerKind;
  for (const auto& [kind, name] :
       {std::pair{random, "random"}, std::pair{stratified, "stratified"},
        std::pair{multi_jitter, "multi_jitter"}, std::pair{sobol, "sobol"}}) {
    for (const int samples : {1, 4, 16, 64}) {
      const std::string row = name + ("_" + std::to_string(samples));
      errors[row] = levels(film(kind, samples), truth);
      figures["07." + row] = decimals(errors[row], samples < 64 ? 1 : 2);
    }
  }
  const double ratio = errors["random_64"] / errors["sobol_64"];
  figures["07.times_in_levels"] = whole(std::lround(square(ratio)));
  figures["07.worth"] = whole(100 * std::lround(0.64 * square(ratio)));
  // An error of light falls with the root of the number of random samples.
  const double in_light =
      error_of_halves(film(random, 64), truth) / error_of_halves(film(sobol, 64), truth);
  figures["07.worth_in_light"] = whole(10 * std::lround(6.4 * square(in_light)));
  figures["07.seeds_random"] = decimals(levels(film(random, 4), film(random, 4, 1)), 1);
  figures["07.seeds_sobol"] = decimals(levels(film(sobol, 4), film(sobol, 4, 1)), 1);
  const double seed_1 = levels(film(sobol, 4, 1), truth);
  figures["07.sobol_4_seed_1"] = decimals(seed_1, 1);
  figures["07.sobol_4_both"] = decimals(std::hypot(errors["sobol_4"], seed_1), 1);
}

/// Two rows of chapter 13's table of samplers.
void figures_of_a_trade(Figures& figures) {
  using namespace chapter_13;
  const Variant packs{.number = NumberKind::double_pack};
  std::vector<Row> rows = {{Part::samplers, packs, SamplerKind::random, 256},
                           {Part::samplers, packs, SamplerKind::sobol, 64}};
  const Globe globe(Lesson{}.texture.load());
  find_errors(rows, globe, globe.view(1, 1), 0, [](int, int) {});  // by views of their own
  figures["13.random_256"] = decimals(rows[0].mean, 2);
  figures["13.sobol_64"] = decimals(rows[1].mean, 2);
}

/// The errors of chapter 12's five ways to light matte surfaces, with 16 and with 64 samples.
void figures_of_a_sky(Figures& figures, const std::string& sky, SkyLight light) {
  chapter_12::Lesson lesson;
  lesson.stage.sky = std::move(light);
  const auto lit = [&](SkyLighting way, int samples) {
    lesson.sky.matte.way = way;
    const View<> view = view_of(lesson.stage.camera, 48, 27);
    return develop(gather<Pack<double>>(lesson, lesson.objects, view,
                                        {Sampler(SamplerKind::multi_jitter, samples)}, {}, {}),
                   Transfer::srgb);
  };
  const Image reference = lit(best_lighting(noise_of(lesson.stage.sky)), 1024);
  using enum SkyLighting;
  for (const auto& [way, name] : {std::pair{uniform, "uniform"}, std::pair{cosine, "cosine"},
                                  std::pair{importance, "importance"}, std::pair{mis, "mis"},
                                  std::pair{coefficients, "coefficients"}}) {
    for (const int samples : {16, 64}) {
      figures["12.error_" + sky + "_" + name + "_" + std::to_string(samples)] =
          decimals(levels(lit(way, samples), reference), 1);
    }
  }
}

void figures_of_skies(Figures& figures) {
  const Environment sky(load_light(find_texture("sky.hdr")));
  const SkyNoise noise = noise_of(SkyLight(sky));
  figures["12.noise_cosine"] = decimals(noise.cosine, 0);
  figures["12.noise_mis"] = decimals(noise.mis, 2);
  figures_of_a_sky(figures, "uniform", SkyLight(Environment(LightImage(2, 1, gray(0.8F)))));
  figures_of_a_sky(figures, "sun", SkyLight(sky));
}

}  // namespace
}  // namespace texmap::test

int main() {
  using namespace texmap::test;
  Figures figures;
  figures_of_settings(figures);
  figures_of_samplers(figures);
  figures_of_triangles(figures);
  figures_of_skies(figures);
  figures_of_a_trade(figures);
  for (const auto& [name, value] : figures) std::cout << name << ' ' << value << '\n';
  return 0;
}
