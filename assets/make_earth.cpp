// Paints the Earth: coverage of land, distances to the coast, relief, then a color for each pixel.
#include "make_earth.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "climate.hpp"
#include "globe_grid.hpp"
#include "land_coverage.hpp"
#include "noise.hpp"
#include "paint.hpp"

namespace texmap {
namespace {

constexpr int width = 2048;
constexpr int height = 1024;
constexpr double levels_of_highest_relief = 230;
constexpr int samples = samples_along_side * samples_along_side;

/// Blue exceeds red by at most 20 on land and by more at sea; both keep a margin to the limit.
constexpr double most_blue_on_land = 16;
constexpr double least_blue_at_sea = 26;

constexpr Paint desert{226, 200, 148};
constexpr Paint red_desert{208, 160, 110};
constexpr Paint savanna{172, 166, 98};
constexpr Paint grassland{138, 154, 88};
constexpr Paint broadleaf{92, 132, 70};
constexpr Paint rain_forest{46, 100, 50};
constexpr Paint boreal{70, 106, 72};
constexpr Paint tundra{156, 156, 128};
constexpr Paint rock{146, 126, 104};
constexpr Paint snow{240, 243, 246};
constexpr Paint ice_sheet{232, 240, 246};

constexpr Paint shelf{118, 182, 208};
constexpr Paint slope{62, 134, 184};
constexpr Paint deep{28, 82, 144};
constexpr Paint abyss{20, 64, 122};
constexpr Paint polar_sea{150, 186, 208};

double noise_at(SpherePoint p, double frequency, int octaves, double offset) {
  return layered_noise(p.x * frequency + offset, p.y * frequency + offset, p.z * frequency + offset,
                       octaves);
}

/// A distance in kilometres, rounded to invisible steps: runs of equal pixels compress better.
double in_steps(double kilometres) {
  constexpr double middle = 600, steps = 80;
  const double step = std::floor(kilometres / (kilometres + middle) * steps);
  return middle * step / (steps - step);
}

/// The sea gets deeper away from the coast, with swells and a paler surface near the poles.
Paint sea_color(SpherePoint p, double latitude, double coast_km) {
  const double swell = 1 + 0.35 * noise_at(p, 7, 4, 40);
  const double depth = in_steps(coast_km * swell);
  Paint color = mix(shelf, slope, smooth_step(depth / 130));
  color = mix(color, deep, smooth_step((depth - 40) / 620));
  color = mix(color, abyss, smooth_step((depth - 500) / 1800));
  const double floe = std::abs(latitude) + 5 * noise_at(p, 9, 4, 60);
  const double cold = latitude > 0 ? smooth_step((floe - 74) / 14) : smooth_step((floe - 62) / 16);
  return mix(color, polar_sea, 0.8 * std::floor(cold * 24 + 0.5) / 24);
}

/// The color of the land before shading.
Paint land_color(SpherePoint p, const Climate& climate, double relief, double coast_km) {
  const double patchy = noise_at(p, 26, 4, 80);
  const double wet = climate.moisture + 0.22 * patchy;
  const double warm = climate.warmth - 0.3 * relief + 0.05 * patchy;

  // From dry to wet, in the warm belts and in the temperate ones.
  const Paint sand = mix(desert, red_desert, smooth_step(0.5 + 1.4 * noise_at(p, 6, 3, 100)));
  Paint warm_color = mix(sand, savanna, smooth_step((wet - 0.05) / 0.4));
  warm_color = mix(warm_color, broadleaf, smooth_step((wet - 0.42) / 0.34));
  warm_color = mix(warm_color, rain_forest, smooth_step((wet - 0.68) / 0.36));
  Paint mild_color = mix(desert, grassland, smooth_step((wet - 0.02) / 0.5));
  mild_color = mix(mild_color, broadleaf, smooth_step((wet - 0.46) / 0.34));

  // From the equator to the pole.
  Paint color = mix(mild_color, warm_color, smooth_step((warm - 0.62) / 0.2));
  color = mix(mix(color, boreal, smooth_step((wet - 0.2) / 0.4)), color,
              smooth_step((warm - 0.33) / 0.16));
  color = mix(tundra, color, smooth_step((warm - 0.08) / 0.2));

  // Rock and snow on the heights; an ice sheet leaves a strip along the coast bare.
  color = mix(color, rock, 0.75 * smooth_step((relief - 0.35) / 0.5));
  const double snow_line = 0.26 + 0.58 * climate.warmth;
  color = mix(color, snow, 0.9 * smooth_step((relief - snow_line) / 0.35));
  color = mix(color, snow, 0.8 * smooth_step((0.1 - warm) / 0.16));
  const double margin =
      climate.warmth > 0.12 ? 60 : 25;  // kilometres of bare coast; less near the poles
  const double sheet =
      climate.ice > 1.9 ? 1 : smooth_step((climate.ice - 0.25 + 0.3 * patchy) / 0.3);
  const double bare = climate.ice > 1.999 ? 1 : smooth_step((coast_km + 20 * patchy) / margin);
  const Paint sheet_color = scaled(ice_sheet, 1 + 0.02 * noise_at(p, 10, 2, 120));
  return mix(color, sheet_color, sheet * bare);
}

/// Enforces the rule that separates land from sea, moving blue and red by equal amounts.
Paint kept_apart(Paint p, bool land) {
  const double excess = p.b - p.r;
  const double move = land ? std::max(0.0, excess - most_blue_on_land) / 2
                           : std::min(0.0, excess - least_blue_at_sea) / 2;
  return {p.r + move, p.g, p.b - move};
}

/// Rounds land to steps of 3, for the reason of in_steps. The rule for land and sea still holds.
Rgb8 coarsely_rounded(Paint p) {
  const auto channel = [](double value) { return 3 * std::floor(value / 3 + 0.5); };
  return rounded({channel(p.r), channel(p.g), channel(p.b)});
}

/// What is computed for the whole globe before the first pixel is painted.
struct Survey {
  std::vector<std::uint8_t> coverage;
  std::vector<bool> land;
  std::vector<double> coast_km;
  std::vector<double> relief;
  std::vector<Climate> climate;
};

Survey survey(const GlobeGrid& grid, const std::filesystem::path& topology) {
  Survey s;
  s.coverage = land_coverage(topology, grid.columns(), grid.rows());
  for (const std::uint8_t count : s.coverage) s.land.push_back(2 * count >= samples);
  s.coast_km = grid.distance_to_other(s.land);
  const ClimateMap climates(topology.parent_path() / "climate.txt");
  s.relief.resize(grid.size());
  s.climate.resize(grid.size());
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const std::size_t i = grid.place(column, row);
      if (s.coverage[i] == 0) continue;
      const SpherePoint p = grid.point(column, row);

      // The patches are ellipses: noise bends their edges.
      const double east = grid.longitude(column) + 7 * noise_at(p, 11, 4, 0);
      const double north =
          std::clamp(grid.latitude(row) + 4.5 * noise_at(p, 11, 4, 20), -90.0, 90.0);
      s.climate[i] = climates.at(east > 180 ? east - 360 : east < -180 ? east + 360 : east, north);
      if (grid.latitude(row) < -60) s.climate[i].ice = 2;

      // Ridges where the noise is near zero.
      const double ridge = 1 - 2.4 * std::abs(noise_at(p, 30, 4, 140));
      const double rolling = 0.5 + 0.5 * noise_at(p, 48, 2, 160);
      const double near_coast = smooth_step(s.coast_km[i] / 80);
      s.relief[i] =
          (s.climate[i].height * (0.5 + 0.5 * ridge) + 0.05 * rolling) * (0.3 + 0.7 * near_coast);
    }
  }
  return s;
}

