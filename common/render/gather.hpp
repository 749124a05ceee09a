// Gathers light: many samples a pixel, each a path of its own.
#pragma once
#include <algorithm>
#include <optional>

#include "film.hpp"
#include "render.hpp"
#include "samplers.hpp"

namespace texmap {

/// Which samples of each pixel to draw.
struct Gathering {
  Sampler sampler{SamplerKind::sobol, 1};  ///< all its samples are drawn
  int in_first_half = 0;                   ///< how many of them go to the film's first half; the rest go to the second
  Film* film = nullptr;
};

/// The numbers of one sample in a pack of pixels: dimension after dimension.
template <class Real>
class SampleNumbers {
 public:
  SampleNumbers(const Sampler& sampler, const Bits<Real>& pixels, int sample)
      : sampler_(sampler), pixels_(pixels), sample_(static_cast<std::uint32_t>(sample)) {}

  /// The next two numbers in [0, 1): every use in a sample has a dimension of its own.
  template <class>
  [[nodiscard]] Sample2<Real> pair() {
    return sampler_.template pair<Real>(pixels_, sample_, dimension_++);
  }

 private:
  const Sampler& sampler_;
  const Bits<Real>& pixels_;
  std::uint32_t sample_;
  std::uint32_t dimension_ = 0;
};

/// A lesson whose color along a ray is a matter of chance: called with a view, a place on the picture and numbers.
template <class Lesson>
concept GathersLight = requires(const Lesson& lesson) {
  lesson.gathering;
};

/// Draws the samples of a lesson that gathers light, and adds them to its film. Found by `draw` in place of the `render` for
/// plain lessons.
///
/// A lesson may have certain_light(view, first column, last column, row): the light of these pixels if it is known beforehand.
/// @return  an empty picture: what the film shows is asked of the film
template <class Real, GathersLight Lesson>
[[nodiscard]] Image render(const Lesson& lesson, const View& view, const RenderSettings& settings) {
  constexpr int step = static_cast<int>(lanes<Real>);
  const Gathering& gathering = lesson.gathering;
  Film& film = *gathering.film;
  for_each_row(view.height, settings.threads, settings.progress, [&](int row) {
    for (int column = 0; column < view.width; column += step) {
      const auto first = static_cast<Scalar<Real>>(column);
      const Real columns = from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
      if constexpr (requires { lesson.certain_light(view, column, column, row); }) {
        // What is known without a sample needs none.
        const std::optional<Rgb> light = lesson.certain_light(view, column, column + step - 1, row);
        if (light) {
          const int samples = gathering.sampler.samples();
          for (int i = column; i < std::min(column + step, view.width); ++i) {
            film.add(i, row, *light * static_cast<double>(gathering.in_first_half),
                     *light * static_cast<double>(samples - gathering.in_first_half));
          }
          continue;
        }
      }
      const Bits<Real> pixels = pixel_bits<Real>(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
      Color<Real> first_half{}, second_half{};
      for (int i = 0; i < gathering.sampler.samples(); ++i) {
        SampleNumbers<Real> numbers(gathering.sampler, pixels, i);
        const Color<Real> light = lesson(view, columns, Real(row), numbers);
        Color<Real>& half = i < gathering.in_first_half ? first_half : second_half;
        half = half + light;
      }
      const auto lanes_of = [](const Color<Real>& c) { return std::array{all_lanes(c.r), all_lanes(c.g), all_lanes(c.b)}; };
      const auto firsts = lanes_of(first_half);
      const auto seconds = lanes_of(second_half);
      for (int i = 0; i < step && column + i < view.width; ++i) {
        const auto in_lane = [at = static_cast<std::size_t>(i)](const auto& channels) {
          return Rgb{static_cast<double>(channels[0][at]), static_cast<double>(channels[1][at]),
                     static_cast<double>(channels[2][at])};
        };
        film.add(column + i, row, in_lane(firsts), in_lane(seconds));
      }
    }
  });
  return {};
}

}  // namespace texmap
