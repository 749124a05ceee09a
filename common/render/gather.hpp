// Gathers light: many samples a pixel, each a path of its own.
#pragma once
#include <algorithm>
#include <optional>

#include "film.hpp"
#include "render.hpp"
#include "samplers.hpp"
#include "screen_bounds.hpp"

// All that a sample calls becomes one piece of code: a fifth faster, since what no one asks for falls away. Compilers that
// watch each step need minutes and gigabytes for it, and are not asked, nor are tests, which have time.
#if defined(__GNUC__) && !defined(TEXMAP_NO_FLATTEN)
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

/// What is known of a picture before a sample is drawn.
struct Foresight {
  ScreenBounds objects;      ///< outside of this part of the picture there is nothing but sky,
  std::optional<Rgb> light;  ///< of this light, if it is the same for every sample
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

/// A lesson whose color along a ray is a matter of chance. Its ready<Real>(view) makes what all samples have in common, in the
/// number that draws; it is called with that, with a place on the picture and with numbers.
template <class Lesson>
concept GathersLight = requires(const Lesson& lesson) {
  lesson.gathering;
};

/// Draws the samples of a lesson that gathers light, and adds them to its film. Found by `draw` in place of the `render` for
/// plain lessons.
///
/// A lesson may have foresight(view), an optional Foresight: samples beside all objects do not look for them, and where their
/// light is known there are none.
/// @return  an empty picture: what the film shows is asked of the film
template <class Real, GathersLight Lesson>
[[nodiscard]] Image render(const Lesson& lesson, const View& view, const RenderSettings& settings) {
  constexpr int step = static_cast<int>(lanes<Real>);
  const Gathering& gathering = lesson.gathering;
  Film& film = *gathering.film;
  const int samples = gathering.sampler.samples();
  const auto scene = lesson.template ready<Real>(view);
  film.begin(gathering.in_first_half, samples - gathering.in_first_half);
  std::optional<Foresight> foresight;
  if constexpr (requires { lesson.foresight(view); }) foresight = lesson.foresight(view);
  const auto sky_alone = scene.without_objects();

  gathering.sampler.visit([&](const auto& pattern) {
    const auto add_samples = [&](const auto& seen, const Real& columns, const Real& row, const Bits<Real>& pixels, int first,
                                 int end, Color<Real>& result) TEXMAP_FLATTEN {
      Color<Real> sum{};
      for (int i = first; i < end; ++i) {
        SampleNumbers<Real, std::decay_t<decltype(pattern)>> numbers(pattern, pixels, i);
        sum = sum + lesson(seen, columns, row, numbers);
      }
      result = sum;
    };
    // The pixels of a row from `begin` to before `end`, by samples of what is seen.
    const auto draw_pixels = [&](const auto& seen, int row, int begin, int end) {
      for (int column = begin; column < end; column += step) {
        const auto first = static_cast<Scalar<Real>>(column);
        const Real columns = from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
        const Bits<Real> pixels = pixel_bits<Real>(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        const auto lanes_of = [](const Color<Real>& c) { return std::array{all_lanes(c.r), all_lanes(c.g), all_lanes(c.b)}; };
        Color<Real> first_half, second_half;
        add_samples(seen, columns, Real(row), pixels, 0, gathering.in_first_half, first_half);
        add_samples(seen, columns, Real(row), pixels, gathering.in_first_half, samples, second_half);
        const auto firsts = lanes_of(first_half);
        const auto seconds = lanes_of(second_half);
        for (int i = 0; i < step && column + i < end; ++i) {
          const auto in_lane = [at = static_cast<std::size_t>(i)](const auto& channels) {
            return Rgb{static_cast<double>(channels[0][at]), static_cast<double>(channels[1][at]),
                       static_cast<double>(channels[2][at])};
          };
          film.add(column + i, row, in_lane(firsts), in_lane(seconds));
        }
      }
    };
    for_each_row(view.height, settings.threads, settings.progress, [&](int row) {
      Span span{0, view.width};
      if (foresight) span = foresight->objects.columns(row, view.width);
      if (foresight && !foresight->light)
        span = {span.first / step * step, std::min((span.end + step - 1) / step * step, view.width)};
      const auto draw_sky = [&](int begin, int end) {
        if (!foresight->light) return draw_pixels(sky_alone, row, begin, end);
        for (int column = begin; column < end; ++column) {
          film.add(column, row, *foresight->light * static_cast<double>(gathering.in_first_half),
                   *foresight->light * static_cast<double>(samples - gathering.in_first_half));
        }
      };
      if (foresight) draw_sky(0, span.first);
      draw_pixels(scene, row, span.first, span.end);
      if (foresight) draw_sky(span.end, view.width);
      film.finish_row(row);
    });
  });
  return {};
}

}  // namespace texmap
