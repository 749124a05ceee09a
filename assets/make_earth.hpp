// A map of the Earth with real coastlines and painted colors.
#pragma once
#include <filesystem>

#include "texture/image.hpp"

namespace texmap {

/// The Earth as an equirectangular map of 2048 x 1024 pixels.
///
/// Longitude -180 to 180 from column 0 to 2047, the same meridian with the same pixels; latitude 90
/// to -90 from row 0 to 1023. A pixel is sea exactly if its blue exceeds its red by more than 20.
/// @param land  the TopoJSON file of land areas in assets/sources; climate.txt lies next to it
/// Errors: std::runtime_error with the path if the file cannot be read.
[[nodiscard]] Image make_earth(const std::filesystem::path& land);

/// The painted relief from which make_earth shades its mountains, as grays: 1024 x 512 pixels, each
/// the mean of 2 x 2 pixels of the Earth's. Sea is 0. No height is measured.
[[nodiscard]] Image make_earth_relief(const std::filesystem::path& land);

}  // namespace texmap
