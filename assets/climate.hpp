// Where the Earth is dry, wet, high and icy: belts of latitude plus hand-made patches.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace texmap {

/// The climate at one point.
struct Climate {
  double moisture = 0;  // 0 desert to 1 rain forest
  double warmth = 0;    // 0 polar to 1 tropical, at sea level
  double height = 0;    // 0 plain to 1 Tibet
  double ice = 0;       // above 0.5 an ice sheet
};

/// An ellipse in degrees: full amount in the middle, 0 at its edge.
struct ClimatePatch {
  double longitude = 0, latitude = 0;
  double reach_east = 0, reach_north = 0;
  double amount = 0;
};

/// The climate everywhere.
class ClimateMap {
 public:
  /// @param patches  a file with a head, then a line for each patch: dry, wet, high or ice, the
  ///                 numbers of a ClimatePatch and its place
  /// Errors: std::runtime_error with the path if the file cannot be read.
  explicit ClimateMap(const std::filesystem::path& patches);

  /// @param longitude  degrees, -180 to 180
  /// @param latitude   degrees, -90 to 90
  [[nodiscard]] Climate at(double longitude, double latitude) const;

 private:
  std::map<std::string, std::vector<ClimatePatch>> patches_;  // by kind
};

}  // namespace texmap
