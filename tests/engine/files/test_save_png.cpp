// Writing a picture as a PNG file.
#include <doctest.h>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG  // the programs have no PNG decoder of stb_image
#include <stb_image.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/files/decode_image.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/png_chunks.hpp"
#include "engine/files/save_png.hpp"
#include "support/made_pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {

using texmap::encode_png;
using texmap::Image;
using texmap::load_image;
using texmap::Packing;
using texmap::Rgb8;
using texmap::save_png;
using texmap::test::noise;
using texmap::test::TemporaryFolder;
using File = std::vector<std::uint8_t>;

// True if a picture comes back by our own checks of the sums and by stb_image, which has none.
bool comes_back(const Image& image, Packing packing) {
  const File file = encode_png(image, packing);
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> stb(
      stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels,
                            3),
      stbi_image_free);
  REQUIRE(stb);
  return width == image.width && height == image.height && channels == 3 &&
         std::equal(image.pixels.begin(), image.pixels.end(),
                    reinterpret_cast<const Rgb8*>(stb.get())) &&
         texmap::decode_image(file) == image;
}

}  // namespace

TEST_CASE("both checksums are those of the standards' examples, and of sums that wrap around") {
  const auto bytes = [](std::string_view text) { return File(text.begin(), text.end()); };
  CHECK(texmap::crc32(bytes("123456789")) == 0xCBF43926U);
  CHECK(texmap::adler32(bytes("Wikipedia")) == 0x11E60398U);
  std::uint64_t a = 1, b = 0;
  for (int i = 0; i < 11105; ++i) b += a += 255;
  CHECK(texmap::adler32(File(11105, 255)) == (b % 65521 << 16 | a % 65521));
}

TEST_CASE("pictures of every shape come back, by stb_image and by our own checks of the sums") {
  for (const auto& size : std::vector<std::pair<int, int>>{
           {1, 1}, {1, 301}, {301, 1}, {3, 5}, {86, 86}, {101, 67}, {641, 479}, {16384, 1}}) {
    CAPTURE(size.first);
    CAPTURE(size.second);
    for (const Packing packing : {Packing::fast, Packing::close}) {
      CHECK(comes_back(noise(size.first, size.second, 1), packing));
      CHECK(comes_back(Image(size.first, size.second, {255, 254, 1}), packing));
    }
  }
}

TEST_CASE(
    "flat pictures are small, noise hardly grows, and close packing makes chapter 03's less") {
  CHECK(encode_png(Image(800, 600, {120, 130, 140})).size() < 16000);
  CHECK(encode_png(noise(800, 600, 1)).size() < 800 * 600 * 3 * 102 / 100);
  const Image image = load_image(TEXMAP_TESTS_DIR "/golden/03_image_texture.png");
  const File close = encode_png(image, Packing::close);
  CHECK(comes_back(image, Packing::close));
  const std::size_t fast = encode_png(image).size();
  CHECK(fast < 92000);  // stb_image_write's, with its default settings, has 89,188 bytes
  CHECK(close.size() < fast * 95 / 100);
}

TEST_CASE("a picture without pixels, with too many or with a wrong count is not written") {
  const TemporaryFolder folder;
  const std::string path = folder / "none.png";
  const std::string front = "cannot write '" + path + "': ";
  for (const auto& [width, height, pixels] : std::vector<std::tuple<int, int, std::size_t>>{
           {0, 0, 0}, {4, 4, 15}, {-1, 1, 0}, {16385, 1, 0}, {16384, 16384, 0}}) {
    Image image;
    image.width = width;
    image.height = height;
    image.pixels.resize(pixels);
    const std::string said = texmap::test::image_error_of([&] { save_png(image, path); });
    INFO("said: ", said);
    CHECK(said.substr(0, front.size()) == front);
    CHECK(folder.size() == 0);
  }
}
