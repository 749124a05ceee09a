// An image in many sizes, each half of the one before: a MIP pyramid.
#pragma once
#include <algorithm>
#include <cstddef>
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
/// Memory: 4/3 of the original's for a square.
/// Source: Williams, "Pyramidal Parametrics" (1983).
struct Pyramid {
  std::vector<PyramidLevel<int>> levels;
  std::vector<std::size_t> row_starts;  ///< of all rows of all levels, the first texel
  std::vector<Color<float>> texels;     ///< of all levels, the original first

  /// The number of the last level; -1 for a pyramid of nothing.
  [[nodiscard]] int last_level() const { return static_cast<int>(levels.size()) - 1; }

  /// Adds a level.
  void add(const LightImage& image) {
    const int first_row = static_cast<int>(row_starts.size());
    levels.push_back({image.width, image.height, first_row});
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row)
      row_starts.push_back(texels.size() + row * static_cast<std::size_t>(image.width));
    texels.insert(texels.end(), image.pixels.begin(), image.pixels.end());
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

/// An image in half the size, rounded down and at least 1 each way; its mean light is the same.
/// Bound: 2 roundings of float.
[[nodiscard]] inline LightImage halved(const LightImage& image) {
  LightImage narrow(std::max(image.width / 2, 1), image.height);
  LightImage result(narrow.width, std::max(image.height / 2, 1));
  const auto width = static_cast<std::size_t>(narrow.width);
  std::vector<Rgb> sums(result.pixels.size());
  const auto rounded = [&sums](std::size_t i, double share) {
    const Rgb mean = sums[i] * share;
    sums[i] = {};
    return Color<float>{static_cast<float>(mean.r), static_cast<float>(mean.g),
                        static_cast<float>(mean.b)};
  };
  const std::vector<Covered> columns = covered_by_half(image.width);
  for (int row = 0; row < image.height; ++row) {
    for (const auto& [to, from, part] : columns)
      sums[to] = sums[to] + number_cast<double>(image.at(from, row)) * part;
    for (std::size_t i = 0; i < width; ++i)
      narrow.at(static_cast<int>(i), row) = rounded(i, 1.0 / image.width);
  }
  for (const auto& [to, from, part] : covered_by_half(image.height)) {
    for (std::size_t i = 0; i < width; ++i) {
      Rgb& sum = sums[to * width + i];
      sum = sum + number_cast<double>(narrow.at(static_cast<int>(i), from)) * part;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) result.pixels[i] = rounded(i, 1.0 / image.height);
  return result;
}

/// The pyramid of an image of any size; of an empty image, nothing.
[[nodiscard]] inline Pyramid pyramid_of(LightImage image) {
  Pyramid pyramid;
  if (image.pixels.empty()) return pyramid;
  pyramid.texels.reserve(image.pixels.size() * 4 / 3 + 2 * static_cast<std::size_t>(image.width));
  pyramid.add(image);
  while (image.width > 1 || image.height > 1) {
    image = halved(image);
    pyramid.add(image);
  }
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
  const auto channels = look_up(
      [&](int at_column, int at_row) {
        const std::size_t start = pyramid.row_starts[static_cast<std::size_t>(at_row)];
        const Color<float>& texel = pyramid.texels[start + static_cast<std::size_t>(at_column)];
        return std::array{texel.r, texel.g, texel.b};
      },
      column, level.first_row + row);
  return {channels[0], channels[1], channels[2]};
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
