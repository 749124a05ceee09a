// Gathers light: many samples per pixel, one path each.
#pragma once
#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/draw/film.hpp"
#include "engine/draw/render.hpp"
#include "engine/draw/sample_random.hpp"
#include "engine/fast/kernel_plan.hpp"
#include "engine/fast/pixel_lists.hpp"
#include "engine/fast/pixel_patch.hpp"
#include "scene/lens.hpp"

namespace texmap {

/// Some rows of a growing film: a thread fills them in memory of its own.
struct FilmRows {
  int begin;
  std::vector<Rgb> light;
  std::vector<double> differences;  ///< of each row: squared, of the means of the halves
};

/// A film that grows by rows, from the two halves of a sampler's samples; their difference
/// estimates the error.
class GrowingFilm {
 public:
  /// @param settings  error_so_far and take_row are used; must live as long
  GrowingFilm(int width, int height, const Sampler& sampler, const RenderSettings& settings)
      : settings_(settings),
        width_(static_cast<std::size_t>(width)),
        film_(width, settings.take_row ? 0 : height, sampler.samples()),
        first_(sampler.samples() / 2),
        second_(sampler.samples() - first_),
        differences_(static_cast<std::size_t>(height)) {}

  /// How many samples each half has.
  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int second() const { return second_; }
  [[nodiscard]] FilmRows rows(int begin, int end) const {
    const auto count = static_cast<std::size_t>(end - begin);
    return {begin, std::vector<Rgb>(count * width_), std::vector<double>(count)};
  }

  /// Sets a pixel from the sums of its two halves.
  void set(FilmRows& rows, const Pixel& at, const Rgb& first, const Rgb& second) const {
    const auto row = static_cast<std::size_t>(at.row - rows.begin);
    rows.light[row * width_ + static_cast<std::size_t>(at.column)] = (first + second) * of_all_;
    if (first_ > 0)
      rows.differences[row] += visible_difference(first * of_first_, second * of_second_);
  }
  /// Keeps complete rows, or hands them on, and reports them; called from any thread.
  void finish(const FilmRows& rows) {
    const Rgb* light = rows.light.data();
    int row = rows.begin;
    for (const double difference : rows.differences) {
      if (settings_.take_row) {
        settings_.take_row(row, light);
      } else {
        film_.set_row(row, light);
      }
      light += width_;
      differences_[static_cast<std::size_t>(row++)] = difference;
    }
    if (!settings_.error_so_far || first_ == 0) return;
    const std::lock_guard guard(lock_);
    for (const double difference : rows.differences) finished_ += difference;
    pixels_ += static_cast<double>(rows.light.size());
    settings_.error_so_far(error_of_halves(finished_, pixels_));
  }
  /// The film, when all rows are complete.
  [[nodiscard]] Film take() {
    double sum = 0;
    for (const double difference : differences_) sum += difference;
    if (first_ > 0)
      film_.error = error_of_halves(sum, static_cast<double>(width_ * differences_.size()));
    return std::move(film_);
  }

