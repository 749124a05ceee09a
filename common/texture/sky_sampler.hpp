// Directions drawn where a sky is bright.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/circle.hpp"
#include "number/compensated.hpp"
#include "sampling/alias_table.hpp"
#include "sampling/point2.hpp"
#include "texture/environment.hpp"
#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap {

/// Draws directions with the density of a sky's light: a texel with a probability in proportion to
/// its brightness times its solid angle, then a direction about it, by the sky's own filter.
/// `nearest`: uniform in the texel's solid angle. `bilinear`: by a tent two texels wide and high.
/// Domain: skies of at most 2^23 texels. Source: pbrt-v4, section 12.5, with exact solid angles.
class SkySampler {
 public:
  SkySampler() = default;
  explicit SkySampler(const Environment& sky)
      : width_(sky.map().width), height_(sky.map().height), filter_(sky.filter()) {
    CompensatedSum<double> sum;
    for (int row = 0; row < height_; ++row) {
      bands_.emplace_back(row, width_, height_);
      for (int column = 0; column < width_; ++column) {
        probabilities_.push_back(brightness_of(sky.map().at(column, row)) *
                                 bands_.back().solid_angle);
        sum.add(probabilities_.back());
      }
    }
    total_ = sum.value();
    if (!(total_ > 0)) return;  // a black sky: nothing to draw
    for (double& probability : probabilities_) probability /= total_;
    texels_ = AliasTable(probabilities_);
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
    std::array<std::uint32_t, lanes<Real>> drawn;
    for (std::size_t i = 0; i < lanes<Real>; ++i)
      drawn[i] = texels_.draw(static_cast<double>(u[i]), static_cast<double>(v[i]));
    const auto columns = static_cast<std::uint32_t>(width_);
    const auto of_lanes = [&](const auto& number) {
      return from_lanes<Real>(
          [&](std::size_t i) { return static_cast<Scalar<Real>>(number(drawn[i])); });
    };
    const Real column = of_lanes([&](std::uint32_t i) { return i % columns; });
    const Real step = Real(0x1p-25F);  // to the middle of a step: off the texel's edges
    const Point2<Real> place = {within.u + step, within.v + step};
    if (filter_ == TexelFilter::bilinear) {
      const Real row = of_lanes([&](std::uint32_t i) { return i / columns; });
      return sky.from_map(direction_rtiow(
          over_poles(Uv<Real>{(column + Real(0.5) + tent(place.u)) / Real(width_),
                              Real(1) - (row + Real(0.5) + tent(place.v)) / Real(height_)})));
    }
    const auto band = [&](std::uint32_t i) -> const SkyBand& { return bands_[i / columns]; };
    const Real from = of_lanes([&](std::uint32_t i) { return band(i).from; });
    const Real to = of_lanes([&](std::uint32_t i) { return band(i).to; });
    const Real y_sign = of_lanes([&](std::uint32_t i) { return band(i).y_sign; });
    const Real below_pole = from + place.v * (to - from);
    const OnCircle<Real> around = on_circle(Real(0.5) - (column + place.u) / Real(width_));
    const Real radius = sqrt(below_pole * (Real(2) - below_pole));
    return sky.from_map(
        Vec3<Real>{radius * around.cosine, y_sign * (Real(1) - below_pole), radius * around.sine});
  }

  /// The density of `direction`: probability per steradian; infinite at a pole of a bilinear sky.
  template <class Real>
  [[nodiscard]] Real density(const Environment& sky, const Vec3<Real>& direction) const {
    const Vec3<Real> on_map = sky.to_map(direction);
    const Uv<Real> uv = uv_rtiow(on_map);
    if (filter_ == TexelFilter::nearest) {
      return entry(clamp(floor(uv.u * Real(width_)), Real(0), Real(width_ - 1)),
                   clamp(floor(uv.v * Real(height_)), Real(0), Real(height_ - 1)),
                   [this](std::size_t texel, std::size_t row) {
                     return probabilities_[texel] / bands_[row].solid_angle;
                   });
    }
    const FourTexels<Real> four = four_texels(uv, width_, height_);
    const auto probability = [&](std::size_t i) {
      return entry(four.texels[i].column, four.texels[i].row,
                   [this](std::size_t texel, std::size_t) { return probabilities_[texel]; });
    };
    const auto between = [&](const Real& a, const Real& b, const Real& t) {
      return a * (Real(1) - t) + b * t;
    };
    const Real in_texels = between(between(probability(0), probability(1), four.across),
                                   between(probability(2), probability(3), four.across), four.up);
    const Real sine = sqrt(on_map.x * on_map.x + on_map.z * on_map.z);
    return in_texels * (Real(width_) * Real(height_)) / (Real(2) * pi<Real>() * pi<Real>() * sine);
  }

  [[nodiscard]] const std::vector<SkyBand>& bands() const { return bands_; }
  [[nodiscard]] const AliasTable& texels() const { return texels_; }
  /// Of each texel, row by row from the top.
  [[nodiscard]] const std::vector<double>& probabilities() const { return probabilities_; }

 private:
  /// A number from -1 to 1 with the density 1 - |x|.
  template <class Real>
  [[nodiscard]] static Real tent(const Real& uniform) {
    const Real left = sqrt(Real(2) * min(uniform, Real(0.5))) - Real(1);
    const Real right = Real(1) - sqrt(Real(2) * (Real(1) - max(uniform, Real(0.5))));
    return select(uniform < Real(0.5), left, right);
  }
  /// v beyond a pole turned back, half a turn further in u.
  template <class Real>
  [[nodiscard]] static Uv<Real> over_poles(const Uv<Real>& uv) {
    const Real inside = clamp(uv.v, Real(0), Real(1));
    return {uv.u + select(inside == uv.v, Real(0), Real(0.5)), inside - (uv.v - inside)};
  }
  /// What `number` gives for a texel and its row, in each lane; rows counted from v = 0.
  template <class Real, class Number>
  [[nodiscard]] Real entry(const Real& column, const Real& from_zero, const Number& number) const {
    const auto columns = all_lanes(column);
    const auto rows = all_lanes(from_zero);
    return from_lanes<Real>([&](std::size_t i) {
      const auto row = static_cast<std::size_t>(height_ - 1 - static_cast<int>(rows[i]));
      const std::size_t texel =
          row * static_cast<std::size_t>(width_) + static_cast<std::size_t>(columns[i]);
      return static_cast<Scalar<Real>>(number(texel, row));
    });
  }

  int width_ = 1;
  int height_ = 1;
  TexelFilter filter_ = TexelFilter::nearest;
  std::vector<double> probabilities_;
  std::vector<SkyBand> bands_;
  AliasTable texels_;
  double total_ = 0;
};

}  // namespace texmap
