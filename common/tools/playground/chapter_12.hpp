// Chapter 12: where on the sky's map the samples of a pixel go.
#pragma once
#include <tuple>
#include <utility>

#include "12_environment_map/lesson.hpp"
#include "chapter_07.hpp"

namespace texmap::live {

struct SamplesOnTheSky {
  /// Takes the sky that the lesson before has loaded, if it is the same.
  static bool take_over(chapter_12::Lesson& lesson, chapter_12::Lesson& before) {
    const auto loaded = [](const chapter_12::Lesson& one) {
      const SkyOptions& sky = one.sky;
      return std::tie(sky.name, sky.exposure, sky.degrees, sky.mirrored, sky.filter, sky.chosen);
    };
    if (loaded(lesson) != loaded(before)) return false;
    std::swap(lesson.stage.sky, before.stage.sky);
    lesson.sky.matte.way = before.sky.matte.way;
    return true;
  }

  template <class State>
  [[nodiscard]] Members look(const State& state, int column, int row) const {
    const chapter_12::Lesson& lesson = state.lesson;
    const Ray<double> ray = ray_through(state.whole, double(column), double(row));
    const Nearest<double> nearest = find_nearest(lesson.objects, ray);
    Members members;
    if (!state.gathered) return what_a_ray_meets(lesson, ray);
    add_samples(state, column, row, members);
    const bool matte = nearest.index >= 0 &&
                       !lesson.objects[static_cast<std::size_t>(nearest.index)].paint.mirrors;
    if (!matte || lesson.sky.matte.way == SkyLighting::coefficients) return members;
    const Hit<double> hit = hit_at(lesson.objects[static_cast<std::size_t>(nearest.index)].shape,
                                   ray, nearest.distance);
    members.back().second = sky_figure(state, hit, column, row).json();
    return members;
  }

  /// The sky's map, and the directions in which the samples leave a matte surface at the pixel's
  /// middle: with the numbers that the program draws there.
  template <class State>
  [[nodiscard]] static Figure sky_figure(const State& state, const Hit<double>& hit, int column,
                                         int row) {
    constexpr int wide = 32, high = 16;
    const SkyLight& sky = state.lesson.stage.sky;
    const auto& sampling = state.lesson.sampling;
    Figure figure{
        "The sky's map: a dot for each sample, where it leaves the surface; white where "
        "it weighs much, black where it is lost",
        2, 1};
    for (int i = 0; i < wide * high; ++i) {
      const double u = (i % wide + 0.5) / wide, v = 1 - (i / wide + 0.5) / high;
      const Color<double> light = sky.picture.at(Uv<double>{u, v});
      const auto shown = [&](double x) { return byte_of_light(x, sampling.transfer) / 255; };
      figure.box(2 * u - 1.0 / wide, 1 - v - 0.5 / high, 2.02 / wide, 1.02 / high,
                 Figure::css({shown(light.r), shown(light.g), shown(light.b)}));
    }
    const auto pixel =
        hash_pixels<double>(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
    const Sampler& sampler = state.gathered->sampler();
    // The lens has drawn its numbers before the surface does.
    const std::uint32_t next =
        1U + (sampling.lens.defocus_degrees > 0 ? 1U : 0U) + (sampling.lens.shift != 0 ? 1U : 0U);
    const SkyLighting lighting = state.lesson.sky.matte.way;
    const auto dot_at = [&](const Vec3d& direction, double weight) {
      const Uv<double> uv = uv_rtiow(sky.picture.to_map(direction));
      figure.dot(2 * uv.u, 1 - uv.v, Figure::css(gray(min(weight, 1.0))));
    };
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(sampler.samples()); ++i) {
      const auto numbers = [&](std::uint32_t pair) {
        return sampler.pair<double>(pixel, i, next + pair);
      };
      const auto way = scatter(lighting, sky, hit.normal, numbers(0));
      if (lighting != SkyLighting::mis) {
        dot_at(way.direction, way.weight);
        continue;
      }
      for (const auto& d : {sky.toward(way.direction), sky.draw(true, numbers(1))}) {
        const double cosine = max(dot(hit.normal, d.direction), 0.0);
        dot_at(d.direction, weight_of_both(cosine, sky.density(true, d)));
      }
    }
    return figure;
  }
};

using Chapter12 = Live<chapter_12::Lesson, SamplesOnTheSky>;

}  // namespace texmap::live
