// The sky in assets/: its file is the one that was checked, and its maker still makes it.
#include <doctest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "../support/sha256.hpp"
#include "../support/temporary_folder.hpp"
#include "engine/picture/load_light.hpp"
#include "make_sky.hpp"
#include "support/shown_values.hpp"

namespace {

const std::string assets = TEXMAP_ASSETS_DIR;

std::string sum_of(const std::vector<std::uint8_t>& bytes) {
  return texmap::test::sha256(std::span<const std::uint8_t>(bytes));
}

}  // namespace

TEST_CASE("the sky's file has the checksum that is written down for it, and its size") {
  std::ifstream list(assets + "/sky.sha256");
  std::string sum, size, name;
  REQUIRE((list >> sum >> size >> name));
  std::vector<std::uint8_t> bytes = texmap::test::bytes_of(assets + "/" + name);
  CHECK(sum_of(bytes) == sum);
  const texmap::LightImage sky = texmap::load_light(assets + "/" + name);
  CHECK(std::to_string(sky.width) + "x" + std::to_string(sky.height) == size);
  bytes[bytes.size() / 2] ^= 1;
  CHECK(sum_of(bytes) != sum);
}

TEST_CASE("making the sky again gives the same file") {
  CHECK(texmap::radiance_file(texmap::make_sky()) == texmap::test::bytes_of(assets + "/sky.hdr"));
}

TEST_CASE("the sun is where it is said to be, and 900 times as bright as white") {
  const texmap::LightImage sky = texmap::load_light(assets + "/sky.hdr");
  std::size_t brightest = 0;
  for (std::size_t i = 0; i < sky.pixels.size(); ++i) {
    if (sky.pixels[i].r > sky.pixels[brightest].r) brightest = i;
  }
  CHECK(sky.pixels[brightest].r > 890);
  CHECK(sky.pixels[brightest].r < 910);
  const double latitude = 90 - 180 * (static_cast<double>(brightest / 384) + 0.5) / 192;
  CHECK(std::abs(latitude - 33) < 1.4);  // its radius
}
