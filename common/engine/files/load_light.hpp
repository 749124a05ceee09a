// From the name of a PNG, JPEG or Radiance .hdr file to light.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/files/file_error.hpp"
#include "texture/light_image.hpp"

namespace texmap {

/// The most texels of a picture of light: 4096 x 2048.
inline constexpr std::uint64_t max_light_texels = std::uint64_t{1} << 23;

/// The light in a file; its content decides its kind. Bytes of PNG and JPEG files are decoded by
/// the sRGB curve, so theirs is at most 1.
///
/// @param path  a regular file of 1 byte to 64 MiB with at most max_light_texels pixels
/// @param note  if there, gets what decode_image or read_hdr says
/// Errors: FileError `cannot load texture 'F': why`, never a part of a picture; std::bad_alloc.
[[nodiscard]] LightImage load_light(const std::filesystem::path& path, std::string* note = nullptr);

}  // namespace texmap
