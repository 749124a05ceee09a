// A picture of gathered light that gets better in passes: 1, 2, 4, … samples a pixel, then all.
#pragma once
#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "engine/draw/develop.hpp"
#include "engine/draw/gather.hpp"
#include "engine/run/session.hpp"

namespace texmap::live {

/// The sums of a picture's samples, in the order in which the program adds them.
template <class Lesson>
class Gathered {
 public:
  /// The lesson must live as long.
  Gathered(const Lesson& lesson, const View<>& view, const Settings& settings)
      : lesson_(lesson),
        scene_(prepare_scene<double>(view, lesson.objects, lesson.stage.sky)),
        sampler_(lesson.sampling.sampler, settings.samples,
                 static_cast<std::uint32_t>(lesson.sampling.seed)),
        width_(view.width),
        rows_(static_cast<std::size_t>(view.height)) {}

  [[nodiscard]] int passes() const {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(sampler_.samples() - 1))) + 1;
  }
  [[nodiscard]] const Sampler& sampler() const { return sampler_; }

  /// Rows after a pass, 0 and on; the last pass gives the program's bytes.
  [[nodiscard]] Image rows(int first, int count, int pass) {
    const int wanted = std::min(1 << pass, sampler_.samples());
    Film strip(width_, count, wanted);
    for (int row = first; row < first + count; ++row) {
      Row& sums = rows_[static_cast<std::size_t>(row)];
      sums.pixels.resize(static_cast<std::size_t>(width_));
      for (int column = 0; column < width_; ++column) {
        auto& [lower, upper] = sums.pixels[static_cast<std::size_t>(column)];
        const int half = sampler_.samples() / 2;
        if (sums.done < wanted) {
          add(column, row, std::min(sums.done, half), std::min(wanted, half), lower);
          add(column, row, std::max(sums.done, half), std::max(wanted, half), upper);
        }
        strip.set_light(column, row - first, (lower + upper) * (1.0 / std::max(sums.done, wanted)));
      }
      sums.done = std::max(sums.done, wanted);
    }
    return develop(strip, lesson_.sampling.transfer, 1);
  }

  /// Calls `use` with the light of each sample of a pixel, and the sampler's pair of numbers for
  /// its place in the pixel.
  template <class Use>
  void for_each_sample(int column, int row, const Use& use) const {
    const auto pixel =
        hash_pixels<double>(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
    for (int i = 0; i < sampler_.samples(); ++i) {
      Rgb light{};
      add(column, row, i, i + 1, light);
      use(sampler_.template pair<double>(pixel, static_cast<std::uint32_t>(i), 0), light);
    }
  }

 private:
  void add(int column, int row, int first, int end, Rgb& sum) const {
    if (first >= end) return;
    const auto path = [&](auto& random) {
      return lesson_(scene_, PixelPlace<double>{double(column), double(row)}, random);
    };
    SampleSums<double>(sampler_).add(
        hash_pixels<double>(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)),
        first, end, path, sum);
  }

  struct Row {
    int done = 0;                             ///< samples a pixel
    std::vector<std::pair<Rgb, Rgb>> pixels;  ///< sums of the first half, of the second
  };
  const Lesson& lesson_;
  decltype(prepare_scene<double>(std::declval<const View<>&>(),
                                 std::declval<const Lesson&>().objects,
                                 std::declval<const Lesson&>().stage.sky)) scene_;
  Sampler sampler_;
  int width_;
  std::vector<Row> rows_;
};

}  // namespace texmap::live
