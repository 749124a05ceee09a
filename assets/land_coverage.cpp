// Rasterizes coastlines along meridians, starting at the north pole, which is sea: each coast that
// a meridian crosses switches between land and sea. Rings around a pole or across longitude 180
// need no special case then; along parallels they would.
#include "land_coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace texmap {
namespace {

using Json = nlohmann::json;

/// Sample k is k - center samples away from the center of the first pixel.
constexpr double center = (samples_along_side - 1) / 2.0;

/// A point of a coast, in turns east of longitude -180 and in degrees north.
struct CoastPoint {
  double turns = 0;
  double latitude = 0;
};
using Coast = std::vector<CoastPoint>;

/// The arcs of a topology. Each is a grid point and then differences from point to point; the
/// transform converts grid coordinates to degrees.
std::vector<Coast> arcs_of(const Json& topology) {
  const auto scale = topology.at("transform").at("scale").get<std::array<double, 2>>();
  const auto origin = topology.at("transform").at("translate").get<std::array<double, 2>>();
  std::vector<Coast> arcs;
  for (const Json& deltas : topology.at("arcs")) {
    Coast& arc = arcs.emplace_back();
    std::array<int, 2> place = {0, 0};
    for (const Json& delta : deltas) {
      place[0] += delta.at(0).get<int>();
      place[1] += delta.at(1).get<int>();
      arc.push_back(
          {(place[0] * scale[0] + origin[0] + 180) / 360, place[1] * scale[1] + origin[1]});
    }
  }
  return arcs;
}

/// A ring is a list of arcs; ~n means arc n backwards.
Coast ring_of(const Json& arc_numbers, const std::vector<Coast>& arcs) {
  Coast ring;
  for (const Json& number : arc_numbers) {
    const int n = number.get<int>();
    Coast arc = arcs.at(static_cast<std::size_t>(n < 0 ? ~n : n));
    if (n < 0) std::reverse(arc.begin(), arc.end());
    ring.insert(ring.end(), arc.begin(), arc.end());
  }
  return ring;
}

/// The rings of all land. A tiny ring around the south pole only closes the data's grid; it is not
/// a coast.
std::vector<Coast> rings_of(const Json& topology) {
  const std::vector<Coast> arcs = arcs_of(topology);
  std::vector<Coast> rings;
  for (const Json& part : topology.at("objects").at("land").at("geometries")) {
    for (const Json& polygon : part.at("arcs")) {
      for (const Json& arc_numbers : polygon) {
        Coast ring = ring_of(arc_numbers, arcs);
        if (std::any_of(ring.begin(), ring.end(), [](CoastPoint p) { return p.latitude > -89.99; }))
          rings.push_back(std::move(ring));
      }
    }
  }
  return rings;
}

/// The latitudes where coasts cross each meridian. A meridian is one column of samples.
using Crossings = std::vector<std::vector<double>>;

/// Adds the crossings of a coast from point to point.
void add_edge(Crossings& crossings, CoastPoint a, CoastPoint b) {
  // The short way around: two neighboring points of a coast are never half the globe apart.
  if (b.turns - a.turns > 0.5) b.turns -= 1;
  if (a.turns - b.turns > 0.5) b.turns += 1;
  if (a.turns > b.turns) std::swap(a, b);

  // An edge contains its west end but not its east end, so a meridian through a point that two
  // edges share is crossed once.
  const auto count = static_cast<double>(crossings.size());
  const double west = a.turns * count + center, east = b.turns * count + center;
  const auto last = static_cast<long>(std::ceil(east));
  for (auto meridian = static_cast<long>(std::ceil(west)); meridian < last; ++meridian) {
    const auto k = static_cast<double>(meridian);
    const double latitude = a.latitude + (b.latitude - a.latitude) * ((k - west) / (east - west));
    const double wrapped = k - std::floor(k / count) * count;
    crossings[static_cast<std::size_t>(wrapped)].push_back(latitude);
  }
}

Json read(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return Json::parse(file);
}

}  // namespace

std::vector<std::uint8_t> land_coverage(const std::filesystem::path& topology, int columns,
                                        int rows) try {
  const int meridians = columns * samples_along_side;
  Crossings crossings(static_cast<std::size_t>(meridians));
  for (const Coast& ring : rings_of(read(topology))) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      add_edge(crossings, ring[i], ring[(i + 1) % ring.size()]);
  }

  std::vector<std::uint8_t> coverage(static_cast<std::size_t>(columns) *
                                     static_cast<std::size_t>(rows));
  for (int k = 0; k < meridians; ++k) {
    std::vector<double>& coasts = crossings[static_cast<std::size_t>(k)];
    std::sort(coasts.rbegin(), coasts.rend());
    std::size_t crossed = 0;
    for (int m = 0; m < rows * samples_along_side; ++m) {
      const double row = (m - center) / samples_along_side;
      const double latitude = 90 - 180 * row / (rows - 1);
      while (crossed < coasts.size() && coasts[crossed] > latitude) ++crossed;
      const int pixel = m / samples_along_side * columns + k / samples_along_side;
      if (crossed % 2 == 1) ++coverage[static_cast<std::size_t>(pixel)];
    }
  }
  return coverage;
} catch (const nlohmann::json::exception& error) {
  throw std::runtime_error(topology.string() + " is not a topology of land: " + error.what());
}

}  // namespace texmap
