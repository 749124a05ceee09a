// Gathers light: many samples a pixel, each a path of its own.
#pragma once
#include <algorithm>
#include <optional>

#include "film.hpp"
#include "pixel_lists.hpp"
#include "render.hpp"
#include "sample_numbers.hpp"

namespace texmap {

/// Which samples of each pixel to draw.
struct Gathering {
  Sampler sampler{SamplerKind::sobol, 1};  ///< all its samples are drawn
  int in_first_half = 0;                   ///< how many of them go to the film's first half; the rest go to the second
  Film* film = nullptr;
};

/// How many rows are drawn together.
inline constexpr int rows_at_a_time = 4;

/// A lesson whose color along a ray is a matter of chance. Its ready<Real>(view) makes what all samples have in common, in the
/// number that draws; it is called with that, with a place on the picture and with numbers.
template <class Lesson>
concept GathersLight = requires(const Lesson& lesson) {
  lesson.gathering;
};

/// Draws the samples of some pixels, and adds them to the film.
///
/// @param pixels   packed together in this order
/// @param path_of  called with columns and rows of a pack, gives what makes the light of one sample of SampleNumbers
template <class Real, class PathOf>
void gather_pixels(const Gathering& gathering, const std::vector<Pixel>& pixels, const PathOf& path_of) {
  const int samples = gathering.sampler.samples();
  SampleSums<Real> sums(gathering.sampler);
  for (std::size_t begin = 0; begin < pixels.size(); begin += lanes<Real>) {
    // The last pack may have lanes too many: they draw its last pixel again, for no one.
    const auto pixel = [&](std::size_t i) -> const Pixel& { return pixels[std::min(begin + i, pixels.size() - 1)]; };
    const Real column = from_lanes<Real>([&](std::size_t i) { return static_cast<Scalar<Real>>(pixel(i).column); });
    const Real row = from_lanes<Real>([&](std::size_t i) { return static_cast<Scalar<Real>>(pixel(i).row); });
    const Bits<Real> bits = bits_of_pixels<Real>(bits_from_real(column), bits_from_real(row));
    const auto path = path_of(column, row);
    Color<Real> first_half{}, second_half{};
    sums.add(bits, 0, gathering.in_first_half, path, first_half);
    sums.add(bits, gathering.in_first_half, samples, path, second_half);

    const auto lanes_of = [](const Color<Real>& c) { return std::array{all_lanes(c.r), all_lanes(c.g), all_lanes(c.b)}; };
    const auto firsts = lanes_of(first_half);
    const auto seconds = lanes_of(second_half);
    for (std::size_t i = 0; i < std::min(lanes<Real>, pixels.size() - begin); ++i) {
      const auto in_lane = [i](const auto& channels) {
        return Rgb{static_cast<double>(channels[0][i]), static_cast<double>(channels[1][i]),
                   static_cast<double>(channels[2][i])};
      };
      gathering.film->add(pixel(i).column, pixel(i).row, in_lane(firsts), in_lane(seconds));
    }
  }
}

/// Draws the samples of a lesson that gathers light, and adds them to its film. Found by `draw` in place of the `render` for
/// plain lessons.
///
/// A lesson may have foresight(view), an optional Foresight, if its scene has one sphere: samples beside it do not look for it,
/// where their light is known there are none, and smooth pixels are patches. Pixels of some rows that are drawn alike are
/// packed together, wherever they lie in them.
/// @return  an empty picture: what the film shows is asked of the film
template <class Real, GathersLight Lesson>
[[nodiscard]] Image render(const Lesson& lesson, const View& view, const RenderSettings& settings) {
  const Gathering& gathering = lesson.gathering;
  Film& film = *gathering.film;
  const int samples = gathering.sampler.samples();
  const auto scene = lesson.template ready<Real>(view);
  film.begin(gathering.in_first_half, samples - gathering.in_first_half);
  std::optional<Foresight> foresight;
  if constexpr (requires { lesson.foresight(view); }) foresight = lesson.foresight(view);
  if (samples < least_samples_of_patch && foresight) foresight->smoothing = {};
  const auto sky_alone = scene.without_objects();

  const auto paths_in = [&](const auto& seen) {
    return [&](const Real& column, const Real& row) {
      return [&, column, row](auto& numbers) { return lesson(seen, column, row, numbers); };
    };
  };
  // Some rows at a time: lists so long fill their packs.
  const int blocks = (view.height + rows_at_a_time - 1) / rows_at_a_time;
  const auto rows_done = [&](int done, int) { settings.progress(std::min(done * rows_at_a_time, view.height), view.height); };
  for_each_row(blocks, settings.threads, settings.progress ? rows_done : decltype(settings.progress){}, [&](int block) {
    const int first_row = block * rows_at_a_time;
    const int end_row = std::min(first_row + rows_at_a_time, view.height);
    PixelLists lists;
    for (int row = first_row; row < end_row; ++row) {
      if (foresight) {
        add_row<Real>(lists, row, view.width, scene, *foresight);
      } else {
        add_row(lists, row, view.width);
      }
    }
    if (foresight && foresight->light) {
      const Rgb& light = *foresight->light;
      for (const Pixel& at : lists.beside) {
        film.add(at.column, at.row, light * static_cast<double>(gathering.in_first_half),
                 light * static_cast<double>(samples - gathering.in_first_half));
      }
    } else if (foresight && foresight->smooths_sky(view)) {
      gather_pixels<Real>(gathering, lists.beside,
                          [&](const Real& column, const Real& row) { return scene.sky_patch(column, row); });
    } else {
      gather_pixels<Real>(gathering, lists.beside, paths_in(sky_alone));
    }
    if constexpr (requires(Real place) { scene.pixel_patch(place, place); }) {
      gather_pixels<Real>(gathering, lists.patches,
                          [&](const Real& column, const Real& row) { return scene.pixel_patch(column, row); });
    }
    gather_pixels<Real>(gathering, lists.others, paths_in(scene));
    for (int row = first_row; row < end_row; ++row) film.finish_row(row);
  });
  return {};
}

}  // namespace texmap
