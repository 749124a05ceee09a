// References in double for functions of a float: each within 1e-13 of itself.
#pragma once
#include "every_float.hpp"
#include "sampling/directions.hpp"

namespace texmap::test {

/// Fills a block's reference from a function of one pack of doubles.
template <class Function>
void fill_exact(Block& block, const Function& function) {
  alignas(64) std::array<double, Block::size> x;
  for (std::size_t i = 0; i < Block::size; ++i) x[i] = static_cast<double>(block.x[i]);
  in_packs(x.data(), block.exact.data(), function);
}

/// A reference by a function of packs; blocks that end at `joint` or below use a shorter one.
template <class Near, class Far>
[[nodiscard]] Prepare by_parts(float joint, Near near, Far far) {
  return [=](Block& block) {
    block.x.back() <= joint ? fill_exact(block, near) : fill_exact(block, far);
  };
}

inline const Wide half_turns(static_cast<double>(1 / pi_digits));

/// atan(t) / t for t below 2^-10, by its series: what is left out is below 2^-60.
[[nodiscard]] inline Wide small_arc_tangent_ratio(const Wide& t) {
  const Wide square = t * t;
  return Wide(1) - square * (Wide(1. / 3) - square * Wide(0.2));
}

/// The arc tangent of t from 0 to 1, in turns.
inline const Prepare exact_eighth_turn = by_parts(
    0x1p-10F, [](const Wide& t) { return t * small_arc_tangent_ratio(t) * Wide(0.5) * half_turns; },
    [](const Wide& t) { return atan2(t, Wide(1)) * Wide(0.5) * half_turns; });

/// The angle of (beside, x) from the equator's plane to the axis: from the pole, in half turns,
/// for 0 <= x <= 1. Fills `beside` with the distance from the axis of a point on the sphere.
inline void exact_from_pole(Block& block) {
  for (std::size_t i = 0; i < Block::size; ++i) {
    const auto y = static_cast<double>(block.x[i]);
    block.beside[i] = static_cast<float>(std::sqrt((1 - y) * (1 + y)));
  }
  const bool small = block.x.back() < 0x1p-10F;
  std::size_t at = 0;
  fill_exact(block, [&](const Wide& y) {
    const Wide around = from_lanes<Wide>([&](std::size_t) { return double{block.beside[at++]}; });
    if (!small) return atan2(around, y) * half_turns;
    return Wide(0.5) - y / around * small_arc_tangent_ratio(y / around) * half_turns;
  });
}

/// The cosine and the sine of up to an eighth of a turn.
inline void exact_cosine(Block& block) {
  fill_exact(block, [](const Wide& x) { return on_circle_eighth(x).cosine; });
}
inline void exact_sine(Block& block) {
  fill_exact(block, [](const Wide& x) { return on_circle_eighth(x).sine; });
}

/// 255 times the sRGB curve of light from 0 to 1.
inline const Prepare exact_srgb_level = by_parts(
    0.0031308F, [](const Wide& light) { return light * Wide(255 * 12.92); },
    [](const Wide& light) {
      const Wide power = exp(log1p(light - Wide(1)) * Wide(5. / 12));
      return select(light <= Wide(0.0031308), light * Wide(255 * 12.92),
                    Wide(255) * (Wide(1.055) * power - Wide(0.055)));
    });

/// The byte of that level.
inline void exact_srgb_byte(Block& block) {
  exact_srgb_level(block);
  for (double& level : block.exact) level = std::floor(level + 0.5);
}

/// The light of an encoded channel from 0 to 1.
inline const Prepare exact_srgb_decode = by_parts(
    0.04045F, [](const Wide& encoded) { return encoded / Wide(12.92); },
    [](const Wide& encoded) {
      const Wide power = exp(log1p((encoded - Wide(1)) / Wide(1.055)) * Wide(2.4));
      return select(encoded <= Wide(0.04045), encoded / Wide(12.92), power);
    });

/// (1 - w)^n for w from 0 to 1.
[[nodiscard]] inline Prepare exact_power(double n) {
  const Prepare any = by_parts(
      static_cast<float>(0x1p-28 / n),  // the next term is below 2^-55
      [n](const Wide& w) { return Wide(1) - Wide(n) * w; },
      [n](const Wide& w) { return select(w < Wide(1), exp(Wide(n) * log1p(-w)), Wide(0)); });
  return [n, any](Block& block) {
    if (n * double{block.x.front()} > 60) return block.exact.fill(0);
    any(block);
  };
}

}  // namespace texmap::test
