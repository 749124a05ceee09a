// Texture filters: the mean light that a pixel's footprint covers, from few texels.
#pragma once
#include "math/color.hpp"
#include "number/compiler.hpp"
#include "sampling/hash.hpp"
#include "texture/bilinear_mix.hpp"
#include "texture/footprint.hpp"
#include "texture/pyramid.hpp"
#include "texture/wrap.hpp"

namespace texmap {

/// How a texture is read. To add a filter, name it here; its word: engine/run/options.cpp.
enum class Filter {
  nearest,      ///< the texel at the pixel's center: 1 read
  bilinear,     ///< the 4 texels around the center, mixed
  trilinear,    ///< bilinear in two levels of the pyramid, as wide as the footprint is long: 8
  anisotropic,  ///< several such reads along the footprint, as wide as it is short
  ewa,          ///< all texels in an ellipse, with weights that fall off towards its edge
  stochastic,   ///< one texel of those that `anisotropic` reads, at random, as often as it weighs
};

/// Where a filter reads in the pyramid: `fraction` of the way from a level to the next.
template <class Real>
struct LevelPlace {
  Real number;    ///< of the finer level
  Real fraction;  ///< 0 to 1
};

/// The place between the levels where the mean square of the texels' widths is `width` squared.
/// Textbook: log2(width). This has the same whole numbers and needs no logarithm. It takes level l
/// for 2^l wide: where sides are no powers of two, texels are up to twice as wide as that.
///
/// @param width  in texels of level 0; below 1 and NaN count as 1
template <class Real>
[[nodiscard]] LevelPlace<Real> level_place(const Real& width, int last_level) {
  Real number = Real(0);
  Real scaled = max(width, Real(1));
  for (int level = 0; level < last_level; ++level) {
    const Mask<Real> coarser = scaled >= Real(2);
    if (!any(coarser)) break;
    scaled = select(coarser, scaled * Real(0.5), scaled);
    number = select(coarser, number + Real(1), number);
  }
  const Real fraction = clamp((scaled * scaled - Real(1)) / Real(3), Real(0), Real(1));
  return {number, select(number < Real(last_level), fraction, Real(0))};
}

/// A texture that is filtered: with the footprint of each pixel where the number has derivatives.
/// Texels have their centers at half numbers: column = u width - 1/2.
/// To read texels in another way, derive from Pyramid and overload texel_light.
template <class Texels>
struct Filtered {
  Texels pyramid;  ///< an empty one is black
  Filter filter = Filter::anisotropic;
  Wrap wrap = Wrap::repeat;
  int taps = 16;  ///< the most reads along a footprint; along a longer one each is wider
  VAxis v_axis = VAxis::up;
  Rgb border{};  ///< seen beyond the edges with Wrap::border

  /// The color at (u, v), without a footprint: the nearest texel, or the bilinear filter.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (pyramid.levels.empty()) return gray(Real(0));
    const PyramidLevel<int>& first = pyramid.levels.front();
    const PyramidLevel<Real> level{Real(first.width), Real(first.height), Real(0)};
    switch (filter) {
      case Filter::nearest:
        return nearest(rows_down(uv), level);
      case Filter::bilinear:
      case Filter::trilinear:  // of a point these are bilinear
      case Filter::anisotropic:
      case Filter::ewa:
      case Filter::stochastic:
        break;
    }
    return bilinear(rows_down(uv), level);
  }

  /// The color of a pixel, by the derivatives of (u, v). It is constant: its derivatives are 0.
  template <class Real>
  [[nodiscard]] Color<Dual<Real>> operator()(const Uv<Dual<Real>>& uv) const {
    const Color<Real> color = filtered(uv);
    return {color.r, color.g, color.b};
  }

  /// The mean light of the footprint at `uv`.
  template <class Real>
  [[nodiscard]] Color<Real> filtered(const Uv<Dual<Real>>& uv) const {
    const Uv<Real> center{uv.u.value, uv.v.value};
    if (pyramid.levels.empty() || filter == Filter::nearest || filter == Filter::bilinear)
      return (*this)(center);
    Uv<Dual<Real>> down = rows_down(uv);
    if (wrap == Wrap::spherical) {
      // Around a pole u grows without a limit, but once round is all that there is; in it, where u
      // is a constant, too.
      const Mask<Real> pole = center.v <= Real(0) || center.v >= Real(1);
      down.u.dx = select(pole, Real(1), clamp(down.u.dx, Real(-1), Real(1)));
      down.u.dy = select(pole, Real(1), clamp(down.u.dy, Real(-1), Real(1)));
    }
    const PyramidLevel<int>& whole = pyramid.levels.front();
    return filtered(rows_down(center), footprint_of(down, Real(whole.width), Real(whole.height)));
  }

