// The figures of chapter 12's page.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "12_environment_map/lesson.hpp"
#include "engine/app/sky_choice.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_light.hpp"
#include "engine/render/develop.hpp"
#include "engine/render/gather.hpp"
#include "figures.hpp"

namespace texmap::test {
namespace {

using chapter_12::Lesson;

/// A small picture of the lesson, its matte surfaces lit in some way.
Image lit(Lesson& lesson, SkyLighting way, int samples) {
  lesson.sky.matte.way = way;
  const View<> view = view_of(lesson.stage.camera, 48, 27);
  return develop(gather<Pack<double>>(lesson, lesson.objects, view,
                                      {Sampler(SamplerKind::sobol, samples)}, {}, {}),
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

/// The errors of the five ways, with 16 and with 64 samples.
void add_errors(Figures& figures, const std::string& sky, SkyLight light) {
  Lesson lesson;
  lesson.stage.sky = std::move(light);
  const SkyNoise noise = noise_of(lesson.stage.sky);
  const Image reference = lit(lesson, best_lighting(noise), 1024);
  const std::array<std::pair<SkyLighting, const char*>, 5> ways{
      {{SkyLighting::uniform, "uniform"},
       {SkyLighting::cosine, "cosine"},
       {SkyLighting::importance, "importance"},
       {SkyLighting::mis, "mis"},
       {SkyLighting::coefficients, "coefficients"}}};
  for (const auto& [way, name] : ways) {
    for (const int samples : {16, 64}) {
      figures.emplace_back("12.error_" + sky + "_" + name + "_" + std::to_string(samples),
                           decimals(apart(lit(lesson, way, samples), reference), 1));
    }
  }
}

/// Where the sky is read in a direction, and its light there.
void add_direction(Figures& figures, const std::string& name, const Environment& sky,
                   const Vec3d& direction) {
  const Uv<double> uv = uv_rtiow(direction);
  const Color<double> light = sky(Ray<double>{{}, direction});
  figures.emplace_back("12.uv_" + name, decimals(uv.u, 3) + ", " + decimals(uv.v, 3));
  figures.emplace_back("12.light_" + name, decimals(light.r, 2) + ", " + decimals(light.g, 2) +
                                               ", " + decimals(light.b, 2));
}

}  // namespace

void figures_of_12(Figures& figures) {
  const LightImage map = load_light(find_texture("sky.hdr"));
  figures.emplace_back("12.texels", whole(static_cast<long long>(map.width) * map.height));
  figures.emplace_back("12.width", whole(map.width));
  figures.emplace_back("12.height", whole(map.height));
  const auto texel = [&](int row) {
    return digits(1e6 * SkyBand(row, map.width, map.height).solid_angle, 3);
  };
  figures.emplace_back("12.texel_at_pole", texel(0));
  figures.emplace_back("12.texel_at_equator", texel(map.height / 2));

  // What bytes would lose: all light above 1.
  LightImage cut = map;
  float brightest = 0;
  std::size_t sun = 0;
  for (std::size_t i = 0; i < cut.pixels.size(); ++i) {
    Color<float>& light = cut.pixels[i];
    if (light.r > brightest) sun = i;
    brightest = std::max(brightest, light.r);
    light = {std::min(light.r, 1.0F), std::min(light.g, 1.0F), std::min(light.b, 1.0F)};
  }
  figures.emplace_back("12.brightest", whole(std::lround(static_cast<double>(brightest))));
  const SkyNoise noise = noise_of(SkyLight(Environment(map)));
  figures.emplace_back("12.noise_cosine", decimals(noise.cosine, 0));
  figures.emplace_back("12.noise_mis", decimals(noise.mis, 2));
  const Rgb all = SkyMoments(Environment(map)).sums()[0];
  const Rgb left = SkyMoments(Environment(cut)).sums()[0];
  figures.emplace_back("12.red_lost", decimals(100 * (1 - left.r / all.r), 0));
  figures.emplace_back("12.green_lost", decimals(100 * (1 - left.g / all.g), 0));
  figures.emplace_back("12.blue_lost", decimals(100 * (1 - left.b / all.b), 0));

  const Environment sky(map);
  add_direction(figures, "px", sky, {1, 0, 0});
  add_direction(figures, "py", sky, {0, 1, 0});
  add_direction(figures, "mz", sky, {0, 0, -1});
  const auto columns = static_cast<std::size_t>(map.width);
  const auto row = static_cast<double>(sun / columns);
  const Vec3d to_sun = direction_rtiow(Uv<double>{
      (static_cast<double>(sun % columns) + 0.5) / map.width, 1 - (row + 0.5) / map.height});
  figures.emplace_back("12.sun", decimals(to_sun.x, 4) + ", " + decimals(to_sun.y, 4) + ", " +
                                     decimals(to_sun.z, 4));
  add_direction(figures, "sun", sky, to_sun);

  // By the cosine, directions within an angle r of the normal have the probability sin^2 r.
  const double radius = 1.4 * std::numbers::pi / 180;
  figures.emplace_back("12.directions_to_sun", whole(std::lround(1e6 * square(std::sin(radius)))));
  figures.emplace_back(
      "12.equator_to_pole",
      whole(std::lround(SkyBand(map.height / 2, map.width, map.height).solid_angle /
                        SkyBand(0, map.width, map.height).solid_angle)));

  add_errors(figures, "uniform", SkyLight(Environment(LightImage(2, 1, gray(0.8F)))));
  add_errors(figures, "sun", SkyLight(Environment(map)));
}

}  // namespace texmap::test