 private:
  const RenderSettings& settings_;
  std::size_t width_;
  Film film_;
  int first_, second_;
  double of_first_ = 1.0 / first_, of_second_ = 1.0 / second_, of_all_ = 1.0 / (first_ + second_);
  std::vector<double> differences_;
  std::mutex lock_;
  double finished_ = 0, pixels_ = 0;
};

/// Draws the samples of some pixels and sets them on the film.
///
/// @param pixels   packed in this order
/// @param path_of  called with columns and rows of a pack, returns the function of one sample
template <class Real, class PathOf>
void gather_pixels(const Sampler& sampler, const std::vector<Pixel>& pixels, const PathOf& path_of,
                   const GrowingFilm& film, FilmRows& rows) {
  SampleSums<Real> sums(sampler);
  for (std::size_t begin = 0; begin < pixels.size(); begin += lanes<Real>) {
    // Lanes beyond the end draw the last pixel again and are not used.
    const auto pixel = [&](std::size_t i) -> const Pixel& {
      return pixels[std::min(begin + i, pixels.size() - 1)];
    };
    const Real column =
        from_lanes<Real>([&](std::size_t i) { return static_cast<Scalar<Real>>(pixel(i).column); });
    const Real row =
        from_lanes<Real>([&](std::size_t i) { return static_cast<Scalar<Real>>(pixel(i).row); });
    const UInt<Real> hashes = hash_pixels<Real>(uint_from_real(column), uint_from_real(row));
    const auto path = path_of(column, row);
    Color<Real> first_half{}, second_half{};
    sums.add(hashes, 0, film.first(), path, first_half);
    sums.add(hashes, film.first(), film.first() + film.second(), path, second_half);

    const auto lanes_of = [](const Color<Real>& c) {
      return std::array{all_lanes(c.r), all_lanes(c.g), all_lanes(c.b)};
    };
    const auto firsts = lanes_of(first_half);
    const auto seconds = lanes_of(second_half);
    for (std::size_t i = 0; i < std::min(lanes<Real>, pixels.size() - begin); ++i) {
      const auto in_lane = [i](const auto& channels) {
        return Rgb{static_cast<double>(channels[0][i]), static_cast<double>(channels[1][i]),
                   static_cast<double>(channels[2][i])};
      };
      film.set(rows, pixel(i), in_lane(firsts), in_lane(seconds));
    }
  }
}

/// Whether a sample that meets nothing brings this light: a reader's lesson may change it.
template <class Real, class PathOf>
[[nodiscard]] bool brings(const Rgb& light, const Sampler& sampler, const PathOf& path_of) {
  const Real corner(0);
  const UInt<Real> hash = hash_pixels<Real>(uint_from_real(corner), uint_from_real(corner));
  Color<Real> found{};
  SampleSums<Real>(sampler).add(hash, 0, 1, path_of(corner, corner), found);
  const auto is_near = [](const Real& channel, double known) {
    return std::abs(static_cast<double>(all_lanes(channel)[0]) - known) <= 1e-5 * (1 + known);
  };
  return is_near(found.r, light.r) && is_near(found.g, light.g) && is_near(found.b, light.b);
}

/// What is known of a picture before a ray is traced: something for one sphere and a pinhole.
template <class Object, class Sky>
[[nodiscard]] std::optional<ViewBounds> bounds_of_view(const std::vector<Object>& objects,
                                                       const Sky& sky, const Lens& lens,
                                                       const Smoothing& smoothing, int samples) {
  if constexpr (std::is_same_v<Sky, GradientSky>) {
    if (objects.size() == 1 && !lens.blurs()) {
      return ViewBounds{sky.is_constant() ? std::optional(sky.below) : std::nullopt,
                        samples < least_samples_of_patch ? Smoothing{} : smoothing};
    }
  }
  return {};
}

/// The light of a lesson's picture. Pixels that miss a lone sphere skip it, where the lesson sees
/// the sky as it is; smooth pixels are patches, and pixels of one kind are packed together.
///
/// @param lesson   called with a prepared scene, a place and random numbers, returns the light
/// @param objects  the lesson's or a plan's
/// @param bounds   as bounds_of_view gives them
template <class Real, class Lesson, class Paint>
[[nodiscard]] Film gather(const Lesson& lesson, const std::vector<Painted<Paint>>& objects,
                          const View<>& view, const Sampler& sampler,
                          const std::optional<ViewBounds>& bounds, const RenderSettings& settings) {
  constexpr int rows_at_a_time = 4;  // lists so long fill their packs
  const auto scene = prepare_scene<Real>(view, objects, lesson.stage.sky);
  const auto sky_alone = scene.without_objects();
  static_assert(
      requires(PixelPlace<Real> at, SampleRandom<Real> random) {
        { lesson(scene, at, random) } -> std::same_as<Color<Real>>;
      },
      "a PathLesson is called with a scene, a PixelPlace<Real> and random numbers, and returns a "
      "Color<Real>: its operator() is that of chapter 07");
  GrowingFilm film(view.width, view.height, sampler, settings);

  // What gather_pixels wants: from a place to the function that follows one sample's path there.
  const auto paths_in = [&](const auto& seen) {
    return [&](const Real& column, const Real& row) {
      return [&, column, row](auto& random) {
        return lesson(seen, PixelPlace<Real>{column, row}, random);
      };
    };
  };
  const bool sky_is_known =
      bounds && bounds->light && brings<Real>(*bounds->light, sampler, paths_in(sky_alone));
  const int blocks = (view.height + rows_at_a_time - 1) / rows_at_a_time;
  const auto rows_done = [&](int done, int) {
    settings.progress(std::min(done * rows_at_a_time, view.height), view.height);
  };
  const auto draw_block = [&](int block) {
    const int first_row = block * rows_at_a_time;
    const int end_row = std::min(first_row + rows_at_a_time, view.height);
    FilmRows rows = film.rows(first_row, end_row);
    PixelLists lists;
    for (int row = first_row; row < end_row; ++row)
      add_row<Real>(lists, row, view.width, scene, bounds);
    if (sky_is_known) {
      const Rgb first = *bounds->light * static_cast<double>(film.first());
      const Rgb second = *bounds->light * static_cast<double>(film.second());
      for (const Pixel& at : lists.misses) film.set(rows, at, first, second);
      lists.misses.clear();
    }
    if constexpr (std::is_same_v<decltype(lesson.stage.sky), GradientSky>) {
      if (bounds && bounds->smooths_sky(view)) {
        gather_pixels<Real>(
            sampler, lists.misses,
            [&](const Real& column, const Real& row) {
              return SkyPatch<Real>(scene.view, scene.sky, column, row);
            },
            film, rows);
        lists.misses.clear();
      }
    }
    gather_pixels<Real>(sampler, lists.misses, paths_in(sky_alone), film, rows);
    if constexpr (HasMapping<Paint, Real>) {
      gather_pixels<Real>(
          sampler, lists.patches,
          [&](const Real& column, const Real& row) {
            return PixelPatch<Real, Paint>(scene.view, scene.objects.front().shape,
                                           scene.objects.front().paint, scene.sky, column, row);
          },
          film, rows);
    }
    gather_pixels<Real>(sampler, lists.others, paths_in(scene), film, rows);
    film.finish(rows);
  };
  for_each_row(blocks, settings.threads,
               settings.progress ? rows_done : decltype(settings.progress){}, draw_block);
  return film.take();
}

}  // namespace texmap
