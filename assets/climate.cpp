// Belts of latitude, and the patches with their sum.
#include "climate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <span>
#include <stdexcept>

#include "noise.hpp"

namespace texmap {
namespace {

double total_at(const std::vector<ClimatePatch>& patches, double longitude, double latitude) {
  double total = 0;
  for (const ClimatePatch& patch : patches) {
    double east = std::abs(longitude - patch.longitude);
    east = std::min(east, 360 - east) / patch.reach_east;
    const double north = (latitude - patch.latitude) / patch.reach_north;
    const double fade = std::max(0.0, 1 - east * east - north * north);
    total += patch.amount * smooth_step(1.15 * fade);
  }
  return total;
}

/// Linear interpolation between knots 10 degrees apart, from the equator to a pole.
double by_latitude(std::span<const double, 10> knots, double latitude) {
  const double place = std::abs(latitude) / 10;
  const double below = std::min(std::floor(place), 8.0);
  const auto knot = static_cast<std::size_t>(below);
  return mix(knots[knot], knots[knot + 1], place - below);
}

// Every 10 degrees from the equator.
constexpr double moisture_belts[10] = {0.85, 0.62, 0.45, 0.5, 0.62, 0.75, 0.78, 0.7, 0.6, 0.6};
constexpr double warmth_belts[10] = {1.0, 1.0, 0.95, 0.82, 0.66, 0.5, 0.34, 0.16, 0.05, 0.0};

}  // namespace

ClimateMap::ClimateMap(const std::filesystem::path& patches) {
  std::ifstream file(patches);
  std::string head, kind, place;
  if (!std::getline(file, head)) throw std::runtime_error("cannot read " + patches.string());
  for (ClimatePatch p;
       file >> kind >> p.longitude >> p.latitude >> p.reach_east >> p.reach_north >> p.amount &&
       std::getline(file, place);)
    patches_[kind].push_back(p);
}

Climate ClimateMap::at(double longitude, double latitude) const {
  const auto total = [&](const char* kind) {
    return total_at(patches_.at(kind), longitude, latitude);
  };
  Climate climate;
  climate.moisture = by_latitude(moisture_belts, latitude) + total("wet") - total("dry");
  climate.warmth = by_latitude(warmth_belts, latitude);
  climate.height = total("high");
  climate.ice = latitude < -60 ? 2 : total("ice");
  return climate;
}

}  // namespace texmap
