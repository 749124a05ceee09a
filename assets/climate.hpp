// Where the Earth is dry, wet, high and icy: belts of latitude plus hand-made patches.
#pragma once

namespace texmap {

/// The climate at one point.
struct Climate {
  double moisture = 0;  // 0 desert to 1 rain forest
  double warmth = 0;    // 0 polar to 1 tropical, at sea level
  double height = 0;    // 0 plain to 1 Tibet
  double ice = 0;       // above 0.5 an ice sheet
};

/// @param longitude  degrees, -180 to 180
/// @param latitude   degrees, -90 to 90
[[nodiscard]] Climate climate_at(double longitude, double latitude);

}  // namespace texmap
