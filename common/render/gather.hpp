// Gathers light: many samples a pixel, each a path of its own.
#pragma once
#include <algorithm>
#include <optional>

#include "film.hpp"
#include "render.hpp"
#include "samplers.hpp"
#include "screen_bounds.hpp"

// All that a sample calls becomes one piece of code: a fifth faster, since what no one asks for falls away. Compilers that
// watch each step need minutes and gigabytes for it, and are not asked.
#if defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TEXMAP_FLATTEN __attribute__((flatten))
#else
#define TEXMAP_FLATTEN
#endif

namespace texmap {

/// Which samples of each pixel to draw.
struct Gathering {
  Sampler sampler{SamplerKind::sobol, 1};  ///< all its samples are drawn
  int in_first_half = 0;                   ///< how many of them go to the film's first half; the rest go to the second
  Film* film = nullptr;
};

/// What is known of a picture without a sample.
struct CertainLight {
  Rgb light;             ///< of every pixel outside of
  ScreenBounds outside;  ///< this part of the picture
};

/// The numbers of one sample in a pack of pixels: dimension after dimension.
///
/// @tparam Pattern  one of the sampler's
template <class Real, class Pattern>
class SampleNumbers {
 public:
  SampleNumbers(const Pattern& pattern, const Bits<Real>& pixels, int sample)
      : pattern_(pattern), pixels_(pixels), sample_(static_cast<std::uint32_t>(sample)) {}

  /// The next two numbers in [0, 1): every use in a sample has a dimension of its own.
  [[nodiscard]] Sample2<Real> pair() { return pattern_.template pair<Real>(pixels_, sample_, dimension_++); }

 private:
  const Pattern& pattern_;
  const Bits<Real>& pixels_;
  std::uint32_t sample_;
  std::uint32_t dimension_ = 0;
};

/// A lesson whose color along a ray is a matter of chance: called with a ViewIn<Real>, a place on the picture and numbers.
template <class Lesson>
concept GathersLight = requires(const Lesson& lesson) {
  lesson.gathering;
};

/// Draws the samples of a lesson that gathers light, and adds them to its film. Found by `draw` in place of the `render` for
/// plain lessons.
///
/// A lesson may have certain_light(view), an optional CertainLight: those pixels get no samples.
/// @return  an empty picture: what the film shows is asked of the film
template <class Real, GathersLight Lesson>
[[nodiscard]] Image render(const Lesson& lesson, const View& view, const RenderSettings& settings) {
  constexpr int step = static_cast<int>(lanes<Real>);
  const Gathering& gathering = lesson.gathering;
  Film& film = *gathering.film;
  const int samples = gathering.sampler.samples();
  const ViewIn<Real> view_here = number_cast<Real>(view);
  film.begin(gathering.in_first_half, samples - gathering.in_first_half);
  std::optional<CertainLight> certain;
  if constexpr (requires { lesson.certain_light(view); }) certain = lesson.certain_light(view);

  gathering.sampler.visit([&](const auto& pattern) {
    const auto add_samples = [&](const Real& columns, const Real& row, const Bits<Real>& pixels, int first, int end,
                                 Color<Real>& result) TEXMAP_FLATTEN {
      Color<Real> sum{};
      for (int i = first; i < end; ++i) {
        SampleNumbers<Real, std::decay_t<decltype(pattern)>> numbers(pattern, pixels, i);
        sum = sum + lesson(view_here, columns, row, numbers);
      }
      result = sum;
    };
    for_each_row(view.height, settings.threads, settings.progress, [&](int row) {
      const Span open = certain ? certain->outside.columns(row, view.width) : Span{0, view.width};
      for (int column = 0; column < view.width; ++column) {
        if (column == open.first) column = open.end;
        if (column >= view.width) break;
        film.add(column, row, certain->light * static_cast<double>(gathering.in_first_half),
                 certain->light * static_cast<double>(samples - gathering.in_first_half));
      }
      for (int column = open.first; column < open.end; column += step) {
        const auto first = static_cast<Scalar<Real>>(column);
        const Real columns = from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
        const Bits<Real> pixels = pixel_bits<Real>(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        const auto lanes_of = [](const Color<Real>& c) { return std::array{all_lanes(c.r), all_lanes(c.g), all_lanes(c.b)}; };
        Color<Real> first_half, second_half;
        add_samples(columns, Real(row), pixels, 0, gathering.in_first_half, first_half);
        add_samples(columns, Real(row), pixels, gathering.in_first_half, samples, second_half);
        const auto firsts = lanes_of(first_half);
        const auto seconds = lanes_of(second_half);
        for (int i = 0; i < step && column + i < open.end; ++i) {
          const auto in_lane = [at = static_cast<std::size_t>(i)](const auto& channels) {
            return Rgb{static_cast<double>(channels[0][at]), static_cast<double>(channels[1][at]),
                       static_cast<double>(channels[2][at])};
          };
          film.add(column + i, row, in_lane(firsts), in_lane(seconds));
        }
      }
      film.finish_row(row);
    });
  });
  return {};
}

}  // namespace texmap
