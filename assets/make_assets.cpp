// Makes all assets again: make_assets OUT_DIR
#include <exception>
#include <filesystem>
#include <iostream>

#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "make_bricks.hpp"
#include "make_crate.hpp"
#include "make_earth.hpp"
#include "make_sky.hpp"
#include "make_uv_map.hpp"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: make_assets OUT_DIR\n";
    return 2;
  }
  const std::filesystem::path out = argv[1];
  const auto keep = [&](const texmap::Image& image, const char* name) {
    texmap::save_png(image, (out / name).string());
    std::cout << (out / name).string() << '\n';
  };
  keep(texmap::make_crate(), "crate.png");
  keep(texmap::make_bricks_normals(), "bricks_normals.png");
  keep(texmap::make_uv_map(), "uv_map.png");
  texmap::write_file_atomically(out / "sky.hdr", texmap::radiance_file(texmap::make_sky()));
  std::cout << (out / "sky.hdr").string() << '\n';
  keep(texmap::make_earth(std::filesystem::path(TEXMAP_ASSETS_DIR) / "sources" / "land-50m.json"),
       "earth.png");
  keep(texmap::make_earth_relief(std::filesystem::path(TEXMAP_ASSETS_DIR) / "sources" /
                                 "land-50m.json"),
       "earth_relief.png");
  return 0;
} catch (const std::exception& error) {
  std::cerr << "make_assets: " << error.what() << '\n';
  return 1;
}
