// Directions drawn where a sky is bright.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/circle.hpp"
#include "number/compensated.hpp"
#include "sampling/cumulative_table.hpp"
#include "sampling/point2.hpp"
#include "texture/environment.hpp"
#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap {

/// A direction of the world, of unit length, and where it is on a sky's map.
template <class Real>
struct SkyDirection {
  Vec3<Real> direction;
  Uv<Real> uv;
};

/// Draws directions with the density of a sky's light: a texel with a probability in proportion to
/// its brightness times its solid angle, then a direction about it, by the sky's own filter.
/// `nearest`: uniform in the texel's solid angle. `bilinear`: by a tent two texels wide and high.
/// Domain: skies of at most 2^23 texels. Source: pbrt-v4, section 12.5, with exact solid angles.
class SkySampler {
 public:
  SkySampler() = default;
  explicit SkySampler(const Environment& sky)
      : width_(sky.map().width),
        height_(sky.map().height),
        filter_(sky.filter()),
        in_order_(z_order(width_, height_)),
        probabilities_(in_order_.size()) {
    for (int row = 0; row < height_; ++row) bands_.emplace_back(row, width_, height_);
    CompensatedSum<double> sum;
    std::vector<double> weights;
    std::vector<std::uint32_t> bright;  // what has no light is never drawn
    for (const std::uint32_t texel : in_order_) {
      const double light = brightness_of(sky.map().pixels[texel]) *
                           bands_[texel / static_cast<std::uint32_t>(width_)].solid_angle;
      sum.add(light);
      if (light == 0) continue;
      weights.push_back(light);
      bright.push_back(texel);
    }
    total_ = sum.value();
    if (!(total_ > 0)) return;  // a black sky: nothing to draw
    in_order_ = std::move(bright);
    table_ = CumulativeTable(weights);
    for (std::uint32_t i = 0; i < in_order_.size(); ++i)
      probabilities_[in_order_[i]] = static_cast<float>(table_.steps_of(i)) * 0x1p-24F;
  }

  /// The light of the whole sky: brightness times solid angle. A sky of 1 has 4 pi.
  [[nodiscard]] double total() const { return total_; }

  /// @param sample  in [0, 1), multiples of 2^-24: u chooses the texel and the place across it, v
  ///                the place down
  template <class Real>
  [[nodiscard]] SkyDirection<Real> direction(const Environment& sky,
                                             const Point2<Real>& sample) const {
    const auto u = all_lanes(sample.u);
    std::array<CumulativeTable::Drawn, lanes<Real>> drawn;
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      drawn[i] = table_.draw(static_cast<double>(u[i]));
      drawn[i].thing = in_order_[drawn[i].thing];
    }
    const auto columns = static_cast<std::uint32_t>(width_);
    const auto of_texels = [&](const auto& number) {
      return from_lanes<Real>(
          [&](std::size_t i) { return static_cast<Scalar<Real>>(number(drawn[i].thing)); });
    };
    const Real column = of_texels([&](std::uint32_t texel) { return texel % columns; });
    const Real row = of_texels([&](std::uint32_t texel) { return texel / columns; });
    const Real across =
        from_lanes<Real>([&](std::size_t i) { return static_cast<Scalar<Real>>(drawn[i].place); });
    const Real up = sample.v + Real(0x1p-25F);  // to the middle of a step: off the texel's edges
    // In float both may be rounded to 1.
    const Point2<Real> place = {min(across, below_one<Real>()), min(up, below_one<Real>())};
    const Real middle_u = (column + Real(0.5)) / Real(width_);
    const Real middle_v = Real(1) - (row + Real(0.5)) / Real(height_);
    if (filter_ == TexelFilter::bilinear) {
      const Uv<Real> uv = over_poles(Uv<Real>{middle_u + tent(place.u) / Real(width_),
                                              middle_v - tent(place.v) / Real(height_)});
      return {sky.from_map(direction_rtiow(uv)), uv};
    }
    const auto of_bands = [&](double SkyBand::*number) {
      return of_texels([&](std::uint32_t texel) { return bands_[texel / columns].*number; });
    };
    const Real from = of_bands(&SkyBand::from);
    const Real below_pole = from + place.v * (of_bands(&SkyBand::to) - from);
    const OnCircle<Real> around = on_circle(Real(0.5) - (column + place.u) / Real(width_));
    const Real radius = sqrt(below_pole * (Real(2) - below_pole));
    const Real y = of_bands(&SkyBand::y_sign) * (Real(1) - below_pole);
    return {sky.from_map(Vec3<Real>{radius * around.cosine, y, radius * around.sine}),
            {middle_u, middle_v}};
  }

  /// The density of `direction`: probability per steradian. At a pole of a bilinear sky it is
  /// infinite, or NaN where that is black.
  ///
  /// @param uv  of the direction: Environment::uv_of
  template <class Real>
  [[nodiscard]] Real density(const Vec3<Real>& direction, const Uv<Real>& uv) const {
    if (filter_ == TexelFilter::nearest) {
      return entry(clamp(floor(uv.u * Real(width_)), Real(0), Real(width_ - 1)),
                   clamp(floor(uv.v * Real(height_)), Real(0), Real(height_ - 1)),
                   [this](std::size_t texel, std::size_t row) {
                     return static_cast<double>(probabilities_[texel]) / bands_[row].solid_angle;
                   });
    }
    const auto probability = [this](const Real& column, const Real& row) {
      return entry(column, row,
                   [this](std::size_t texel, std::size_t) { return probabilities_[texel]; });
    };
    const Real in_texels = mixed_on_sphere(probability, uv, width_, height_);
    const Real sine = sqrt(direction.x * direction.x + direction.z * direction.z);
    return in_texels * (Real(width_) * Real(height_)) / (Real(2) * pi<Real>() * pi<Real>() * sine);
  }

  [[nodiscard]] const std::vector<SkyBand>& bands() const { return bands_; }
  /// Of each texel, row by row from the top: whole multiples of 2^-24.
  [[nodiscard]] const std::vector<float>& probabilities() const { return probabilities_; }

 private:
  /// A number from -1 to 1 with the density 1 - |x|.
  template <class Real>
  [[nodiscard]] static Real tent(const Real& uniform) {
    const Real left = sqrt(Real(2) * min(uniform, Real(0.5))) - Real(1);
    const Real right = Real(1) - sqrt(Real(2) * (Real(1) - max(uniform, Real(0.5))));
    return select(uniform < Real(0.5), left, right);
  }
  /// v beyond a pole turned back, half a turn further in u; u from 0 to 1.
  template <class Real>
  [[nodiscard]] static Uv<Real> over_poles(const Uv<Real>& uv) {
    const Real inside = clamp(uv.v, Real(0), Real(1));
    const Real u = uv.u + select(inside == uv.v, Real(0), Real(0.5));
    return {u - floor(u), inside - (uv.v - inside)};
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
  std::vector<SkyBand> bands_;
  std::vector<std::uint32_t> in_order_{0};  ///< texels, as they lie in the table
  std::vector<float> probabilities_{0};
  CumulativeTable table_;
  double total_ = 0;
};

}  // namespace texmap
