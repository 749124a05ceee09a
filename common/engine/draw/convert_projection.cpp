// From a picture of the sphere in one layout to the same picture in another.
#include "engine/draw/convert_projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/draw/threads.hpp"
#include "engine/fast/srgb_kernel.hpp"
#include "engine/fast/turns.hpp"
#include "texture/bilinear_mix.hpp"
#include "texture/wrap.hpp"

namespace texmap {
namespace {

/// The center of a texel.
Uv<double> center_of(const Texel& texel, int width, int height) {
  return {(texel.column + 0.5) / width, 1 - (texel.row + 0.5) / height};
}

/// The texel that holds (u, v).
Texel texel_of(const Uv<double>& uv, int width, int height) {
  return {texel_number(uv.u, width, TexelRounding::floor),
          height - 1 - texel_number(uv.v, height, TexelRounding::floor)};
}

/// The texel beyond an edge of a band of a cube. Two faces mirror each other at the plane through
/// their common edge, which exchanges two coordinates.
Texel beyond_band(CubeSpacing spacing, const Texel& home, int column, int row, int width,
                  int height) {
  const int middle = (height + 1) / 2;
  const bool lower = home.row >= middle;
  const int first = lower ? middle : 0;
  const int last = lower ? height - 1 : middle - 1;
  const Texel edge{std::clamp(column, 0, width - 1), std::clamp(row, first, last)};
  if (edge.column == column && edge.row == row) return edge;
  const Vec3<double> p = direction_cube(spacing, center_of(edge, width, height));
  Vec3<double> q = lower ? other_band(p) : p;
  if (edge.row != row) {  // above or below a face
    const double up = row < edge.row ? 1 : -1;
    double& depth = q.z > std::abs(q.x) ? q.z : q.x;
    const double sign = depth < 0 ? -up : up;
    const double height_on_face = q.y;
    q.y = sign * depth;
    depth = sign * height_on_face;
  } else {  // to the left of the first face or to the right of the last
    const double sign = q.x < 0 ? -1 : 1;
    const double outward = q.x;
    q.x = -sign * q.z;
    q.z = -sign * outward;
  }
  return texel_of(uv_cube(spacing, lower ? other_band(q) : q), width, height);
}

constexpr std::size_t most_places = 8;  // of a texel in each direction

/// How many places a texel needs in each direction, from the footprint on the other picture.
int places_for(const SharedLight& image, Projection from, Projection to, const Uv<double>& uv,
               const PictureSize& size) {
  const Uv<Dual<double>> steps{{uv.u, 1.0 / size.width, 0.0}, {uv.v, 0.0, 1.0 / size.height}};
  const Uv<Dual<double>> there = project(from, unproject(to, steps));
  const auto length_of = [&](double u, double v) {
    return std::sqrt(square(u * image.width) + square(v * image.height));
  };
  const double across = length_of(there.u.dx, there.v.dx);
  const double down = length_of(there.u.dy, there.v.dy);
  // At a pole the derivatives may be infinite or NaN.
  const double longest = clamp(max(across, down), 1.0, double{most_places});
  return static_cast<int>(std::ceil(longest - 0.01));
}

std::uint8_t encoded(double light) { return static_cast<std::uint8_t>(srgb_byte_exact(light)); }

}  // namespace

PictureSize converted_size(const Image& image, Projection from, Projection to) {
  const double texels = static_cast<double>(image.width) * image.height;
  // Texels for the sphere / texels of the picture are 4 pi / mean_texel.
  const double wanted = texels * facts_of(to).mean_texel / facts_of(from).mean_texel;
  const double height = std::sqrt(wanted / facts_of(to).aspect);
  if (facts_of(to).aspect == 1.5) {
    const int side = std::max(1, static_cast<int>(std::lround(height / 2)));
    return {3 * side, 2 * side};
  }
  const int rows = std::max(1, static_cast<int>(std::lround(height)));
  return {std::max(1, static_cast<int>(std::lround(rows * facts_of(to).aspect))), rows};
}

Texel texel_beside(Projection projection, const Texel& home, int column, int row, int width,
                   int height) {
  const bool inside = column >= 0 && column < width && row >= 0 && row < height;
  const bool bands = facts_of(projection).aspect == 1.5;
  const int middle = (height + 1) / 2;
  if (inside && (!bands || (row >= middle) == (home.row >= middle))) return {column, row};
  switch (projection) {
    case Projection::plane:
      return {std::clamp(column, 0, width - 1), std::clamp(row, 0, height - 1)};
    case Projection::octahedral:
    case Projection::equal_area: {
      const auto texel = folded_octahedral<double>(column, row, width, height);
      return {static_cast<int>(texel.column), static_cast<int>(texel.row)};
    }
    case Projection::cube:
      return beyond_band(CubeSpacing::even, home, column, row, width, height);
    case Projection::equi_angular:
      return beyond_band(CubeSpacing::equi_angular, home, column, row, width, height);
    case Projection::equirect:
    case Projection::cylinder:
      break;
  }
  const auto texel = wrapped_texel<double>(Wrap::spherical, column, row, width, height);
  return {static_cast<int>(texel.column), static_cast<int>(texel.row)};
}

Color<double> light_at(const SharedLight& image, Projection projection, const Uv<double>& uv) {
  const int width = image.width;
  const int height = image.height;
  const double x = uv.u * width - 0.5;
  const double y = (1 - uv.v) * height - 0.5;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const bool cube = facts_of(projection).aspect == 1.5;
  const bool inside = !cube && left >= 0 && left + 1 < width && top >= 0 && top + 1 < height;
  const Texel home = inside ? Texel{left, top} : texel_of(uv, width, height);
  const auto texel_at = [&](double column, double row) {
    Texel texel{static_cast<int>(column), static_cast<int>(row)};
    if (!inside) texel = texel_beside(projection, home, texel.column, texel.row, width, height);
    return number_cast<double>(image.at(texel.column, texel.row));
  };
  if (!cube || (left + 1) * 3 % width != 0 || (top + 1) * 2 % height != 0)
    return bilinear_mix(texel_at, x, y);
  // A corner of the cube, where three texels meet: their mean takes the place of the fourth.
  const int across = 2 * left + 1 - home.column, down = 2 * top + 1 - home.row;
  const Color<double> three =
      texel_at(home.column, home.row) + texel_at(across, home.row) + texel_at(home.column, down);
  const auto with_corner = [&](double column, double row) {
    return column == across && row == down ? three * (1.0 / 3) : texel_at(column, row);
  };
  return bilinear_mix(with_corner, x, y);
}

Image convert_projection(const SharedImage& image, Projection from, Projection to,
                         const PictureSize& size, int threads, const PixelChoice& wanted) {
  if (from == to && size == PictureSize{image.width, image.height})
    return static_cast<const Image&>(image);
  const SharedLight light(image, TexelLight::linear);
  Image result(size.width, size.height);
  for_each_row(size.height, threads, {}, [&](int row) {
    std::array<Vec3<double>, most_places * most_places> directions;
    std::array<Uv<double>, most_places * most_places> places;
    for (int column = 0; column < size.width; ++column) {
      if (wanted && !wanted(column, row)) continue;
      const Uv<double> center = center_of({column, row}, size.width, size.height);
      // Texels on the rim show the nearest direction, so that no black is mixed in.
      if (!shows(to, center, 1.5 / size.width)) continue;
      const int n = places_for(light, from, to, center, size);
      std::size_t count = 0;
      for (int down = 0; down < n; ++down) {
        const double v = 1 - (row + (down + 0.5) / n) / size.height;
        for (int across = 0; across < n; ++across) {
          const Uv<double> uv{(column + (across + 0.5) / n) / size.width, v};
          directions[count++] = unproject(to, uv);
        }
      }
      for (std::size_t k = 0; k < count; ++k) {  // apart: compilers then calculate several at once
        places[k] = from == Projection::equirect ? FastUnitMapping<35>{}(directions[k])
                                                 : project(from, directions[k]);
      }
      Color<double> sum{};
      for (std::size_t k = 0; k < count; ++k) {
        if (from == Projection::plane && directions[k].y < 0) continue;
        sum = sum + light_at(light, from, places[k]);
      }
      const double share = 1.0 / (n * n);
      result.at(column, row) = {encoded(sum.r * share), encoded(sum.g * share),
                                encoded(sum.b * share)};
    }
  });
  return result;
}

}  // namespace texmap
