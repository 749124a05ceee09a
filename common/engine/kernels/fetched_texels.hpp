// Texels for packs with gather instructions.
#pragma once
#include "number/kinds/fetch.hpp"
#include "texture/image_texture.hpp"

namespace texmap {

/// texel_color for all lanes at once. It reads four bytes a texel, at the last texel from one byte
/// before, to stay inside the image. Images of one texel use the general version.
template <class Real>
requires can_fetch<Real>
[[nodiscard]] Color<Real> texel_color(const ImageTexture& texture, const TexelPlace<Real>& place) {
  const auto size = static_cast<std::uint32_t>(texture.image.pixels.size());
  const Scalar<Real>* const levels = light_of_bytes<Scalar<Real>>(texture.light).data();
  const auto* const bytes_of_picture = &texture.image.pixels.data()->r;
  if (size == 1) {
    return {Real(levels[bytes_of_picture[0]]), Real(levels[bytes_of_picture[1]]),
            Real(levels[bytes_of_picture[2]])};
  }
  using Integers = UInt<Real>;
  const Integers texel =
      uint_from_real(place.row) * static_cast<std::uint32_t>(texture.image.width) +
      uint_from_real(place.column);
  const Integers offset = texel * 3U;
  const Integers last = 3 * size - 4;
  const Integers four =
      fetch_four_bytes<Real, 1>(bytes_of_picture, select_less(last, offset, last, offset));
  const Integers bytes = select_less(last, offset, four >> 8, four);
  return {fetch<Real>(levels, bytes & 255U), fetch<Real>(levels, (bytes >> 8) & 255U),
          fetch<Real>(levels, (bytes >> 16) & 255U)};
}

}  // namespace texmap
