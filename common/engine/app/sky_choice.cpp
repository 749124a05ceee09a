// Which way to gather a sky's light its picture requires.
#include "engine/app/sky_choice.hpp"

#include <cmath>
#include <numbers>

namespace texmap {

SkyNoise noise_of(const SkyLight& sky) {
  if (sky.is_constant() || !(sky.sampler.total() > 0)) return {.uniform = 1};
  const LightImage& map = sky.picture.map();
  const double total = sky.sampler.total();
  double light_squared = 0;
  SkyNoise squares;
  for (int axis = 0; axis < 6; ++axis) {
    double light = 0;
    SkyNoise second;  // moments of one direction's light
    std::size_t texel = 0;
    for (int row = 0; row < map.height; ++row) {
      const SkyBand& band = sky.sampler.bands()[static_cast<std::size_t>(row)];
      const double below_pole = (band.from + band.to) / 2;
      const double y = band.y_sign * (1 - below_pole);
      const double radius = std::sqrt(below_pole * (2 - below_pole));
      for (int column = 0; column < map.width; ++column, ++texel) {
        const OnCircle<double> around = on_circle(0.5 - (column + 0.5) / map.width);
        const std::array along = {radius * around.cosine, y, radius * around.sine};
        const double component = along[static_cast<std::size_t>(axis / 2)];
        const double lambert =
            std::max(axis % 2 == 0 ? component : -component, 0.0) / std::numbers::pi;
        const double density = sky.sampler.probabilities()[texel] / band.solid_angle;
        if (lambert == 0 || density == 0) continue;
        const double sent = density * total * lambert;
        light += sent * band.solid_angle;
        const double square_of_it = sent * sent * band.solid_angle;
        second.uniform += square_of_it * 4 * std::numbers::pi;
        second.cosine += square_of_it / lambert;
        second.importance += square_of_it / density;
        second.mis += square_of_it * 2 / (lambert + density);
      }
    }
    light_squared += light * light;
    squares.uniform += second.uniform - light * light;
    squares.cosine += second.cosine - light * light;
    squares.importance += second.importance - light * light;
    squares.mis += second.mis - light * light;
  }
  const auto relative = [light_squared](double variance) {
    return std::sqrt(std::max(variance, 0.0) / light_squared);
  };
  return {relative(squares.uniform), relative(squares.cosine), relative(squares.importance),
          relative(squares.mis)};
}

double cost_of(SkyLighting way) {
  switch (way) {  // measured: chapter 12's matte objects, packs of double
    case SkyLighting::uniform:
      return 0.6;  // half of all paths end below the surface
    case SkyLighting::importance:
      return 1.4;
    case SkyLighting::mis:
      return 1.5;
    default:
      return 1;
  }
}

SkyLighting best_lighting(const SkyNoise& noise) {
  const auto price = [](double of, SkyLighting way) { return of * of * cost_of(way); };
  const double cosine = price(noise.cosine, SkyLighting::cosine);
  const double mis = price(noise.mis, SkyLighting::mis);
  return mis < cosine ? SkyLighting::mis : SkyLighting::cosine;
}

}  // namespace texmap
