// The pictures in assets/: certain places show what they must, and the files are those checked.
#include <doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "../support/sha256.hpp"
#include "engine/picture/load_image.hpp"
#include "support/shown_values.hpp"

namespace {

using texmap::Image;
using texmap::Rgb8;

Image asset(const std::string& name) {
  return texmap::load_image(std::string(TEXMAP_ASSETS_DIR) + "/" + name);
}

/// The rule of assets/README.md by which land and sea can be told apart.
bool is_sea(Rgb8 pixel) { return pixel.b > pixel.r + 20; }

struct Place {
  const char* name;
  double longitude, latitude;  // degrees
  bool sea;
};

constexpr Place places[] = {
    {"Paris", 2.35, 48.86, false},
    {"Nairobi", 36.82, -1.29, false},
    {"Ulaanbaatar", 106.92, 47.92, false},
    {"Alice Springs", 133.88, -23.70, false},
    {"Brasilia", -47.88, -15.79, false},
    {"Denver", -104.99, 39.74, false},
    {"Lhasa", 91.13, 29.65, false},
    {"Madagascar", 46.5, -19.0, false},
    {"Tasmania", 146.6, -42.0, false},
    {"Ceylon", 80.7, 7.5, false},
    {"Iceland", -18.5, 65.0, false},
    {"New Zealand", 171.0, -43.3, false},
    {"Central Greenland", -40.0, 72.0, false},
    {"Wrangel Island, western part", 179.3, 71.2, false},
    {"Wrangel Island, eastern part", -179.0, 71.2, false},
    {"Chukotka at the west of the antimeridian", 179.0, 68.0, false},
    {"Chukotka on the antimeridian", 180.0, 68.0, false},
    {"Chukotka on the antimeridian, the other edge", -180.0, 68.0, false},
    {"Chukotka at the east of the antimeridian", -179.0, 68.0, false},
    {"Antarctica at 179 east", 179.0, -86.0, false},
    {"Antarctica at 179 west", -179.0, -86.0, false},
    {"South Pole", 0.0, -90.0, false},
    {"South Pole, seen from the antimeridian", 180.0, -90.0, false},
    {"North Pole", 0.0, 90.0, true},
    {"North Pole, seen from the antimeridian", -180.0, 90.0, true},
    {"Null Island", 0.0, 0.0, true},
    {"Middle of the Atlantic", -35.0, 30.0, true},
    {"Middle of the Pacific", -140.0, 0.0, true},
    {"Pacific on the antimeridian", 180.0, 0.0, true},
    {"Ross Sea on the antimeridian", -180.0, -76.0, true},
    {"Tasman Sea", 160.0, -38.0, true},
    {"Bay of Bengal", 88.0, 14.0, true},
    {"Hudson Bay", -85.0, 60.0, true},
    {"Caspian Sea, which the data hold for a sea", 51.0, 42.0, true},
    {"Aral Sea, which the data hold for land", 60.0, 45.0, false},
    {"Black Sea", 34.0, 43.0, true},
    {"Red Sea", 38.0, 20.0, true},
    {"Persian Gulf", 51.0, 27.5, true},
    {"Mediterranean, south of Sicily", 14.0, 34.5, true},
    {"Drake Passage", -63.0, -59.0, true},
    {"Southern Pacific", -120.0, -45.0, true},
};

Rgb8 pixel_at(const Image& earth, double longitude, double latitude) {
  const auto column = static_cast<int>(std::lround((longitude + 180) / 360 * (earth.width - 1)));
  const auto row = static_cast<int>(std::lround((90 - latitude) / 180 * (earth.height - 1)));
  return earth.at(column, row);
}

int places_where_the_map_is_wrong(const Image& earth) {
  int wrong = 0;
  for (const Place& place : places)
    wrong += is_sea(pixel_at(earth, place.longitude, place.latitude)) != place.sea ? 1 : 0;
  return wrong;
}

Image transformed(const Image& image, bool left_right, bool top_bottom) {
  Image result(image.width, image.height);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      result.at(column, row) = image.at(left_right ? image.width - 1 - column : column,
                                        top_bottom ? image.height - 1 - row : row);
  return result;
}

double share_of_different_pixels(const Image& a, const Image& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    different += a.pixels[i] == b.pixels[i] ? 0U : 1U;
  return static_cast<double>(different) / static_cast<double>(a.pixels.size());
}

std::string sum_of_pixels(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Rgb8 pixel : image.pixels) bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
  return texmap::test::sha256(std::span<const std::uint8_t>(bytes));
}

}  // namespace

TEST_CASE("the Earth has land and sea at the places of an atlas") {
  const Image earth = asset("earth.png");
  REQUIRE(earth.width == 2048);
  REQUIRE(earth.height == 1024);
  for (const Place& place : places) {
    CAPTURE(place.name);
    CHECK(is_sea(pixel_at(earth, place.longitude, place.latitude)) == place.sea);
  }
}

