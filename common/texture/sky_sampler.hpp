// Directions drawn where a sky is bright.
#pragma once
#include <cstddef>
#include <vector>

#include "math/circle.hpp"
#include "sampling/alias_table.hpp"
#include "sampling/point2.hpp"
#include "texture/sky_texels.hpp"

namespace texmap {

/// Draws a texel with a probability in proportion to its light, brightness times solid angle, and
/// then a direction in it, uniformly in solid angle. Domain: skies of at most 2^24 texels.
/// Source: pbrt-v4, section 12.5; each texel's solid angle is exact here.
class SkySampler {
 public:
  SkySampler() = default;
  explicit SkySampler(const Environment& sky)
      : width_(sky.map().width), height_(sky.map().height), densities_(brightness_of_texels(sky)) {
    std::vector<double> weights;
    weights.reserve(densities_.size());
    CompensatedSum<double> sum;
    for (int row = 0; row < height_; ++row) {
      bands_.emplace_back(row, width_, height_);
      for (int column = 0; column < width_; ++column) {
        weights.push_back(densities_[weights.size()] * bands_.back().solid_angle);
        sum.add(weights.back());
      }
    }
    total_ = sum.value();
    if (!(total_ > 0)) return;  // a black sky: nothing to draw
    for (double& density : densities_) density /= total_;
    texels_ = AliasTable(weights);
  }

  /// The light of the whole sky: brightness times solid angle. A sky of 1 has 4 pi.
  [[nodiscard]] double total() const { return total_; }

  /// A direction of the world, of unit length.
  ///
  /// @param texel, within  in [0, 1), multiples of 2^-24: choose the texel, and the place in it
  template <class Real>
  [[nodiscard]] Vec3<Real> direction(const Environment& sky, const Point2<Real>& texel,
                                     const Point2<Real>& within) const {
    const auto u = all_lanes(texel.u);
    const auto v = all_lanes(texel.v);
    std::array<std::array<Scalar<Real>, lanes<Real>>, 4> found;
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      const std::uint32_t drawn =
          texels_.draw(static_cast<double>(u[i]), static_cast<double>(v[i]));
      const auto columns = static_cast<std::uint32_t>(width_);
      const SkyBand& band = bands_[drawn / columns];
      found[0][i] = static_cast<Scalar<Real>>(drawn % columns);
      found[1][i] = static_cast<Scalar<Real>>(band.from);
      found[2][i] = static_cast<Scalar<Real>>(band.to);
      found[3][i] = static_cast<Scalar<Real>>(band.y_sign);
    }
    const auto packed = [&](std::size_t k) {
      return from_lanes<Real>([&](std::size_t i) { return found[k][i]; });
    };
    const Real step = Real(0x1p-25F);  // to the middle of a step: off the texel's edges
    const Real from = packed(1);
    const Real below_pole = from + (within.v + step) * (packed(2) - from);
    const Real around = (packed(0) + (within.u + step)) / Real(width_);
    const OnCircle<Real> turned = on_circle(Real(0.5) - around);
    const Real radius = sqrt(below_pole * (Real(2) - below_pole));
    return sky.from_map(Vec3<Real>{radius * turned.cosine, packed(3) * (Real(1) - below_pole),
                                   radius * turned.sine});
  }

  /// The density of `direction`: probability per steradian of a direction of the world.
  template <class Real>
  [[nodiscard]] Real density(const Environment& sky, const Vec3<Real>& direction) const {
    const Uv<Real> uv = uv_rtiow(sky.to_map(direction));
    const auto columns = all_lanes(
        clamp(floor(uv.u * Real(width_)), Real(0), Real(width_ - 1)));
    const auto from_zero = all_lanes(
        clamp(floor(uv.v * Real(height_)), Real(0), Real(height_ - 1)));
    return from_lanes<Real>([&](std::size_t i) {
      const auto row = static_cast<std::size_t>(height_ - 1 - static_cast<int>(from_zero[i]));
      return static_cast<Scalar<Real>>(
          densities_[row * static_cast<std::size_t>(width_) + static_cast<std::size_t>(columns[i])]);
    });
  }

  [[nodiscard]] const std::vector<SkyBand>& bands() const { return bands_; }
  [[nodiscard]] const AliasTable& texels() const { return texels_; }
  /// Of each texel, row by row from the top; per steradian.
  [[nodiscard]] const std::vector<double>& densities() const { return densities_; }

 private:
  int width_ = 1;
  int height_ = 1;
  std::vector<double> densities_;
  std::vector<SkyBand> bands_;
  AliasTable texels_;
  double total_ = 0;
};

}  // namespace texmap
