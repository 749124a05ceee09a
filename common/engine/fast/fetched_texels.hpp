// Texels for packs with gather instructions.
#pragma once
#include "number/kinds/fetch.hpp"
#include "texture/light_texture.hpp"

namespace texmap {

/// The bytes of all lanes' texels: red in the lowest bits, then green and blue. It reads four bytes
/// a texel, at the last texel from one byte before, to stay inside the image.
template <class Real>
[[nodiscard]] UInt<Real> fetch_texels(const Image& image, const TexelPlace<Real>& place) {
  using Integers = UInt<Real>;
  const auto size = static_cast<std::uint32_t>(image.pixels.size());
  const Rgb8& first = image.pixels.front();
  if (size == 1) {
    return Integers(std::uint32_t{first.r} | std::uint32_t{first.g} << 8 |
                    std::uint32_t{first.b} << 16);
  }
  const Integers texel = uint_from_real(place.row) * static_cast<std::uint32_t>(image.width) +
                         uint_from_real(place.column);
  const Integers offset = texel * 3U;
  const Integers last = 3 * size - 4;
  const Integers four =
      fetch_four_bytes<Real, 1>(&first.r, select_less(last, offset, last, offset));
  return select_less(last, offset, four >> 8, four);
}

/// texel_color for all lanes at once.
template <class Real>
requires can_fetch<Real>
[[nodiscard]] Color<Real> texel_color(const ImageTexture& texture, const TexelPlace<Real>& place) {
  const UInt<Real> bytes = fetch_texels(texture.image, place);
  const auto channel = [](const UInt<Real>& byte) {
    return real_from_uint<Real>(byte & 255U) / Real(255);
  };
  return {channel(bytes), channel(bytes >> 8), channel(bytes >> 16)};
}
template <class Real>
requires can_fetch<Real>
[[nodiscard]] Color<Real> texel_color(const LightTexture& texture, const TexelPlace<Real>& place) {
  const UInt<Real> bytes = fetch_texels(texture.image, place);
  const Scalar<Real>* const levels = light_of_bytes<Scalar<Real>>(texture.light).data();
  return {fetch_of_256<Real>(levels, bytes), fetch_of_256<Real>(levels, bytes >> 8),
          fetch_of_256<Real>(levels, bytes >> 16)};
}

}  // namespace texmap
