// The figures of chapter 07's page.
#include <cmath>
#include <stdexcept>
#include <string>

#include "07_earth_by_sampling/lesson.hpp"
#include "engine/picture/load_image.hpp"
#include "figures.hpp"
#include "math/srgb.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"

namespace texmap::test {
namespace {

using chapter_07::Lesson;

/// The light of the chapter's globe, drawn small: 64 x 36 pixels.
Film film_of(const Lesson& lesson, SamplerKind kind, int samples, std::uint32_t seed = 0) {
  const View<> view = view_of(lesson.stage.camera, 64, 36);
  return gather<Pack<float>>(lesson, lesson.objects, view, {Sampler(kind, samples, seed)},
                             bounds_of_view(lesson, lesson.objects, view, {}, samples), {});
}

/// Root mean square difference in levels of 255.
double levels(const Film& a, const Film& b) {
  double sum = 0;
  for (int row = 0; row < a.height(); ++row) {
    for (int column = 0; column < a.width(); ++column) {
      const Rgb x = a.light(column, row);
      const Rgb y = b.light(column, row);
      const auto apart = [](double p, double q) {
        return square(255 * (srgb_encode(p) - srgb_encode(q)));
      };
      sum += apart(x.r, y.r) + apart(x.g, y.g) + apart(x.b, y.b);
    }
  }
  return std::sqrt(sum / (3.0 * a.width() * a.height()));
}

std::string color(Rgb8 pixel) {
  return std::to_string(pixel.r) + ", " + std::to_string(pixel.g) + ", " + std::to_string(pixel.b);
}

/// The picture that the chapter's program draws with these options.
Image drawn_with(const std::string& options) {
  const TemporaryFolder folder;
  const std::string file = folder / "drawn.png";
  const Outcome outcome =
      run("\"" TEXMAP_BIN_DIR "/07_earth_by_sampling\" --out \"" + file + "\" " + options);
  if (outcome.status != 0) throw std::runtime_error("07_earth_by_sampling: " + outcome.err);
  return load_image(file);
}

}  // namespace

void figures_of_07(Figures& figures) {
  const Image usual = drawn_with("");
  figures.emplace_back("07.sky", color(usual.at(0, 0)));
  figures.emplace_back("07.middle", color(usual.at(200, 112)));
  figures.emplace_back("07.middle_raw", color(drawn_with("--decode raw").at(200, 112)));

  const auto lesson = prepared<Lesson>();
  const Film truth = film_of(lesson, SamplerKind::sobol, 8192, 99);
  struct Pattern {
    SamplerKind kind;
    const char* name;
  };
  for (const Pattern& pattern :
       {Pattern{SamplerKind::random, "random"}, Pattern{SamplerKind::stratified, "stratified"},
        Pattern{SamplerKind::multi_jitter, "multi_jitter"}, Pattern{SamplerKind::sobol, "sobol"}}) {
    for (const int samples : {1, 4, 16, 64}) {
      const double error = levels(film_of(lesson, pattern.kind, samples), truth);
      figures.emplace_back("07." + std::string(pattern.name) + "_" + std::to_string(samples),
                           decimals(error, samples < 64 ? 1 : 2));
    }
  }
  const auto small = [&](SamplerKind kind) { return levels(film_of(lesson, kind, 64), truth); };
  const double in_levels = small(SamplerKind::random) / small(SamplerKind::sobol);
  figures.emplace_back("07.times_in_levels", whole(std::lround(square(in_levels))));
  figures.emplace_back("07.worth", whole(100 * std::lround(0.64 * square(in_levels))));
  // An error of light falls with the root of the number of random samples.
  const double ratio = error_of_halves(film_of(lesson, SamplerKind::random, 64), truth) /
                       error_of_halves(film_of(lesson, SamplerKind::sobol, 64), truth);
  figures.emplace_back("07.worth_in_light", whole(10 * std::lround(6.4 * square(ratio))));
  figures.emplace_back("07.seeds_random",
                       decimals(levels(film_of(lesson, SamplerKind::random, 4),
                                       film_of(lesson, SamplerKind::random, 4, 1)),
                                1));
  figures.emplace_back("07.seeds_sobol", decimals(levels(film_of(lesson, SamplerKind::sobol, 4),
                                                         film_of(lesson, SamplerKind::sobol, 4, 1)),
                                                  1));
  const double seed_0 = levels(film_of(lesson, SamplerKind::sobol, 4), truth);
  const double seed_1 = levels(film_of(lesson, SamplerKind::sobol, 4, 1), truth);
  figures.emplace_back("07.sobol_4_seed_1", decimals(seed_1, 1));
  figures.emplace_back("07.sobol_4_both", decimals(std::hypot(seed_0, seed_1), 1));

  figures.emplace_back("07.quarter_white", whole(std::lround(255 * srgb_encode(0.25))));
  auto furnace = lesson;
  furnace.objects.front().paint.texture.image = Image(1, 1, {255, 255, 255});
  const Image drawn = develop(film_of(furnace, SamplerKind::sobol, 16), Transfer::srgb);
  const Image sky(drawn.width, drawn.height, drawn.at(0, 0));
  figures.emplace_back("07.unlike_the_sky", whole(count_different(drawn, sky)));
}

}  // namespace texmap::test
