// An image in many sizes, each half of the one before: a MIP pyramid.
#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "number/table.hpp"
#include "texture/light_image.hpp"
#include "texture/wrap.hpp"

namespace texmap {

/// One level of a pyramid as every lane of a number sees it, in texels; all whole numbers.
template <class Real>
struct PyramidLevel {
  Real width, height;
  Real first_row;  ///< among the rows of all levels
};

/// The images of a pyramid, from the original (level 0) to a single texel: its mean light.
/// Copies share the texels. Source: Williams, "Pyramidal Parametrics" (1983).
struct Pyramid {
  static constexpr int later_bytes = 4;  ///< a texel of the original: what all other levels take

  std::vector<PyramidLevel<int>> levels;
  std::vector<std::size_t> row_starts;    ///< of all rows of all levels, the first texel
  SharedLight original = {};              ///< level 0
  SharedGrid<Color<float>> smaller = {};  ///< the texels of all other levels, one after another

  /// The number of the last level; -1 for a pyramid of nothing.
  [[nodiscard]] int last_level() const { return static_cast<int>(levels.size()) - 1; }
  /// Adds a level whose first texel has this number.
  void add(int width, int height, std::size_t first) {
    levels.push_back({width, height, static_cast<int>(row_starts.size())});
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row)
      row_starts.push_back(first + row * static_cast<std::size_t>(width));
  }
  /// The light of a texel.
  ///
  /// @param row  among the rows of all levels
  [[nodiscard]] Color<float> at(int column, int row) const {
    const std::size_t texel =
        row_starts[static_cast<std::size_t>(row)] + static_cast<std::size_t>(column);
    return row < original.height ? original[texel] : smaller.pixels[texel];
  }
};

/// A part of an old texel that a texel of half the size covers.
struct Covered {
  std::size_t to;  ///< the new texel
  int from;        ///< the old one
  double part;     ///< in units of 1 / (number of new texels)
};

/// What the texels of a row of half as many (rounded down, at least one) cover: two old texels
/// each, or parts of three. In the order of both.
[[nodiscard]] inline std::vector<Covered> covered_by_half(int count) {
  const int half = std::max(count / 2, 1);
  std::vector<Covered> all;
  for (int i = 0; i < half; ++i) {
    // In units of 1/half of an old texel, the new one covers i count to (i + 1) count.
    const long low = static_cast<long>(i) * count;
    const long high = low + count;
    for (long j = low / half; j * half < high; ++j) {
      all.push_back(
          {static_cast<std::size_t>(i), static_cast<int>(j),
           static_cast<double>(std::min(high, (j + 1) * half) - std::max(low, j * half))});
    }
  }
  return all;
}

/// Adds to `to` an image in half the size, rounded down and at least 1 each way; its mean light is
/// the same. It holds no more than a row of the image. Bound: 2 roundings of float.
///
/// @param light_of  the light of a texel, by its number row by row
template <class LightOf>
void append_half(std::vector<Color<float>>& to, int width, int height, const LightOf& light_of) {
  const std::vector<Covered> columns = covered_by_half(width);
  std::vector<Rgb> narrow(static_cast<std::size_t>(std::max(width / 2, 1)));  // one row
  std::vector<Rgb> sums(narrow.size());
  const double column_share = 1.0 / width, row_share = 1.0 / height;
  int in_narrow = -1;
  std::size_t in_sums = 0;
  const auto finish = [&] {
    for (Rgb& sum : sums) to.push_back(number_cast<float>(std::exchange(sum, {}) * row_share));
  };
  for (const auto& [row, from, part] : covered_by_half(height)) {
    if (row != in_sums) finish();
    in_sums = row;
    if (from != std::exchange(in_narrow, from)) {
      std::fill(narrow.begin(), narrow.end(), Rgb{});
      const std::size_t start = static_cast<std::size_t>(from) * static_cast<std::size_t>(width);
      for (const auto& [column, old, share] : columns) {
        narrow[column] =
            narrow[column] +
            number_cast<double>(light_of(start + static_cast<std::size_t>(old))) * share;
      }
      for (Rgb& sum : narrow) sum = number_cast<double>(number_cast<float>(sum * column_share));
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = sums[i] + narrow[i] * part;
  }
  finish();
}

/// The pyramid of an image of any size; of an empty image, nothing.
[[nodiscard]] inline Pyramid pyramid_of(SharedLight image) {
  Pyramid pyramid;
  if (image.empty()) return pyramid;
  std::size_t size = 0;  // of all levels but the first
  int width = image.width, height = image.height;
  pyramid.add(width, height, 0);
  while (width > 1 || height > 1) {
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
    pyramid.add(width, height, size);
    size += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  LightImage smaller;
  smaller.width = static_cast<int>(size);
  smaller.height = 1;
  std::vector<Color<float>>& to = smaller.pixels;
  to.reserve(size);  // so that it does not move while it is read
  for (int level = 0; level < pyramid.last_level(); ++level) {
    const PyramidLevel<int>& from = pyramid.levels[static_cast<std::size_t>(level)];
    const Color<float>* const first =
        to.data() + pyramid.row_starts[static_cast<std::size_t>(from.first_row)];
    if (level == 0) {
      append_half(to, from.width, from.height, [&](std::size_t i) { return image[i]; });
    } else {
      append_half(to, from.width, from.height, [first](std::size_t i) { return first[i]; });
    }
  }
  pyramid.original = std::move(image);
  pyramid.smaller = std::move(smaller);
  return pyramid;
}

/// The level with this number, another one in each lane.
///
/// @param number  a whole number from 0 to last_level()
template <class Real>
[[nodiscard]] PyramidLevel<Real> level_of(const Pyramid& pyramid, const Real& number) {
  const auto level = look_up(
      [&](int index, int) {
        const PyramidLevel<int>& one = pyramid.levels[static_cast<std::size_t>(index)];
        return std::array{static_cast<float>(one.width), static_cast<float>(one.height),
                          static_cast<float>(one.first_row)};
      },
      number, Real(0));
  return {level[0], level[1], level[2]};
}

/// A texel of a level, inside its image.
template <class Real>
[[nodiscard]] Color<Real> texel_light(const Pyramid& pyramid, const PyramidLevel<Real>& level,
                                      const Real& column, const Real& row) {
  return light_at(pyramid, column, level.first_row + row);
}

/// The light of four texels of a level, in two columns and two rows inside its image, mixed.
///
/// @param across, down  how far from the first column to the second and from the first row, 0 to 1
template <class Texels, class Real>
[[nodiscard]] Color<Real> mixed_light(const Texels& pyramid, const PyramidLevel<Real>& level,
                                      const Neighbors<Real>& columns, const Neighbors<Real>& rows,
                                      const Real& across, const Real& down) {
  const auto row_of = [&](const Real& row) {
    return mix(texel_light(pyramid, level, columns.first, row),
               texel_light(pyramid, level, columns.second, row), across);
  };
  const Color<Real> upper = row_of(rows.first);
  return mix(upper, row_of(rows.second), down);
}

}  // namespace texmap
