// A map of the Earth, painted over real coastlines.
#pragma once
#include <filesystem>

#include "image.hpp"

namespace texmap {

/// The Earth as an equirectangular map of 2048 x 1024 pixels.
///
/// Column 0 is longitude -180, column 2047 is longitude 180, the same meridian and so the same pixels; row 0 is latitude 90,
/// row 1023 is latitude -90. A pixel is sea exactly if its blue exceeds its red by more than 20.
///
/// @param land  the TopoJSON file of land areas that lies in assets/sources
/// Errors: std::runtime_error with the path in it, if the file cannot be read.
[[nodiscard]] Image make_earth(const std::filesystem::path& land);

}  // namespace texmap
