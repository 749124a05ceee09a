// The sky in assets/: its file is what its maker makes, with the sun where it is said to be.
#include <doctest.h>

#include <cmath>
#include <string>

#include "../support/temporary_folder.hpp"
#include "engine/picture/load_light.hpp"
#include "make_sky.hpp"
#include "support/shown_values.hpp"

namespace {

const std::string assets = TEXMAP_ASSETS_DIR;

}  // namespace

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
