// How much of each pixel of an equirectangular map is land, from coastlines.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace texmap {

/// Samples along one side of a pixel; a pixel has the square of this number.
inline constexpr int samples_along_side = 4;

/// Counts the samples on land in each pixel.
/// @param topology  a quantized TopoJSON file with an object "land": rings in degrees
/// @param columns   the center of column i has the longitude -180 + 360 i / columns degrees
/// @param rows      the center of row j has the latitude 90 - 180 j / (rows - 1) degrees
/// @return          row by row from the north, 0 to 16 in each pixel
/// Errors: std::runtime_error with the path if the file cannot be read or is something else.
[[nodiscard]] std::vector<std::uint8_t> land_coverage(const std::filesystem::path& topology,
                                                      int columns, int rows);

}  // namespace texmap