/// Light from the north-west on the relief, about 1.
double hill_shade(const GlobeGrid& grid, const std::vector<double>& relief, int column, int row) {
  if (row == 0 || row == grid.rows() - 1) return 1;
  const double to_east = relief[grid.place(column + 1, row)] - relief[grid.place(column - 1, row)];
  const double to_south = relief[grid.place(column, row + 1)] - relief[grid.place(column, row - 1)];
  return std::clamp(1 + 1.1 * (to_east / std::max(grid.cosine_of_latitude(row), 0.3) + to_south),
                    0.72, 1.2);
}

}  // namespace

Image make_earth(const std::filesystem::path& land) {
  const GlobeGrid grid(width - 1, height);
  const Survey s = survey(grid, land);
  Image image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const std::size_t i = grid.place(column, row);
      const SpherePoint p = grid.point(column, row);
      const double share = static_cast<double>(s.coverage[i]) / samples;
      Paint color;
      if (share < 1) color = sea_color(p, grid.latitude(row), s.land[i] ? 0 : s.coast_km[i]);
      if (share > 0) {
        const Paint cover = land_color(p, s.climate[i], s.relief[i], s.land[i] ? s.coast_km[i] : 0);
        color = mix(color, scaled(cover, hill_shade(grid, s.relief, column, row)), share);
      }
      color = kept_apart(color, s.land[i]);
      image.at(column, row) = s.land[i] ? coarsely_rounded(color) : rounded(color);
    }
    image.at(width - 1, row) = image.at(0, row);
  }
  return image;
}

Image make_earth_relief(const std::filesystem::path& land) {
  const GlobeGrid grid(width - 1, height);
  const Survey s = survey(grid, land);
  Image image(width / 2, height / 2);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      double sum = 0;
      for (const int j : {2 * row, 2 * row + 1}) {
        for (const int i : {2 * column, 2 * column + 1}) {
          const std::size_t place = grid.place(i % grid.columns(), j);
          sum += s.land[place] ? std::max(s.relief[place], 0.0) : 0;
        }
      }
      const double level = sum / 4 * levels_of_highest_relief;
      image.at(column, row) = rounded({level, level, level});
    }
  }
  return image;
}

}  // namespace texmap
