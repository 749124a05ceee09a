// What the filters cost and how far off they are, on checkers to the horizon.
#include "comparison.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <type_traits>

#include "engine/compare/interleaved.hpp"
#include "engine/compare/plot.hpp"
#include "engine/draw/threads.hpp"
#include "engine/files/text.hpp"
#include "engine/run/filter_options.hpp"
#include "ideal.hpp"

namespace texmap::chapter_09 {
namespace {

/// A pyramid that counts its reads.
struct CountedPyramid : Pyramid {
  long* count = nullptr;
};
template <class Real>
Color<Real> texel_light(const CountedPyramid& pyramid, const PyramidLevel<Real>& level,
                        const Real& column, const Real& row) {
  ++*pyramid.count;
  return texel_light(static_cast<const Pyramid&>(pyramid), level, column, row);
}

/// A pixel of the floor: its (u, v), and the mean light of its checkers.
struct FloorPixel {
  Uv<Dual<double>> uv;
  double light = 0;
};

// Of a pixel: a Fibonacci lattice, in which no two places share a column or a row. It is nearer to
// the mean of 160,000 places than a grid of 64 x 64 is.
constexpr int places = 1597, places_step = 987;
constexpr int squares = 32;         // of a copy of the picture
constexpr int timed_step = 5;       // every fifth pixel is timed: all over the floor
constexpr double whole = 0x1.8p52;  // from here on doubles are whole numbers

/// The pixels that show nothing but floor.
std::vector<FloorPixel> floor_pixels(const FloorView& scene, int threads) {
  constexpr int width = comparison_width, height = comparison_height;
  const View<> view = view_of(scene.camera, width, height);
  const auto uv_at = [&](const auto& column, const auto& row) {
    using Real = std::decay_t<decltype(column)>;
    const Ray<Real> ray{number_cast<Real>(view.eye), direction_through(view, column, row)};
    return scene.mapping(point_on(scene.floor, ray, distance_to(scene.floor, ray)));
  };
  std::array<double, places> across, down;
  for (std::size_t i = 0; i < places; ++i) {
    across[i] = (double(i) + 0.5) / places - 0.5;
    down[i] = (double(i * places_step % places) + 0.5) / places - 0.5;
  }
  std::vector<std::vector<FloorPixel>> rows(height);
  for_each_row(height, threads, {}, [&](int row) {
    const Ray<double> upper_edge = ray_through(view, 0.0, row - 0.5);
    if (!(upper_edge.direction.y < 0)) return;
    for (int column = 0; column < width; ++column) {
      FloorPixel pixel;
      pixel.uv = uv_at(Dual<double>{double(column), 1.0, 0.0}, Dual<double>{double(row), 0.0, 1.0});
      std::uint64_t light_places = 0;
      for (std::size_t i = 0; i < places; ++i) {
        const Uv<double> uv = uv_at(column + across[i], row + down[i]);
        // Adding `whole` rounds to whole numbers, and their last bit is the last of the sum: faster
        // than rounding down.
        const auto column_bits = std::bit_cast<std::uint64_t>(uv.u * squares - 0.5 + whole);
        const auto row_bits = std::bit_cast<std::uint64_t>(-uv.v * squares - 0.5 + whole);
        light_places += ~(column_bits ^ row_bits) & 1;
      }
      pixel.light = static_cast<double>(light_places) / places;
      rows[static_cast<std::size_t>(row)].push_back(pixel);
    }
  });
  std::vector<FloorPixel> pixels;
  for (const auto& row : rows) pixels.insert(pixels.end(), row.begin(), row.end());
  return pixels;
}

/// What a filter's own ideal is in each pixel.
std::vector<double> ideal_lights(const FilteredTexture& texture,
                                 const std::vector<FloorPixel>& pixels, int threads) {
  constexpr std::size_t block = 256;
  std::vector<double> ideals(pixels.size());
  for_each_row(static_cast<int>((pixels.size() + block - 1) / block), threads, {}, [&](int number) {
    const std::size_t first = static_cast<std::size_t>(number) * block;
    for (std::size_t i = first; i < std::min(first + block, pixels.size()); ++i)
      ideals[i] = ideal_light(texture, squares, pixels[i].uv);
  });
  return ideals;
}

template <class Texture>
void read_as(Texture& texture, const FilterFigures& figures) {
  texture.filter = figures.filter;
  texture.taps = figures.taps;
}

}  // namespace

std::vector<FilterFigures> compare_filters(const FloorView& scene, int threads, bool timed) {
  const std::vector<FloorPixel> pixels = floor_pixels(scene, threads);
  if (pixels.empty()) return {};
  std::vector<FilterFigures> all = {
      {Filter::nearest, 1, "nearest"},           {Filter::bilinear, 1, "bilinear"},
      {Filter::trilinear, 1, "trilinear"},       {Filter::anisotropic, 2, "anisotropic 2"},
      {Filter::anisotropic, 4, "anisotropic 4"}, {Filter::anisotropic, 8, "anisotropic 8"},
      {Filter::anisotropic, 16, "anisotropic"},  {Filter::ewa, 16, "ewa"},
      {Filter::stochastic, 16, "stochastic"}};
  long reads = 0;
  FilteredTexture texture;
  texture.pyramid = pyramid_of({checkers_image(1024, squares), TexelLight::linear});
  Filtered<CountedPyramid> counted;
  counted.pyramid = {texture.pyramid, &reads};
  const auto count = static_cast<double>(pixels.size());
  std::vector<Work> works;
  for (FilterFigures& figures : all) {
    reads = 0;
    read_as(counted, figures);
    read_as(texture, figures);
    const std::vector<double> ideals = ideal_lights(texture, pixels, threads);
    double sum = 0, own_sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const double light = counted.filtered(pixels[i].uv).r;
      sum += square(light - pixels[i].light);
      own_sum += square(light - ideals[i]);
    }
    figures.error = std::sqrt(sum / count);
    figures.own_error = std::sqrt(own_sum / count);
    figures.reads = static_cast<double>(reads) / count;
    works.emplace_back([&pixels, &texture, &figures] {
      double light = 0;
      read_as(texture, figures);
      for (std::size_t i = 0; i < pixels.size(); i += timed_step)
        light += texture.filtered(pixels[i].uv).r;
      if (!(light > 0)) throw std::logic_error("the floor is black");
    });
  }
  if (!timed) return all;
  const std::vector<WorkTime> times = work_times(works, 3);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].nanoseconds = times[i].processor * 1e6 * timed_step / count;
  return all;
}

std::string table_of_filters(const std::vector<FilterFigures>& figures) {
  std::string table =
      "filter         error   nearest's / error   from own ideal   texels read   "
      "ns a look-up (double)\n";
  for (const FilterFigures& one : figures) {
    table += text("%-15s%.4f  %17.1f   %14.4f   %11.1f   %7.0f\n", one.name.c_str(), one.error,
                  figures.front().error / one.error, one.own_error, one.reads, one.nanoseconds);
  }
  return table + "\n";
}

Plot plot_of_filters(const std::vector<FilterFigures>& figures) {
  Plot plot{.title = "Checkers to the horizon: error against texels read",
            .x_title = "texels read a pixel, one ray",
            .y_title = "root mean square error of light"};
  for (const FilterFigures& one : figures) {
    const int style = static_cast<int>(one.filter);
    if (plot.series.empty() || plot.series.back().style != style)
      plot.series.push_back({.name = "", .style = style, .points = {}, .joined = true});
    plot.series.back().points.push_back({one.reads, one.error, one.name});
  }
  return plot;
}

}  // namespace texmap::chapter_09
