// Writing a picture as a PNG file.
#include <doctest.h>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG  // the programs have no PNG decoder of stb_image
#include <stb_image.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/picture/decode_image.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/image_errors.hpp"
#include "support/made_pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {

using texmap::encode_png;
using texmap::Image;
using texmap::load_image;
using texmap::Packing;
using texmap::Rgb8;
using texmap::save_png;
using texmap::test::image_error_of;
using texmap::test::noise;
using texmap::test::TemporaryFolder;

// The picture that `color(column, row)` gives.
template <class ColorAt>
Image painted(int width, int height, ColorAt color) {
  Image image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) image.at(column, row) = color(column, row);
  }
  return image;
}

std::uint8_t byte(int number) { return static_cast<std::uint8_t>(number & 0xFF); }

// Pictures with filtered rows of every kind: noise, flat, smooth, striped, and mixed.
std::vector<Image> kinds(int width, int height) {
  return {
      noise(width, height, 1),
      Image(width, height),
      Image(width, height, {255, 254, 1}),
      painted(width, height,
              [](int column, int row) {
                return Rgb8{byte(column), byte(row), byte(column + row)};
              }),
      painted(width, height,
              [](int column, int row) {
                return (column / 5 + row / 3) % 2 == 0 ? Rgb8{255, 0, 0} : Rgb8{};
              }),
      painted(width, height,
              [grains = noise(width, height, 1)](int column, int row) {
                return column < row ? grains.at(column, row) : Rgb8{byte(row), byte(row), 255};
              }),
  };
}

// What stb_image, which checks no sums, makes of a file in memory.
Image decoded_by_stb(const std::vector<std::uint8_t>& file) {
  int width = 0;
  int height = 0;
  int channels = 0;
  stbi_uc* const pixels = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width,
                                                &height, &channels, 3);
  REQUIRE(pixels != nullptr);
  const Image image = painted(width, height, [at = pixels](int, int) mutable {
    return Rgb8{*at++, *at++, *at++};
  });
  stbi_image_free(pixels);
  CHECK(channels == 3);
  return image;
}

}  // namespace

TEST_CASE("a picture comes back from its file as it was") {
  const TemporaryFolder folder;
  const std::array<std::pair<int, int>, 9> sizes = {
      {{1, 1}, {1, 2}, {2, 1}, {3, 5}, {7, 1}, {1, 257}, {255, 3}, {641, 479}, {16384, 1}}};
  for (const auto& size : sizes) {
    CAPTURE(size.first);
    CAPTURE(size.second);
    const Image image = noise(size.first, size.second, 1);
    save_png(image, folder / "picture.png");
    CHECK(load_image(folder / "picture.png") == image);
  }
  CHECK(folder.size() == 1);
}

TEST_CASE(
    "pictures of every kind and shape come back from their bytes, by stb_image and by our own "
    "checks of the sums") {
  const std::vector<std::pair<int, int>> sizes = {
      {1, 1},  {1, 2},   {2, 1},   {1, 301}, {301, 1},  {3, 3},    {16, 1},    {16, 9},
      {17, 5}, {86, 86}, {85, 87}, {87, 85}, {101, 67}, {341, 33}, {4097, 11}, {11, 4097}};
  for (const auto& size : sizes) {
    CAPTURE(size.first);
    CAPTURE(size.second);
    for (const Image& image : kinds(size.first, size.second)) {
      const std::vector<std::uint8_t> file = encode_png(image);
      CHECK(decoded_by_stb(file) == image);
      CHECK(texmap::decode_image(file) == image);
    }
  }
}

TEST_CASE("the bytes are the same however many threads encode at once") {
  const std::vector<Image> images = kinds(257, 129);
  std::vector<std::vector<std::uint8_t>> alone;
  for (const Image& image : images) alone.push_back(encode_png(image));
  std::array<bool, 8> same{};
  std::vector<std::thread> threads;
  for (bool& mine : same) {
    threads.emplace_back([&] {
      mine = true;
      for (std::size_t i = 0; i < images.size(); ++i)
        mine = mine && encode_png(images[i]) == alone[i];
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const bool mine : same) CHECK(mine);
}

TEST_CASE("flat pictures are small, and noise is hardly larger than its pixels") {
  CHECK(encode_png(Image(800, 600, {120, 130, 140})).size() < 9000);
  CHECK(encode_png(noise(800, 600, 1)).size() < 800 * 600 * 3 * 102 / 100);
}

// The table has the sizes of the golden pictures as stb_image_write itself writes them, with its
// default settings.
TEST_CASE("the course's pictures take less than with stb, and less again when packed closely") {
  const std::vector<std::pair<std::string, std::size_t>> table = {
      {"01_plain_spheres", 61705}, {"02_checkerboard_uv", 71857}, {"03_image_texture", 89188},
      {"05_y_rotation", 91021},    {"04_uv_conventions", 256430}, {"06_phong_texture_blend", 89708},
  };
  for (const auto& row : table) {
    CAPTURE(row.first);
    const Image image = load_image(TEXMAP_TESTS_DIR "/golden/" + row.first + ".png");
    const std::vector<std::uint8_t> close = encode_png(image, Packing::close);
    CHECK(encode_png(image).size() < row.second * 97 / 100);
    CHECK(close.size() < row.second * 78 / 100);
    CHECK(decoded_by_stb(close) == image);
    CHECK(texmap::decode_image(close) == image);
  }
}

TEST_CASE("rows run from the top and channels from red") {
  const TemporaryFolder folder;
  Image image(2, 2);
  image.at(0, 0) = {255, 0, 0};
  image.at(1, 0) = {0, 255, 0};
  image.at(0, 1) = {0, 0, 255};
  save_png(image, folder / "corners.png");
  const Image again = load_image(folder / "corners.png");
  CHECK(again.at(0, 0) == Rgb8{255, 0, 0});
  CHECK(again.at(1, 0) == Rgb8{0, 255, 0});
  CHECK(again.at(0, 1) == Rgb8{0, 0, 255});
  CHECK(again.at(1, 1) == Rgb8{0, 0, 0});
}

TEST_CASE("a picture without pixels, with too many or with a wrong count is not written") {
  const TemporaryFolder folder;
  const std::string path = folder / "none.png";
  const std::string front = "cannot write '" + path + "': ";
  Image wrong(4, 4);
  wrong.pixels.pop_back();
  Image negative;
  negative.width = -1;
  negative.height = 1;
  Image wide;
  wide.width = 16385;
  wide.height = 1;
  Image large;
  large.width = 16384;
  large.height = 16384;
  for (const Image& image : {Image(), wrong, negative, wide, large}) {
    const std::string said = image_error_of([&] { save_png(image, path); });
    INFO("said: ", said);
    CHECK(said.substr(0, front.size()) == front);
    CHECK(folder.size() == 0);
  }
}

// A limit on the size of files acts like a full disk: the write stops in the middle.