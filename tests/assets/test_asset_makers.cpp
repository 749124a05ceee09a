// The program that makes the assets still makes those in assets/. Built only where it can be built.
#include <doctest.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "../support/temporary_folder.hpp"
#include "engine/files/load_image.hpp"
#include "land_coverage.hpp"
#include "make_bricks.hpp"
#include "make_crate.hpp"
#include "make_earth.hpp"
#include "make_sky.hpp"
#include "make_uv_map.hpp"
#include "support/shown_values.hpp"

namespace {

using texmap::Image;
using texmap::test::TemporaryFolder;

const std::string assets = TEXMAP_ASSETS_DIR;

}  // namespace

TEST_CASE("making the assets again gives the same") {
  const std::string land = assets + "/sources/land-50m.json";
  const auto same = [](const Image& made, const std::string& name) {
    CAPTURE(name);
    CHECK(made == texmap::load_image(assets + "/" + name));
  };
  same(texmap::make_crate(), "crate.png");
  same(texmap::make_bricks_normals(), "bricks_normals.png");
  same(texmap::make_uv_map(), "uv_map.png");
  same(texmap::make_earth_relief(land), "earth_relief.png");
  same(texmap::make_earth(land), "earth.png");
  CHECK(texmap::radiance_file(texmap::make_sky()) == texmap::test::bytes_of(assets + "/sky.hdr"));
}

TEST_CASE("a file of land that is missing or is something else is an error with its name in it") {
  const TemporaryFolder folder;
  std::ofstream(folder / "other.json") << "[1, 2";
  std::ofstream(folder / "empty.json") << "{}";
  for (const char* name : {"nowhere.json", "other.json", "empty.json"})
    CHECK_THROWS_WITH_AS((void)texmap::land_coverage(folder / name, 36, 19),
                         doctest::Contains(name), std::runtime_error);
}