  /// The same for a footprint at a place whose v is counted from the top row.
  template <class Real>
  [[nodiscard]] Color<Real> filtered(const Uv<Real>& at, const Footprint<Real>& footprint) const {
    switch (filter) {
      case Filter::trilinear:
        return trilinear(at, levels_for(footprint.longer));
      case Filter::ewa:
        return elliptical(at, footprint);
      case Filter::stochastic:
        // Intervals have no integers to hash: they bound the mean of all choices.
        if constexpr (requires { uint_from_real(at.u); }) return one_of_many(at, footprint);
        break;
      case Filter::nearest:  // these two have no footprint
      case Filter::bilinear:
      case Filter::anisotropic:
        break;
    }
    return many(at, footprint);
  }

  /// The place in the pyramid for texels of this width.
  template <class Real>
  [[nodiscard]] LevelPlace<Real> place(const Real& width) const {
    return level_place(width, pyramid.last_level());
  }

  /// The texel of a level that holds `at`: at an edge the one on the right, or the lower one.
  template <class Real>
  [[nodiscard]] Color<Real> nearest(const Uv<Real>& at, const PyramidLevel<Real>& level) const {
    return wrapped(level, floor(limited(at.u * level.width)), floor(limited(at.v * level.height)));
  }

  /// The four texels of a level around `at`, mixed; exact at the centers of texels.
  template <class Real>
  [[nodiscard]] Color<Real> bilinear(const Uv<Real>& at, const PyramidLevel<Real>& level) const {
    if (wrap == Wrap::border || (wrap == Wrap::spherical && sees_pole(at, level)))
      return bilinear_beyond_edges(at, level);
    const Wrap sideways = wrap == Wrap::spherical ? Wrap::repeat : wrap;
    const Wrap downward = wrap == Wrap::spherical ? Wrap::clamp : wrap;
    const Real x = wrapped_coordinate(sideways, at.u) * level.width - Real(0.5);
    const Real y = wrapped_coordinate(downward, at.v) * level.height - Real(0.5);
    const Real left = floor(x), top = floor(y);
    return mixed_light(pyramid, level, wrapped_neighbors(sideways, left, level.width),
                       wrapped_neighbors(downward, top, level.height), x - left, y - top);
  }

  /// Two neighboring levels of the pyramid, and how much of the coarser one is mixed in.
  template <class Real>
  struct TwoLevels {
    PyramidLevel<Real> fine, coarse;
    Real fraction;
    bool mixed;  ///< false where `fine` is enough
  };
  /// The levels for texels of this width.
  template <class Real>
  [[nodiscard]] TwoLevels<Real> levels_for(const Real& width) const {
    const auto [number, fraction] = place(width);
    const PyramidLevel<Real> fine = level_of(pyramid, number);
    const Mask<Real> between = fraction > Real(0);
    if (!any(between)) return {fine, fine, fraction, false};
    return {fine, level_of(pyramid, select(between, number + Real(1), number)), fraction, true};
  }

  /// Two levels, mixed.
  template <class Real>
  [[nodiscard]] Color<Real> trilinear(const Uv<Real>& at, const TwoLevels<Real>& levels) const {
    const Color<Real> fine = bilinear(at, levels.fine);
    return levels.mixed ? mix(fine, bilinear(at, levels.coarse), levels.fraction) : fine;
  }

  /// Reads along a footprint: how many, how wide each is, where the first is, and the step to the
  /// next.
  template <class Real>
  struct Taps {
    Real count, width;
    Uv<Real> first, step;

    /// The middle of read `i`.
    [[nodiscard]] Uv<Real> at(const Real& i) const {
      return {first.u + step.u * i, first.v + step.v * i};
    }
  };
  /// The reads along a footprint, at most `taps`. Those as wide as the picture all see its mean:
  /// then one is enough, unless they see the border. (By Wrap::clamp that is the mean of the
  /// picture, too, and not of its edge.)
  template <class Real>
  [[nodiscard]] Taps<Real> taps_of(const Uv<Real>& at, const Footprint<Real>& footprint) const {
    const PyramidLevel<int>& whole = pyramid.levels.front();
    const Real least = max(footprint.shorter, Real(1));
    const Real most = clamp(-floor(-footprint.longer / least), Real(1), Real(taps));
    const Real width = max(least, footprint.longer / most);
    const Mask<Real> all_alike = width >= Real(widest()) && mask_of<Real>(wrap != Wrap::border);
    const Real count = select(all_alike, Real(1), most);
    const Uv<Real> step{footprint.along_u / (count * Real(whole.width)),
                        footprint.along_v / (count * Real(whole.height))};
    const Real to_first = Real(0.5) * (Real(1) - count);
    return {count, width, {at.u + step.u * to_first, at.v + step.v * to_first}, step};
  }
  /// The longer side of the whole picture, in texels.
  [[nodiscard]] int widest() const {
    return std::max(pyramid.levels.front().width, pyramid.levels.front().height);
  }

