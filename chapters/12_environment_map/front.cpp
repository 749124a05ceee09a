// The front of error against time: five ways to light matte objects by three skies.
// usage: 12_sky_front [ROUNDS]   prints a table; times: the least of so many rounds, one thread
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

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

using Real = Pack2<Pack<double>>;

struct Way {
  SkyLighting lighting;
  const char* name;
};
constexpr std::array ways = {
    Way{SkyLighting::uniform, "uniform"}, Way{SkyLighting::cosine, "cosine"},
    Way{SkyLighting::importance, "importance"}, Way{SkyLighting::mis, "mis"},
    Way{SkyLighting::coefficients, "coefficients"}};

LightImage gradient() {
  LightImage image(64, 32);
  for (int row = 0; row < 32; ++row) {
    const auto up = static_cast<float>(31 - row) / 31;
    for (int column = 0; column < 64; ++column)
      image.at(column, row) = {0.8F - 0.5F * up, 0.8F - 0.3F * up, 0.8F};
  }
  return image;
}

Image drawn(const Lesson& lesson, int samples, std::uint32_t seed) {
  const View<> view = view_of(lesson.stage.camera, 160, 90);
  return develop(gather<Real>(lesson, lesson.objects, view,
                              {Sampler(SamplerKind::sobol, samples, seed)}, {}, {.threads = 1}),
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

/// Milliseconds of one drawing.
double milliseconds(const Lesson& lesson, int samples) {
  const auto start = std::chrono::steady_clock::now();
  static_cast<void>(drawn(lesson, samples, 0));
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return time.count();
}

void print_sky(const char* name, SkyLight sky, int rounds) {
  constexpr std::array samples = {4, 16, 64, 256};
  Lesson lesson;
  lesson.environment = std::move(sky);
  const SkyNoise noise = noise_of(lesson.environment);
  const SkyLighting best = best_lighting(noise);
  lesson.sky.matte.way = best;
  const Image reference = drawn(lesson, 8192, 99);
  std::array<std::array<double, samples.size()>, ways.size()> least;
  for (auto& row : least) row.fill(infinity<double>());
  for (int round = 0; round < rounds; ++round) {  // the ways alternate: a busy machine slows all
    for (std::size_t k = 0; k < samples.size(); ++k) {
      for (std::size_t i = 0; i < ways.size(); ++i) {
        lesson.sky.matte.way = ways[i].lighting;
        least[i][k] = min(least[i][k], milliseconds(lesson, samples[k]));
      }
    }
  }
  std::cout << "\n"
            << name << " (one direction is off by " << shown(noise.cosine, 3)
            << " of its light by the cosine, by " << shown(noise.mis, 3) << " by mis)\n\n"
            << "| way | 4 samples | 16 | 64 | 256 |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < ways.size(); ++i) {
    lesson.sky.matte.way = ways[i].lighting;
    std::cout << "| " << ways[i].name << (ways[i].lighting == best ? ", chosen by auto" : "");
    for (std::size_t k = 0; k < samples.size(); ++k) {
      std::cout << " | " << shown(apart(drawn(lesson, samples[k], 0), reference), 3) << " in "
                << shown(least[i][k], 3) << " ms" << std::flush;
    }
    std::cout << " |\n";
  }
}

}  // namespace
}  // namespace texmap::chapter_12

int main(int argc, char** argv) try {
  using namespace texmap;
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 3;
  chapter_12::print_sky("A uniform sky", SkyLight(Environment(LightImage(2, 1, gray(0.8F)))),
                        rounds);
  chapter_12::print_sky("A gradient", SkyLight(Environment(chapter_12::gradient())), rounds);
  chapter_12::print_sky("A sun", SkyLight(Environment(load_light(find_texture("sky.hdr")))),
                        rounds);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 1;
}
