// The files in assets/: they are those checked, and show what assets/README.md says of them.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "engine/files/load_image.hpp"
#include "engine/files/load_light.hpp"
#include "support/pictures.hpp"
#include "support/sha256.hpp"
#include "support/shown_values.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;

namespace {

const std::string folder = TEXMAP_ASSETS_DIR "/";

/// True if a pixel of the Earth is sea: it is bluer than land.
bool is_sea(Rgb8 pixel) { return pixel.b > pixel.r + 20; }

Rgb8 pixel_at(const Image& earth, double longitude, double latitude) {
  const auto column = static_cast<int>(std::lround((longitude + 180) / 360 * (earth.width - 1)));
  const auto row = static_cast<int>(std::lround((90 - latitude) / 180 * (earth.height - 1)));
  return earth.at(column, row);
}

struct Place {
  const char* name;
  double longitude, latitude;  // degrees
  bool sea;
};

// A mirrored, turned or upside-down Earth is wrong at several of them, and so is one whose
// coastlines break at longitude 180.
constexpr Place places[] = {
    {"Paris", 2.35, 48.86, false},
    {"Alice Springs", 133.88, -23.70, false},
    {"Brasilia", -47.88, -15.79, false},
    {"Denver", -104.99, 39.74, false},
    {"Madagascar", 46.5, -19.0, false},
    {"Iceland", -18.5, 65.0, false},
    {"New Zealand", 171.0, -43.3, false},
    {"Wrangel Island, western part", 179.3, 71.2, false},
    {"Wrangel Island, eastern part", -179.0, 71.2, false},
    {"Chukotka on the antimeridian", 180.0, 68.0, false},
    {"Antarctica at 179 east", 179.0, -86.0, false},
    {"South Pole", 0.0, -90.0, false},
    {"Aral Sea, which the data hold for land", 60.0, 45.0, false},
    {"North Pole", 0.0, 90.0, true},
    {"Null Island", 0.0, 0.0, true},
    {"Middle of the Atlantic", -35.0, 30.0, true},
    {"Middle of the Pacific", -140.0, 0.0, true},
    {"Ross Sea on the antimeridian", -180.0, -76.0, true},
    {"Bay of Bengal", 88.0, 14.0, true},
    {"Hudson Bay", -85.0, 60.0, true},
    {"Caspian Sea, which the data hold for a sea", 51.0, 42.0, true},
    {"Red Sea", 38.0, 20.0, true},
};

}  // namespace

TEST_CASE("every asset has the size and the checksum that are written down for it") {
  int assets = 0;
  std::string sum, size, name;
  const auto check = [&](const auto& image, const std::vector<std::uint8_t>& bytes) {
    CAPTURE(name);
    CHECK(std::to_string(image.width) + "x" + std::to_string(image.height) == size);
    CHECK(test::sha256(bytes) == sum);
    ++assets;
  };
  for (std::ifstream list(folder + "checksums.txt"); list >> sum >> size >> name;) {
    const Image image = load_image(folder + name);
    std::vector<std::uint8_t> bytes;
    for (const Rgb8 pixel : image.pixels) bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
    check(image, bytes);
  }
  for (std::ifstream list(folder + "sky.sha256"); list >> sum >> size >> name;)
    check(load_light(folder + name), test::bytes_of(folder + name));
  CHECK(assets == 6);
}

TEST_CASE("the Earth has land and sea at the places of an atlas") {
  const Image earth = load_image(folder + "earth.png");
  for (const Place& place : places) {
    CAPTURE(place.name);
    CHECK(is_sea(pixel_at(earth, place.longitude, place.latitude)) == place.sea);
  }
}

TEST_CASE("land covers 28.8 % of the globe, and no pixel leaves a doubt whether it is land") {
  const Image earth = load_image(folder + "earth.png");
  double land = 0, all = 0;
  int doubtful = 0;
  for (int row = 0; row < earth.height; ++row) {
    const double weight =
        std::sin(3.14159265358979323846 * row / (earth.height - 1));  // cosine of the latitude
    for (int column = 0; column < earth.width - 1; ++column) {
      const Rgb8 pixel = earth.at(column, row);
      all += weight;
      land += is_sea(pixel) ? 0 : weight;
      doubtful += pixel.b > pixel.r + 18 && pixel.b < pixel.r + 26 ? 1 : 0;
    }
  }
  CHECK(land / all == doctest::Approx(0.288).epsilon(0.002));
  CHECK(doubtful == 0);
}

TEST_CASE("the Earth's first and last columns are one meridian, its first and last rows points") {
  const Image earth = load_image(folder + "earth.png");
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

TEST_CASE("the Earth's relief is gray, flat at sea, and highest in Tibet and the Andes") {
  const Image earth = load_image(folder + "earth.png");
  const Image relief = load_image(folder + "earth_relief.png");
  int highest = 0;
  for (int row = 0; row < relief.height; ++row) {
    for (int column = 0; column < relief.width; ++column) {
      const Rgb8 level = relief.at(column, row);
      REQUIRE((level.r == level.g && level.g == level.b));
      highest = std::max(highest, int{level.r});
      int sea = 0;
      for (int i = 0; i < 4; ++i) sea += is_sea(earth.at(2 * column + i % 2, 2 * row + i / 2));
      if (sea == 4) REQUIRE(level.r == 0);
    }
  }
  CHECK(highest > 150);
  CHECK(pixel_at(relief, 88, 33).r > 60);
  CHECK(pixel_at(relief, -69, -22).r > 40);
  CHECK(pixel_at(relief, 30, 55).r < 30);
}

TEST_CASE("the labelled map has a color for each quadrant, and no mirror image is like it") {
  const Image map = load_image(folder + "uv_map.png");
  const Rgb8 north_west = map.at(200, 150), north_east = map.at(712, 150);
  const Rgb8 south_west = map.at(200, 362), south_east = map.at(712, 362);
  CHECK((north_west.b > north_west.g && north_west.g > north_west.r));
  CHECK((north_east.r > north_east.g && north_east.g > north_east.b));
  CHECK((south_west.g > south_west.b && south_west.b > south_west.r));
  CHECK((south_east.r > south_east.b && south_east.b > south_east.g));
  const Image flipped = test::upside_down(map);
  for (const Image& other : {test::mirrored(map), flipped, test::mirrored(flipped)})
    CHECK(test::count_different(map, other) >= 1024 * 512 / 5);
}

TEST_CASE("the sun is where it is said to be, and 900 times as bright as white") {
  const LightImage sky = load_light(folder + "sky.hdr");
  const auto brightest = std::max_element(sky.pixels.begin(), sky.pixels.end(),
                                          [](const auto& a, const auto& b) { return a.r < b.r; });
  CHECK(std::abs(brightest->r - 900) < 10);
  const auto row = (brightest - sky.pixels.begin()) / sky.width;
  CHECK(std::abs(90 - 180 * (static_cast<double>(row) + 0.5) / 192 - 33) < 1.4);  // its radius
}
