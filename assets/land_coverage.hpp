// How much of every pixel of an equirectangular map is land, from coastlines.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace texmap {

/// Samples along one side of a pixel; a pixel has this number squared.
inline constexpr int samples_along_side = 4;

/// Counts the samples on land in every pixel.
///
/// @param topology  a TopoJSON file (quantised) with an object "land" of rings of longitudes and latitudes in degrees
/// @param columns   columns round the globe: the centre of column i lies at longitude -180 + 360 i / columns degrees
/// @param rows      the centre of row j lies at latitude 90 - 180 j / (rows - 1) degrees
/// @return          row by row from the north, 0 to 16 in each pixel
/// Errors: std::runtime_error with the path in it, if the file cannot be read or is something else.
[[nodiscard]] std::vector<std::uint8_t> land_coverage(const std::filesystem::path& topology, int columns, int rows);

}  // namespace texmap