TEST_CASE(
    "the places of the atlas find out an Earth that is mirrored, upside down, both, or turned by a "
    "quarter") {
  const Image earth = asset("earth.png");
  CHECK(places_where_the_map_is_wrong(earth) == 0);
  CHECK(places_where_the_map_is_wrong(transformed(earth, true, false)) >= 8);
  CHECK(places_where_the_map_is_wrong(transformed(earth, false, true)) >= 8);
  CHECK(places_where_the_map_is_wrong(transformed(earth, true, true)) >= 8);
  Image turned = earth;
  for (int row = 0; row < earth.height; ++row)
    for (int column = 0; column < earth.width; ++column)
      turned.at(column, row) = earth.at((column + earth.width / 4) % earth.width, row);
  CHECK(places_where_the_map_is_wrong(turned) >= 8);
}

TEST_CASE("land covers between 28 and 30 percent of the globe") {
  const Image earth = asset("earth.png");
  double land = 0, all = 0;
  for (int row = 0; row < earth.height; ++row) {
    const double weight =
        std::sin(3.14159265358979323846 * row / (earth.height - 1));  // cosine of the latitude
    for (int column = 0; column < earth.width - 1; ++column) {
      all += weight;
      land += is_sea(earth.at(column, row)) ? 0 : weight;
    }
  }
  INFO("land fraction ", land / all);
  CHECK(land / all > 0.28);
  CHECK(land / all < 0.30);
}

TEST_CASE("the Earth's relief is gray, flat at sea, and highest in Tibet and the Andes") {
  const Image earth = asset("earth.png");
  const Image relief = asset("earth_relief.png");
  REQUIRE(relief.width == 1024);
  REQUIRE(relief.height == 512);
  int highest = 0;
  for (int row = 0; row < relief.height; ++row) {
    for (int column = 0; column < relief.width; ++column) {
      const Rgb8 level = relief.at(column, row);
      REQUIRE((level.r == level.g && level.g == level.b));
      highest = level.r > highest ? level.r : highest;
      const bool sea = is_sea(earth.at(2 * column, 2 * row)) &&
                       is_sea(earth.at(2 * column + 1, 2 * row)) &&
                       is_sea(earth.at(2 * column, 2 * row + 1)) &&
                       is_sea(earth.at(2 * column + 1, 2 * row + 1));
      if (sea) REQUIRE(level.r == 0);
    }
  }
  CHECK(highest > 150);
  CHECK(pixel_at(relief, 88, 33).r > 60);
  CHECK(pixel_at(relief, -69, -22).r > 40);
  CHECK(pixel_at(relief, 30, 55).r < 30);
}

TEST_CASE("no pixel of the Earth leaves a doubt whether it is land or sea") {
  const Image earth = asset("earth.png");
  int doubtful = 0;
  for (const Rgb8 pixel : earth.pixels)
    doubtful += pixel.b > pixel.r + 18 && pixel.b < pixel.r + 24 ? 1 : 0;
  CHECK(doubtful == 0);
}

TEST_CASE(
    "the Earth's first and last columns are the same meridian, and its first and last rows are "
    "points") {
  const Image earth = asset("earth.png");
  for (int row = 0; row < earth.height; ++row) {
    CAPTURE(row);
    REQUIRE(earth.at(0, row) == earth.at(earth.width - 1, row));
  }
  for (int column = 0; column < earth.width; ++column) {
    CAPTURE(column);
    REQUIRE(earth.at(column, 0) == earth.at(0, 0));
    REQUIRE(earth.at(column, earth.height - 1) == earth.at(0, earth.height - 1));
  }
}

TEST_CASE(
    "the labelled map differs from its mirror images and its half-turn in at least a fifth of its "
    "pixels") {
  const Image map = asset("uv_map.png");
  REQUIRE(map.width == 1024);
  REQUIRE(map.height == 512);
  CHECK(share_of_different_pixels(map, transformed(map, false, false)) == 0);
  CHECK(share_of_different_pixels(map, transformed(map, true, false)) >= 0.2);
  CHECK(share_of_different_pixels(map, transformed(map, false, true)) >= 0.2);
  CHECK(share_of_different_pixels(map, transformed(map, true, true)) >= 0.2);
}

TEST_CASE(
    "the labelled map is blue in the north-west, yellow in the north-east, green in the "
    "south-west, pink in the south-east") {
  const Image map = asset("uv_map.png");
  const Rgb8 north_west = map.at(200, 150), north_east = map.at(712, 150);
  const Rgb8 south_west = map.at(200, 362), south_east = map.at(712, 362);
  CHECK((north_west.b > north_west.g && north_west.g > north_west.r));
  CHECK((north_east.r > north_east.g && north_east.g > north_east.b));
  CHECK((south_west.g > south_west.b && south_west.b > south_west.r));
  CHECK((south_east.r > south_east.b && south_east.b > south_east.g));
}

TEST_CASE("the pixels of every asset have the checksum that is written down for them") {
  std::ifstream list(std::string(TEXMAP_ASSETS_DIR) + "/checksums.txt");
  REQUIRE(list);
  std::string sum, size, name;
  int assets = 0;
  while (list >> sum >> size >> name) {
    CAPTURE(name);
    const Image image = asset(name);
    CHECK(std::to_string(image.width) + "x" + std::to_string(image.height) == size);
    CHECK(sum_of_pixels(image) == sum);
    Image other = image;
    other.at(image.width / 2, image.height / 2).g ^= 1;
    CHECK(sum_of_pixels(other) != sum);
    ++assets;
  }
  CHECK(assets == 4);
}
