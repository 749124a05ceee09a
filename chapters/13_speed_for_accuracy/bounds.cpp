// What is known of a variant before it is tried.
//
// Places. The ray through a pixel has 6 unit roundoffs u of its direction (docs/numbers.md), which
// are 6 u distance / radius at the globe, and the eye's own rounding is 1 of these; the robust form
// misjudges a ray as if it passed 3 u distance / radius elsewhere: 10 u distance / radius together.
// A ray that passes `a` radii elsewhere meets the globe a / cosine radians elsewhere, and 4.5 u are
// the normal's own.
#include "bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/compare/difference.hpp"
#include "engine/kernels/kernel_plan.hpp"
#include "engine/kernels/srgb_kernel.hpp"

namespace texmap::chapter_13 {
namespace {

/// The unit roundoff of a number, or of each lane of a pack.
double roundoff_of(NumberKind number) {
  if (number == NumberKind::float_ || number == NumberKind::float_pack)
    return static_cast<double>(unit_roundoff<float>());
  if (number == NumberKind::extended) return static_cast<double>(unit_roundoff<long double>());
  return unit_roundoff<double>();
}

/// How far the ray through a pixel may pass from where it should, at the globe, in radii.
double ray_bound(const Globe& globe, NumberKind number) {
  return 10 * roundoff_of(number) * globe.away / globe.sphere.radius;
}

/// How far a normal can be off, in half turns.
double normal_bound(const Globe& globe, NumberKind number, double cosine) {
  return (ray_bound(globe, number) / cosine + 4.5 * roundoff_of(number)) / std::numbers::pi;
}

/// How far a place on the texture can be off, in texels along u and along v.
struct PlaceBound {
  double columns = 0, rows = 0;
};

/// How far the place that is looked up can be off; near the poles a little way is much along u. 2
/// unit roundoffs of 1 are those of the look-up (texel.hpp, bilinear.hpp).
PlaceBound place_bound(const Globe& globe, const Variant& variant, const ReferenceHit& hit) {
  const UvError kernel = kernel_bound(variant.number, variant.degree);
  const double angle = normal_bound(globe, variant.number, hit.cosine);
  const double round = std::max(hit.round - angle, 1e-9);
  const double look_up = 2 * roundoff_of(variant.number);
  return {(kernel.u + angle / 2 / round + look_up) * globe.nearest.image.width,
          (kernel.v + angle + look_up) * globe.nearest.image.height};
}

/// The largest difference, in levels of 255, between a texel and those that a place can be on as
/// well: all that the rectangle of `off` around it touches.
int levels_between_texels(const Image& image, const Judge& x, const Judge& y,
                          const PlaceBound& off) {
  const auto index = [](const Judge& at) { return static_cast<int>(floor(at)); };
  const int left = index(x - Judge(off.columns));
  const int right = index(x + Judge(off.columns));
  const int low = std::max(index(y - Judge(off.rows)), 0);
  const int high = std::min(index(y + Judge(off.rows)), image.height - 1);
  if (left == right && low == high) return 0;

  const auto texel = [&image](int column, int row) {  // u wraps, v ends; v = 0 is the lowest row
    return image.at((column + image.width) % image.width, image.height - 1 - row);
  };
  const Rgb8 right_one = texel(index(x), std::min(index(y), image.height - 1));
  int levels = 0;
  for (int row = low; row <= high; ++row) {
    for (int column = left; column <= right; ++column)
      levels = std::max(levels, channel_difference(texel(column, row), right_one));
  }
  return levels;
}

/// The largest difference, in levels of 255 after rounding to bytes, between a filtered color and
/// those of the places around.
///
/// Between the lines of the texels' centers the color is bilinear: it has its least and its largest
/// value where these lines and the sides of the rectangle of `off` cross.
/// @param room  levels that the mixing may be off by
int levels_between_places(const BilinearTexture& texture, double x, double y, const PlaceBound& off,
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

}  // namespace

UvError kernel_bound(NumberKind number, int degree) {
  const double roundoff = roundoff_of(number);
  return with_uv_mapping(degree, [&](const auto& mapping) -> UvError {
    using Mapping = std::decay_t<decltype(mapping)>;
    if constexpr (requires { Mapping::template worst<double>; }) {
      if (roundoff == roundoff_of(NumberKind::float_)) return Mapping::template worst<float>;
      return Mapping::template worst<double>;
    } else {
      const double texels = roundoff == roundoff_of(NumberKind::float_)    ? 0.001
                            : roundoff == roundoff_of(NumberKind::double_) ? 2e-12
                                                                           : 1e-15;
      return {texels / 8192, texels / 4096};  // stated in texels of 8192 by 4096
    }
  });
}

double texels_bound(const Globe& globe, NumberKind number, int degree) {
  const UvError kernel = kernel_bound(number, degree);
  const double angle = normal_bound(globe, number, least_cosine);
  return std::max((kernel.u + angle / 2) * globe.nearest.image.width,
                  (kernel.v + angle) * globe.nearest.image.height);
}

int levels_bound(const Globe& globe, const Variant& variant, const ReferenceHit& hit) {
  if (hit.from_rim <= ray_bound(globe, variant.number)) return 255;
  if (!hit.met) return 0;
  const Image& image = globe.nearest.image;
  const PlaceBound off = place_bound(globe, variant, hit);
  if (off.columns >= image.width || off.rows >= image.height) return 255;
  const Judge x = hit.uv.u * Judge(image.width);
  const Judge y = hit.uv.v * Judge(image.height);
  if (variant.filter == Filter::nearest) return levels_between_texels(image, x, y, off);
  const double mixing = 255 * 8 * roundoff_of(variant.number);  // 8 unit roundoffs are allowed for
  return levels_between_places(globe.bilinear, static_cast<double>(x), static_cast<double>(y), off,
                               mixing);
}

double unrounded_bound(const Variant& variant, int rays) {
  if (variant.curve == Curve::exact && variant.format == TexelFormat::bytes) return 0;
  const double polynomial = variant.curve == Curve::three  ? fits::SrgbCurve<3>::worst
                            : variant.curve == Curve::four ? fits::SrgbCurve<4>::worst
                                                           : 0;
  const double roots = variant.format == TexelFormat::roots ? RootTexture::worst_levels : 0;
  // Light has 10 unit roundoffs of table, root, square and sky, and each of its own is at most 112
  // levels (255 * 1.055 / 2.4); the curve has 6 of 255 levels, in the variant and in the reference:
  // 5000 are enough. Both sums of a mean have 250 for each ray but the first, and both films round
  // light to 2^-32 of itself.
  const double film = rays > 1 ? 2 * 112 * 0x1p-32 : 0;
  return polynomial + roots + film + (5000 + 250.0 * (rays - 1)) * roundoff_of(variant.number);
}

int rounded_bound(double unrounded) { return static_cast<int>(std::ceil(unrounded)); }

}  // namespace texmap::chapter_13
