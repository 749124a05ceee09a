// The front of error against time: five ways to light matte objects by three skies.
#include "front.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "engine/app/sky_choice.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_light.hpp"
#include "engine/render/develop.hpp"
#include "engine/render/gather.hpp"
#include "lesson.hpp"
#include "number/kinds/pack2.hpp"

namespace texmap::chapter_12 {
namespace {

struct Way {
  SkyLighting lighting;
  const char* name;
};
constexpr std::array ways = {
    Way{SkyLighting::uniform, "uniform"}, Way{SkyLighting::cosine, "cosine"},
    Way{SkyLighting::importance, "importance"}, Way{SkyLighting::mis, "mis"},
    Way{SkyLighting::coefficients, "coefficients"}};
constexpr std::array sample_counts = {4, 16, 64};
static_assert(ways.size() * sample_counts.size() == figures_of_a_sky);

LightImage gradient() {
  LightImage image(64, 32);
  for (int row = 0; row < 32; ++row) {
    const auto up = static_cast<float>(31 - row) / 31;
    for (int column = 0; column < 64; ++column)
      image.at(column, row) = {0.8F - 0.5F * up, 0.8F - 0.3F * up, 0.8F};
  }
  return image;
}

/// The lesson's picture by a way, in packs of a number.
template <class Number>
Image drawn(const Lesson& lesson, SkyLighting way, const Sampler& sampler, int width, int height,
            int threads) {
  Lesson lit = lesson;
  lit.sky.matte.way = way;
  const View<> view = view_of(lit.stage.camera, width, height);
  return develop(
      gather<Pack2<Pack<Number>>>(lit, lit.objects, view, {sampler}, {}, {.threads = threads}),
      Transfer::srgb);
}

/// Root mean square difference in levels of 255.
double apart(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgb8 &p = a.pixels[i], &q = b.pixels[i];
    sum += square(1.0 * p.r - q.r) + square(1.0 * p.g - q.g) + square(1.0 * p.b - q.b);
  }
  return std::sqrt(sum / (3 * static_cast<double>(a.pixels.size())));
}

}  // namespace

void SkyComparison::note_times(const std::vector<WorkTime>& times) {
  for (std::size_t i = 0; i < figures.size(); ++i) {
    figures[i].microseconds = 1000 * times[i].processor / (timed_width * timed_height);
    figures[i].spread = times[i].spread;
  }
}

SkyComparison compare_skies(int threads, const std::function<void()>& tick) {
  std::array<std::pair<const char*, SkyLight>, skies_compared> skies = {
      std::pair("uniform", SkyLight(Environment(LightImage(2, 1, gray(0.8F))))),
      std::pair("gradient", SkyLight(Environment(gradient()))),
      std::pair("sun", SkyLight(Environment(load_light(find_texture("sky.hdr")))))};
  SkyComparison all;
  const auto done = [&](int samples) {
    all.paths += 1.0 * front_width * front_height * samples;
    if (tick) tick();
  };
  for (auto& [name, light] : skies) {
    const auto lesson = std::make_shared<Lesson>();
    lesson->stage.sky = std::move(light);
    const SkyNoise noise = noise_of(lesson->stage.sky);
    const SkyLighting best = best_lighting(noise);
    all.choice.append(all.choice.empty() ? "" : "; ").append(name);
    all.choice.append(": cosine ").append(shown(noise.cosine, 3));
    if (!lesson->stage.sky.is_constant()) all.choice.append(", mis ").append(shown(noise.mis, 3));
    // Its own noise is larger than what float rounds.
    const Image reference =
        drawn<float>(*lesson, best, Sampler(SamplerKind::sobol, front_reference_samples, 99),
                     front_width, front_height, threads);
    done(front_reference_samples);
    for (const Way& way : ways) {
      for (const int samples : sample_counts) {
        const Sampler sampler(SamplerKind::sobol, samples);
        const Image image =
            drawn<double>(*lesson, way.lighting, sampler, front_width, front_height, threads);
        all.figures.push_back({.sky = name,
                               .way = way.name,
                               .samples = samples,
                               .error = apart(image, reference),
                               .chosen = way.lighting == best});
        all.works.emplace_back([lesson, lighting = way.lighting, sampler] {
          static_cast<void>(
              drawn<double>(*lesson, lighting, sampler, timed_width, timed_height, 1));
        });
        done(samples);
      }
    }
  }
  return all;
}

}  // namespace texmap::chapter_12