  /// The mean of trilinear reads along the footprint's longer side.
  template <class Real>
  [[nodiscard]] Color<Real> many(const Uv<Real>& at, const Footprint<Real>& footprint) const {
    const Taps<Real> reads = taps_of(at, footprint);
    const TwoLevels<Real> levels = levels_for(reads.width);
    Color<Real> sum{};
    for (int i = 0; i < taps; ++i) {
      const Mask<Real> here = Real(i) < reads.count;
      if (!any(here)) break;
      sum = select(here, sum + trilinear(reads.at(Real(i)), levels), sum);
    }
    return sum * (Real(1) / reads.count);
  }

  /// Random numbers in [0, 1): which read, which level, which column, which row.
  template <class Real>
  struct Choice {
    Real tap, level, column, row;
  };

  /// One texel of those that `many` reads; chosen as often as it weighs there.
  template <class Real>
  [[nodiscard]] Color<Real> one_of_many(const Uv<Real>& at, const Footprint<Real>& footprint,
                                        const Choice<Real>& choice) const {
    const Taps<Real> reads = taps_of(at, footprint);
    const LevelPlace<Real> place = this->place(reads.width);
    const Uv<Real> middle = reads.at(floor(choice.tap * reads.count));
    const Real number = select(choice.level < place.fraction, place.number + Real(1), place.number);
    const PyramidLevel<Real> level = level_of(pyramid, number);
    // The nearest texel of a place moved by up to half a texel is the right one as often as the
    // bilinear filter weighs it.
    return wrapped(level, floor(limited(middle.u * level.width - Real(0.5) + choice.column)),
                   floor(limited(middle.v * level.height - Real(0.5) + choice.row)));
  }
  /// The same with random numbers from a hash of the place.
  template <class Real>
  [[nodiscard]] Color<Real> one_of_many(const Uv<Real>& at,
                                        const Footprint<Real>& footprint) const {
    const auto bits_of = [](const Real& x) {
      const Real part = clamp(x - floor(x), Real(0), below_one<Real>());
      return uint_from_real(part * Real(1073741824));  // 2^30
    };
    UInt<Real> hash = hash_bits(UInt<Real>(bits_of(at.u) + 0x9e3779b9U));
    hash = hash_bits(UInt<Real>(hash + bits_of(at.v)));
    const auto next = [&hash] {
      hash = hash_bits(UInt<Real>(hash + 0x9e3779b9U));
      return unit_interval<Real>(hash);
    };
    const Real tap = next(), level = next(), column = next(), row = next();
    return one_of_many(at, footprint, Choice<Real>{tap, level, column, row});
  }

  /// An ellipse in a level of the pyramid: (c x^2 - 2 b x y + a y^2) / (a c - b^2) <= 1, in texels
  /// from its middle.
  template <class Real>
  struct Ellipse {
    PyramidLevel<Real> level;
    Real a, b, c;
  };
  /// The ellipse with the footprint's axes, in the level where a read of `taps_of` is 1 to 2 texels
  /// wide; its semi-axes are at least 1 texel.
  template <class Real>
  [[nodiscard]] Ellipse<Real> ellipse_of(const Footprint<Real>& footprint) const {
    const Real longest = max(footprint.longer, Real(1));
    const Real width = max(footprint.shorter, longest / Real(taps));
    const PyramidLevel<Real> level = level_of(pyramid, place(width).number);
    const PyramidLevel<int>& whole = pyramid.levels.front();
    const Real scale_u = level.width / Real(whole.width);
    const Real scale_v = level.height / Real(whole.height);
    const Real share = select(footprint.longer > Real(0), width / footprint.longer, Real(1));
    const Real rest = max(Real(1) - share * share, Real(0));
    // Beyond two copies of the image nothing new comes.
    const Real most_u = Real(2) * level.width, most_v = Real(2) * level.height;
    const Real u = clamp(footprint.along_u * scale_u, -most_u, most_u);
    const Real v = clamp(footprint.along_v * scale_v, -most_v, most_v);
    const Real round_u = square(min(width * scale_u, most_u));
    const Real round_v = square(min(width * scale_v, most_v));
    const Real spread = Real(squared_axis_per_side);
    return {level, spread * (u * u * rest + round_u) + Real(1), spread * (u * v * rest),
            spread * (v * v * rest + round_v) + Real(1)};
  }

