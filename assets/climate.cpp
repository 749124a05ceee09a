// The patches and their sum.
#include "climate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "noise.hpp"

namespace texmap {
namespace {

/// An ellipse in degrees: full amount in the middle, 0 at its edge.
struct Patch {
  double longitude = 0, latitude = 0;
  double reach_east = 0, reach_north = 0;
  double amount = 0;
};

constexpr Patch dry_patches[] = {
    {-6, 23, 24, 13, 1.3},       // western Sahara
    {20, 23, 26, 13, 1.3},       // eastern Sahara
    {47, 23, 15, 14, 1.0},       // Arabia
    {58, 32, 14, 9, 0.9},        // Iran
    {60, 43, 22, 9, 0.6},        // Karakum and the Kazakh steppe
    {71, 27, 8, 8, 0.7},         // Thar
    {83, 39.5, 13, 6, 1.1},      // Taklamakan
    {104, 42.5, 17, 7, 0.9},     // Gobi
    {88, 33.5, 15, 6, 0.6},      // Tibet
    {46, 6, 9, 10, 0.6},         // Horn of Africa
    {19, -24, 12, 13, 0.75},     // Kalahari and Namib
    {131, -25, 24, 12, 1.0},     // central Australia
    {119, -25, 12, 10, 0.6},     // western Australia
    {-113, 33, 11, 11, 0.9},     // Mojave and Sonora
    {-103, 28, 8, 9, 0.6},       // Chihuahua
    {-117, 41, 7, 7, 0.6},       // Great Basin
    {-103, 41, 9, 13, 0.4},      // High Plains
    {-68, -45, 7, 12, 0.8},      // Patagonia
    {-70.5, -22, 4.5, 14, 1.2},  // Atacama
    {-41, -9, 8, 8, 0.4},        // north-east of Brazil
    {-3, 39, 6, 4, 0.25},        // Spain
    {34, 38.5, 9, 4, 0.3},       // Anatolia
    {46, -22.5, 4, 6, 0.3},      // south of Madagascar
};

constexpr Patch wet_patches[] = {
    {-62, -4, 19, 13, 0.5},    // Amazon
    {21, 0, 14, 8, 0.5},       // Congo
    {-8, 6, 14, 5, 0.4},       // Guinea
    {114, 0, 34, 12, 0.5},     // Malay archipelago
    {145, -6, 12, 7, 0.4},     // New Guinea
    {102, 16, 14, 14, 0.5},    // Indochina
    {86, 24, 12, 8, 0.35},     // Ganges and Bengal
    {76, 13, 5, 9, 0.3},       // Malabar coast
    {81, 8, 4, 4, 0.4},        // Ceylon
    {112, 27, 16, 10, 0.55},   // southern China
    {136, 36, 9, 9, 0.4},      // Japan
    {-85, 34, 15, 10, 0.5},    // south-east of North America
    {-86, 14, 14, 9, 0.4},     // Central America
    {-76, 20, 12, 6, 0.4},     // Antilles
    {-52, -25, 11, 11, 0.45},  // Paraná
    {49, -18, 4, 8, 0.5},      // east of Madagascar
    {151, -30, 6, 12, 0.45},   // eastern Australia
    {172, -42, 9, 9, 0.35},    // New Zealand
    {8, 50, 20, 9, 0.2},       // western Europe
    {-124, 50, 8, 12, 0.4},    // Pacific coast of North America
    {-73, -45, 3.5, 12, 0.5},  // southern Chile
};

constexpr Patch high_patches[] = {
    {87, 33, 19, 8.5, 1.0},       // Tibet and Himalaya
    {71, 36, 9, 6, 0.7},          // Hindu Kush and Pamirs
    {79, 42, 14, 4, 0.7},         // Tian Shan
    {92, 49, 14, 6, 0.55},        // Altai
    {101, 29, 5, 6, 0.7},         // western China
    {-76, -2, 5, 15, 0.75},       // northern Andes
    {-68, -18, 5, 9, 1.0},        // Altiplano
    {-70.5, -33, 3.2, 15, 0.9},   // southern Andes
    {-111, 43, 10, 14, 0.65},     // Rocky Mountains
    {-123, 56, 10, 11, 0.55},     // mountains of British Columbia
    {-149, 62.5, 13, 3.5, 0.6},   // Alaska Range
    {-104, 24, 4.5, 8, 0.5},      // Sierra Madre
    {10, 46.5, 8, 2.8, 0.8},      // Alps
    {44, 42.7, 7, 2.2, 0.75},     // Caucasus
    {50, 33, 7, 6, 0.5},          // Zagros
    {39, 9, 5.5, 6.5, 0.6},       // Ethiopia
    {34, -4, 5, 10, 0.4},         // East Africa
    {-3, 33, 8, 2.4, 0.5},        // Atlas
    {59.5, 59, 4, 13, 0.4},       // Urals
    {13, 64, 6, 7, 0.45},         // Scandinavia
    {139.5, -4.7, 8, 2.2, 0.7},   // New Guinea
    {140, 66, 24, 8, 0.42},       // eastern Siberia
    {29, -29, 3, 4, 0.45},        // Drakensberg
    {170, -43.6, 3, 2.2, 0.65},   // Southern Alps
    {137.5, 36, 2.2, 2, 0.45},    // Japan
    {149, -36.5, 2.5, 3.5, 0.3},  // Snowy Mountains
};

constexpr Patch ice_patches[] = {
    {-41, 76, 27, 9, 2.0},      // northern Greenland
    {-41, 70, 14, 10, 2.0},     // middle Greenland
    {-45, 63, 6, 7, 2.0},       // southern Greenland
    {-78, 80.5, 14, 4, 1.0},    // Ellesmere Island
    {-92, 80, 6, 1.8, 0.8},     // Axel Heiberg Island
    {18, 79, 14, 2.4, 1.0},     // Svalbard
    {61, 76, 7, 2, 1.1},        // Novaya Zemlya
    {97, 80, 12, 2.4, 1.1},     // Severnaya Zemlya
    {55, 81, 14, 2, 1.1},       // Franz Josef Land
    {-17, 64.4, 2, 0.7, 1.2},   // Vatnajökull
    {-73.5, -48.5, 1, 3, 1.1},  // Patagonian ice field
};

double total_at(std::span<const Patch> patches, double longitude, double latitude) {
  double total = 0;
  for (const Patch& patch : patches) {
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

Climate climate_at(double longitude, double latitude) {
  Climate climate;
  climate.moisture = by_latitude(moisture_belts, latitude) +
                     total_at(wet_patches, longitude, latitude) -
                     total_at(dry_patches, longitude, latitude);
  climate.warmth = by_latitude(warmth_belts, latitude);
  climate.height = total_at(high_patches, longitude, latitude);
  climate.ice = latitude < -60 ? 2 : total_at(ice_patches, longitude, latitude);
  return climate;
}

}  // namespace texmap
