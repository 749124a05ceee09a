// A sky with a sun, clouds, hills and a meadow, as light.
#pragma once
#include <cstdint>
#include <vector>

#include "texture/light_image.hpp"

namespace texmap {

/// The sky, 384 x 192 texels. The sun is 33 degrees high, behind the reader's left shoulder, 2.8
/// degrees wide and up to 900 times as bright as white.
[[nodiscard]] LightImage make_sky();

/// The bytes of a Radiance file with that light, by stb_image_write, which cuts mantissas off as
/// all writers do.
[[nodiscard]] std::vector<std::uint8_t> radiance_file(const LightImage& light);

}  // namespace texmap
