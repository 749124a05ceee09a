// References in double for functions of a float: each within 1e-14 of itself, which their own test
// holds against long double.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

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

using Wide = Pack<double>;

/// atan(t) / t for t below 2^-10, by its series: what is left out is below 2^-60.
[[nodiscard]] inline Wide small_arc_tangent_ratio(const Wide& t) {
  const Wide square = t * t;
  return Wide(1) - square * (Wide(1. / 3) - square * Wide(0.2));
}

/// The arc tangent of t from 0 to 1, in turns.
inline void exact_eighth_turn(Block& block) {
  const Wide turns(static_cast<double>(0.5L / pi_digits));
  if (block.x.back() < 0x1p-10F) {
    fill_exact(block, [&](const Wide& t) { return t * small_arc_tangent_ratio(t) * turns; });
  } else {
    fill_exact(block, [&](const Wide& t) { return atan2(t, Wide(1)) * turns; });
  }
}

/// The angle of (beside, x) from the equator's plane to the axis: from the pole, in half turns,
/// for 0 <= x <= 1. Fills `beside` with the distance from the axis of a point on the sphere.
inline void exact_from_pole(Block& block) {
  alignas(64) std::array<double, Block::size> y, around;
  for (std::size_t i = 0; i < Block::size; ++i) {
    y[i] = static_cast<double>(block.x[i]);
    around[i] = std::sqrt((1 - y[i]) * (1 + y[i]));
    block.beside[i] = static_cast<float>(around[i]);
    around[i] = static_cast<double>(block.beside[i]);
  }
  const Wide half_turns(static_cast<double>(1 / pi_digits));
  const bool small = block.x.back() < 0x1p-10F;
  for (std::size_t i = 0; i < Block::size; i += lanes<Wide>) {
    const Wide high(Wide::Batch::load_aligned(y.data() + i));
    const Wide wide(Wide::Batch::load_aligned(around.data() + i));
    Wide angle;
    if (small) {
      const Wide t = high / wide;
      angle = Wide(0.5) - t * small_arc_tangent_ratio(t) * half_turns;
    } else {
      angle = atan2(wide, high) * half_turns;
    }
    angle.batch().store_unaligned(block.exact.data() + i);
  }
}

/// The cosine and the sine of up to an eighth of a turn.
inline void exact_cosine(Block& block) {
  fill_exact(block, [](const Wide& x) { return on_circle_eighth(x).cosine; });
}
inline void exact_sine(Block& block) {
  fill_exact(block, [](const Wide& x) { return on_circle_eighth(x).sine; });
}

/// 255 times the sRGB curve of light from 0 to 1.
inline void exact_srgb_level(Block& block) {
  if (block.x.back() <= 0.0031308F) {
    fill_exact(block, [](const Wide& light) { return light * Wide(255 * 12.92); });
    return;
  }
  fill_exact(block, [](const Wide& light) {
    const Wide power = exp(log1p(light - Wide(1)) * Wide(5. / 12));
    return select(light <= Wide(0.0031308), light * Wide(255 * 12.92),
                  Wide(255) * (Wide(1.055) * power - Wide(0.055)));
  });
}

/// The byte of that level.
inline void exact_srgb_byte(Block& block) {
  exact_srgb_level(block);
  for (double& level : block.exact) level = std::floor(level + 0.5);
}

/// The light of an encoded channel from 0 to 1.
inline void exact_srgb_decode(Block& block) {
  if (block.x.back() <= 0.04045F) {
    fill_exact(block, [](const Wide& encoded) { return encoded / Wide(12.92); });
    return;
  }
  fill_exact(block, [](const Wide& encoded) {
    const Wide power = exp(log1p((encoded - Wide(1)) / Wide(1.055)) * Wide(2.4));
    return select(encoded <= Wide(0.04045), encoded / Wide(12.92), power);
  });
}

/// (1 - w)^n for w from 0 to 1.
inline void exact_power(Block& block, double n) {
  const double least = n * static_cast<double>(block.x.front());
  const double most = n * static_cast<double>(block.x.back());
  if (most < 0x1p-27) {  // the next term is below 2^-55
    fill_exact(block, [n](const Wide& w) { return Wide(1) - Wide(n) * w; });
  } else if (least > 60) {
    block.exact.fill(0);
  } else {
    fill_exact(block, [n](const Wide& w) {
      return select(w < Wide(1), exp(Wide(n) * log1p(-w)), Wide(0));
    });
  }
}

}  // namespace texmap::test
