// Chapter 07 for a page: where the samples of a pixel are, and how far apart their light is.
#pragma once
#include <cmath>

#include "07_earth_by_sampling/lesson.hpp"
#include "figure.hpp"
#include "live.hpp"

namespace texmap::live {

/// What a page tells of samples: their mean, their spread, their places in the pixel.
template <class State>
void add_samples(const State& state, int column, int row, Members& members) {
  Figure figure{"The pixel's square: each sample in its place, with its light"};
  const auto& sampling = state.lesson.sampling;
  Rgb sum{}, squares{};
  int count = 0;
  state.gathered->for_each_sample(column, row, [&](const Point2<double>& at, const Rgb& light) {
    const auto shown = [&](double x) { return byte_of_light(x, sampling.transfer) / 255; };
    figure.dot(at.u, at.v, Figure::css({shown(light.r), shown(light.g), shown(light.b)}));
    sum = sum + light;
    squares = squares + light * light;
    ++count;
  });
  const Rgb mean = sum * (1.0 / count);
  const auto spread = [&](double sum_of_squares, double m) {
    return std::sqrt(std::max(sum_of_squares / count - m * m, 0.0));
  };
  const Vec3d spreads{spread(squares.r, mean.r), spread(squares.g, mean.g),
                      spread(squares.b, mean.b)};
  const double root = std::sqrt(count);
  members.emplace_back(
      "rows", Json::list({fact("mean light", {mean.r, mean.g, mean.b}, {" of ", count, " samples"}),
                          fact("spread", spreads, {": how far a sample is from the mean"}),
                          fact("error of the mean", spreads * (1 / root),
                               {": if samples are random, spread / √", count})}));
  members.emplace_back("figure", figure.json());
}

struct GlobeBySampling {
  template <class State>
  [[nodiscard]] Members look(const State& state, int column, int row) const {
    Members members;
    if (state.gathered) {
      add_samples(state, column, row, members);
      return members;
    }
    const chapter_07::Lesson& lesson = state.lesson;
    return what_a_ray_meets(lesson, ray_through(state.whole, double(column), double(row)));
  }
};

using Chapter07 = Live<chapter_07::Lesson, GlobeBySampling>;

}  // namespace texmap::live
