// Which way to gather a sky's light its picture requires.
#include "engine/app/sky_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace texmap {

SkyNoise noise_of(const SkyLight& sky) {
  if (sky.is_constant() || !(sky.sampler.total() > 0)) return {.uniform = 1};
  const LightImage& map = sky.picture.map();
  std::vector<OnCircle<double>> around;
  around.reserve(static_cast<std::size_t>(map.width));
  for (int column = 0; column < map.width; ++column)
    around.push_back(on_circle(0.5 - (column + 0.5) / map.width));
  std::array<double, 6> light{};
  SkyNoise second;  // moments of one direction's light, summed over the axes
  std::size_t texel = 0;
  for (const SkyBand& band : sky.sampler.bands()) {
    const double below_pole = (band.from + band.to) / 2;
    const double y = band.y_sign * (1 - below_pole);
    const double radius = std::sqrt(below_pole * (2 - below_pole));
    for (const OnCircle<double>& turned : around) {
      const double density = sky.sampler.probabilities()[texel++] / band.solid_angle;
      if (density == 0) continue;
      const std::array direction = {radius * turned.cosine, y, radius * turned.sine};
      for (std::size_t axis = 0; axis < 3; ++axis) {  // one of its two ways faces the texel
        const double lambert = std::abs(direction[axis]) / std::numbers::pi;
        if (lambert == 0) continue;
        const double sent = density * sky.sampler.total() * lambert;
        light[2 * axis + (direction[axis] < 0 ? 1 : 0)] += sent * band.solid_angle;
        const double square_of_it = sent * sent * band.solid_angle;
        second.uniform += square_of_it * 4 * std::numbers::pi;
        second.cosine += square_of_it / lambert;
        second.importance += square_of_it * 8 / (lambert + 7 * density);
        second.mis += square_of_it * 2 / (lambert + density);
      }
    }
  }
  double squared = 0;
  for (const double of_axis : light) squared += of_axis * of_axis;
  const auto relative = [squared](double moment) {
    return std::sqrt(std::max(moment - squared, 0.0) / squared);
  };
  return {relative(second.uniform), relative(second.cosine), relative(second.importance),
          relative(second.mis)};
}

SkyLighting best_lighting(const SkyNoise& noise, double cost) {
  return square(noise.mis) * cost < square(noise.cosine) ? SkyLighting::mis : SkyLighting::cosine;
}

}  // namespace texmap
