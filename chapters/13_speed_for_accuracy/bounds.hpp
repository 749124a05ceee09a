// What is stated of a way to draw before it is tried: how far off a place can be, and what a pixel can then show.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shots.hpp"

namespace texmap::chapter_13 {

/// How far a place on the texture can be off, in texels along u and along v.
struct PlaceBound {
  double columns = 0, rows = 0;
};

/// The worst error of the (u, v) kernel of a degree in numbers of type T: stated by the kernels themselves, and for the
/// reference formula in docs/numbers.md.
template <class T>
[[nodiscard]] UvError kernel_bound(int degree) {
  return with_uv_mapping<Directions::unit>(mapping_of_degree(degree).choice, [](const auto& mapping) -> UvError {
    using Mapping = std::decay_t<decltype(mapping)>;
    if constexpr (requires { Mapping::template worst<T>; }) {
      return Mapping::template worst<T>;
    } else {
      const double texels = sizeof(T) == sizeof(float) ? 0.001 : sizeof(T) == sizeof(double) ? 2e-12 : 1e-15;
      return {texels / 8192, texels / 4096};  // stated in texels of 8192 by 4096
    }
  });
}

/// How far the ray through a pixel may pass from where it should, at the globe, in radii.
///
/// 6 unit roundoffs of the ray's direction (docs/numbers.md) are 6 u distance / radius at the globe, the eye's own rounding 1
/// of these, and the robust form misjudges a ray as if it passed 3 u distance / radius elsewhere: 10 u distance / radius
/// together.
template <class T>
[[nodiscard]] double ray_bound(const Globe& globe) {
  return 10 * static_cast<double>(unit_roundoff<T>()) * globe.away / globe.sphere.radius;
}

/// How far a normal can be off, in radians.
///
/// @param cosine  of the angle between the normal and the ray, above 0. A ray that passes `a` radii elsewhere meets the globe
///                a / cosine radians elsewhere. 4 unit roundoffs are the normal's own
template <class T>
[[nodiscard]] double normal_bound(const Globe& globe, double cosine) {
  return ray_bound<T>(globe) / cosine + 4 * static_cast<double>(unit_roundoff<T>());
}

/// The least cosine that the figures of places are about: rays that pass the center within 0.99 radii, as in docs/numbers.md.
/// Nearer to the rim a rounding of the ray may go a long way on the globe.
inline constexpr double least_cosine = 0.141;

/// How far a place can be off at most, in texels, for all hits that are not nearer to the rim than `least_cosine`, whatever the
/// camera's angle: the larger of the errors along u, round the circle of its v, and along v.
///
/// Formula: kernel_bound times the texture's size, and normal_bound times the texels of a radian.
template <class T>
[[nodiscard]] double texels_bound(const Globe& globe, int degree) {
  const UvError kernel = kernel_bound<T>(degree);
  const double angle = normal_bound<T>(globe, least_cosine) / std::numbers::pi;
  return std::max((kernel.u + angle / 2) * globe.nearest.image.width, (kernel.v + angle) * globe.nearest.image.height);
}

/// What is known of a pixel's ray without looking at a picture, to more digits than any trial has.
struct Sight {
  bool met = false;
  double cosine = 0;    ///< of the angle between normal and ray
  double from_rim = 0;  ///< how far from touching the globe the ray passes, in radii
  double round = 0;     ///< length of the circle of this v, compared with the equator's
  long double u = 0, v = 0;
};

/// How far the place that is looked up can be off for a sight; near the poles a little way is much along u. 2 unit roundoffs of
/// 1 are those of the look-up (texel.hpp, bilinear.hpp).
template <class T>
[[nodiscard]] PlaceBound place_bound(const Globe& globe, int degree, const Sight& sight) {
  const UvError kernel = kernel_bound<T>(degree);
  const double angle = normal_bound<T>(globe, sight.cosine) / std::numbers::pi;
  const double round = std::max(sight.round - angle, 1e-9);
  const double look_up = 2 * static_cast<double>(unit_roundoff<T>());
  return {(kernel.u + angle / 2 / round + look_up) * globe.nearest.image.width,
          (kernel.v + angle + look_up) * globe.nearest.image.height};
}

/// The largest difference, in levels of 255, between a texel and those that a place can be on as well.
///
/// The formula: the place is somewhere in the rectangle of `off` about where it should be, and the pixel may show any texel
/// that the rectangle touches; it cannot change if the place is farther than `off` from every edge of its texel.
[[nodiscard]] inline int levels_between_texels(const Image& image, long double x, long double y, const PlaceBound& off) {
  const auto index = [](long double at) { return static_cast<int>(std::floor(at)); };
  const int left = index(x - static_cast<long double>(off.columns));
  const int right = index(x + static_cast<long double>(off.columns));
  const int low = std::max(index(y - static_cast<long double>(off.rows)), 0);
  const int high = std::min(index(y + static_cast<long double>(off.rows)), image.height - 1);
  if (left == right && low == high) return 0;

  const auto texel = [&image](int column, int row) {  // u goes round, v ends; row 0 is at v = 0, the picture's lowest
    return image.at((column + image.width) % image.width, image.height - 1 - row);
  };
  const Rgb8 right_one = texel(index(x), std::min(index(y), image.height - 1));
  int levels = 0;
  for (int row = low; row <= high; ++row) {
    for (int column = left; column <= right; ++column) {
      const Rgb8 other = texel(column, row);
      levels = std::max({levels, abs(other.r - right_one.r), abs(other.g - right_one.g), abs(other.b - right_one.b)});
    }
  }
  return levels;
}

/// The largest difference, in levels of 255 after rounding to bytes, between a filtered color and those of the places around.
///
/// Between the lines of the texels' centers the color is bilinear, and so it takes its least and its largest value in the
/// rectangle of `off` where such lines, or the rectangle's sides, cross.
/// @param room  levels that the mixing may be off by
[[nodiscard]] inline int levels_between_places(const BilinearTexture& texture, double x, double y, const PlaceBound& off,
                                               double room) {
  const auto lines = [](double at, double reach) {
    std::vector<double> all = {at - reach};
    const auto first = static_cast<int>(std::floor(at - reach - 0.5)) + 1;
    for (int k = first; k + 0.5 < at + reach; ++k) all.push_back(k + 0.5);
    all.push_back(at + reach);
    return all;
  };
  const auto channels_at = [&](double column, double row) {
    const Rgb color = texture(Uv<double>{column / texture.image.width, row / texture.image.height});
    return std::array{color.r * 255, color.g * 255, color.b * 255};
  };
  const auto right = channels_at(x, y);
  const auto rows = lines(y, off.rows);
  int levels = 0;
  for (const double column : lines(x, off.columns)) {
    for (const double row : rows) {
      const auto other = channels_at(column, row);
      for (std::size_t k = 0; k < 3; ++k) {
        const double byte = std::floor(right[k] + 0.5);
        levels = std::max({levels, static_cast<int>(byte - std::floor(other[k] - room + 0.5)),
                           static_cast<int>(std::floor(other[k] + room + 0.5) - byte)});
      }
    }
  }
  return levels;
}

/// How many levels of 255 a pixel can be off: 0 if no rounding can change its bytes.
///
/// @param unit  the unit roundoff of the number that mixes the texels, whose 8 are allowed for
[[nodiscard]] inline int levels_bound(const Globe& globe, Filter filter, const Sight& sight, const PlaceBound& off,
                                      double unit) {
  const Image& image = globe.nearest.image;
  if (off.columns >= image.width || off.rows >= image.height) return 255;
  const long double x = sight.u * static_cast<long double>(image.width);
  const long double y = sight.v * static_cast<long double>(image.height);
  if (filter == Filter::nearest) return levels_between_texels(image, x, y, off);
  return levels_between_places(globe.bilinear, static_cast<double>(x), static_cast<double>(y), off, 255 * 8 * unit);
}

/// By how many levels of 255 a channel can be off before it is rounded to a byte, against the exact curve of the texel's bytes
/// in the same number: what the curve and the kept texels state, and 5000 unit roundoffs. 0 for the exact curve and bytes.
///
/// The formula: light has 10 unit roundoffs of table, root, square and sky, and each of its own is at most 112 levels
/// (255 * 1.055 / 2.4); the curve has 6 of 255 levels, in what is judged and in the judge.
/// @param rays  that a channel is the mean of, 1 or more; both sums of them have 250 unit roundoffs for each but the first
template <class T>
[[nodiscard]] double unrounded_bound(Curve curve, Texels texels, int rays = 1) {
  if (curve == Curve::exact && texels == Texels::bytes) return 0;
  const double polynomial = curve == Curve::three  ? fits::SrgbCurve<3>::worst
                            : curve == Curve::four ? fits::SrgbCurve<4>::worst
                                                   : 0;
  const double kept = texels == Texels::roots ? RootTexture::worst_levels : 0;
  return polynomial + kept + (5000 + 250.0 * (rays - 1)) * static_cast<double>(unit_roundoff<T>());
}

/// By how many levels bytes can differ whose channels differ by as much before they are rounded.
[[nodiscard]] inline int rounded_bound(double unrounded) { return static_cast<int>(std::ceil(unrounded)); }

}  // namespace texmap::chapter_13
