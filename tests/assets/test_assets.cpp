// The files in assets/ are those that were checked, and the Earth has its lands in their places.
#include <doctest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "engine/files/load_image.hpp"
#include "engine/files/load_light.hpp"
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