  /// The texels in the footprint's ellipse, with the weight (1 - r^2)^2, r = 1 on its edge.
  /// Source: Greene and Heckbert (1986); their weight is a Gaussian, this one needs no exponential.
  template <class Real>
  [[nodiscard]] Color<Real> elliptical(const Uv<Real>& at, const Footprint<Real>& footprint) const {
    const auto [level, a, b, c] = ellipse_of(footprint);
    const Real x = limited(at.u * level.width - Real(0.5));
    const Real y = limited(at.v * level.height - Real(0.5));
    const Real inverse = Real(1) / (a * c - b * b);
    const Real left = -floor(-(x - sqrt(a))), top = -floor(-(y - sqrt(c)));
    const Real right = x + sqrt(a), bottom = y + sqrt(c);
    Color<Real> sum{};
    Real weights = Real(0);
    for (Real row = top; any(row <= bottom); row = row + Real(1)) {
      for (Real column = left; any(column <= right); column = column + Real(1)) {
        const Real dx = column - x, dy = row - y;
        const Real radius = (c * dx * dx - Real(2) * b * dx * dy + a * dy * dy) * inverse;
        const Mask<Real> inside = radius < Real(1);
        if (!any(inside)) continue;
        const Real weight = select(inside, square(Real(1) - radius), Real(0));
        sum = sum + wrapped(level, column, row) * weight;
        weights = weights + weight;
      }
    }
    return sum * (Real(1) / weights);
  }
  /// A semi-axis A for a side L, A^2 = 2/3 L^2, so that both have the same variance: that of the
  /// side is L^2 / 12, and that of the weight (1 - r^2)^2 is A^2 / 8.
  static constexpr double squared_axis_per_side = 2.0 / 3;

 private:
  /// (u, v) with v counted from the top row.
  template <class Real>
  [[nodiscard]] Uv<Real> rows_down(const Uv<Real>& uv) const {
    return {uv.u, v_axis == VAxis::down ? uv.v : Real(1) - uv.v};
  }
  /// A coordinate in texels, limited to what is exact to a quarter; NaN becomes the lowest.
  template <class Real>
  [[nodiscard]] Real limited(const Real& x) const {
    const Real most = Real(0.25) / unit_roundoff<Real>();
    return clamp(x, -most, most);
  }
  /// True where a row beyond a pole may be read.
  template <class Real>
  [[nodiscard]] bool sees_pole(const Uv<Real>& at, const PyramidLevel<Real>& level) const {
    return any(min(at.v, Real(1) - at.v) * level.height < Real(0.5));
  }
  /// The same as `bilinear` where columns depend on rows: each texel is wrapped by itself.
  template <class Real>
  [[nodiscard]] TEXMAP_NOINLINE Color<Real> bilinear_beyond_edges(
      const Uv<Real>& at, const PyramidLevel<Real>& level) const {
    // As in `bilinear`, so that a lane does not depend on its neighbors.
    const Real u = wrap == Wrap::spherical ? wrapped_coordinate(Wrap::repeat, at.u) : at.u;
    const Real x = limited(u * level.width - Real(0.5));
    const Real y = limited(at.v * level.height - Real(0.5));
    const auto texel_at = [&](const Real& column, const Real& row) {
      return wrapped(level, column, row);
    };
    return bilinear_mix(texel_at, x, y);
  }
  /// The texel seen at a column and a row, inside the image or beyond.
  template <class Real>
  [[nodiscard]] Color<Real> wrapped(const PyramidLevel<Real>& level, const Real& column,
                                    const Real& row) const {
    const WrappedTexel<Real> texel = wrapped_texel(wrap, column, row, level.width, level.height);
    const Color<Real> inside = texel_light(pyramid, level, texel.column, texel.row);
    if (wrap != Wrap::border) return inside;
    return select(texel.inside, inside, number_cast<Real>(border));
  }
};
using FilteredTexture = Filtered<Pyramid>;

}  // namespace texmap
