// From the bytes of a Radiance .hdr file to light.
#pragma once
#include <cstdint>

#include "engine/files/bytes.hpp"
#include "texture/light_image.hpp"

namespace texmap {

[[nodiscard]] bool looks_like_hdr(Bytes file);

/// The brightest light that a file may hold; the noon sun has 2e9 of a lamp's units.
inline constexpr double brightest_texel = 1e12;

/// The light in a Radiance file that looks_like_hdr, divided by its EXPOSURE and COLORCORR. Texels
/// are the middles of their steps; a byte 0 has no light.
///
/// @param most_texels  more are refused before any is decoded; `note` gets words about the colors
/// Errors: FileError unless the picture is whole and RGBE; std::bad_alloc.
/// Source: Ward, "Real Pixels", Graphics Gems II (1991); Radiance's color.c.
[[nodiscard]] LightImage read_hdr(Bytes file, std::uint64_t most_texels,
                                  std::string* note = nullptr);

}  // namespace texmap
