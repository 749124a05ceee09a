// Loading a texture: what must load, what must not, and how it says so.
#include <doctest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "engine/files/bytes.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/load_image.hpp"
#include "support/sha256.hpp"
#include "support/temporary_folder.hpp"

namespace {

using texmap::Image;
using texmap::load_image;
using texmap::test::bytes_of;
using texmap::test::image_error_of;

const std::string corpus = std::string(TEXMAP_TESTS_DIR) + "/corpus/";

std::string sum_of_pixels(const Image& image) {
  std::vector<std::uint8_t> bytes;
  for (const texmap::Rgb8 pixel : image.pixels)
    bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
  return texmap::test::sha256(bytes);
}

}  // namespace

TEST_CASE("every file of the corpus loads or is refused as its manifest says") {
  std::ifstream manifest(corpus + "manifest.tsv");
  std::string line;
  std::getline(manifest, line);
  REQUIRE(line ==
          "file\tsha256\texpected\twhy\twidth\theight\tbytes\tsplit\tlevel\trgb8_sha256\tsaid");
  int loaded = 0, refused = 0;
  while (std::getline(manifest, line)) {
    CAPTURE(line);
    std::array<std::string, 11> fields;
    std::istringstream row(line);
    for (std::string& field : fields) REQUIRE(std::getline(row, field, '\t'));
    const auto& [file, sum, expected, why, width, height, bytes, split, level, pixels, words] =
        fields;
    const std::string path = corpus + file;
    REQUIRE(texmap::test::sha256(bytes_of(path)) == sum);
    if (expected == "load") {
      Image image;
      REQUIRE_NOTHROW(image = load_image(path));
      CHECK(std::to_string(image.width) == width);
      CHECK(std::to_string(image.height) == height);
      if (pixels != "-") CHECK(sum_of_pixels(image) == pixels);
      ++loaded;
    } else {
      const std::string said = image_error_of([&] { static_cast<void>(load_image(path)); });
      INFO("said: ", said);
      CHECK(said.starts_with("cannot load texture '" + path + "': " + words));
      CHECK(said.find('\n') == std::string::npos);
      ++refused;
    }
  }
  CHECK(loaded == 36);
  CHECK(refused == 39);
}

TEST_CASE(
    "a picture whose textures would take more memory than there is is refused, with a remedy") {
  for (const std::string file : {"png_rgb8_1x257.png", "jpg_420.jpg"}) {
    CHECK_NOTHROW(static_cast<void>(load_image(corpus + file, nullptr, nullptr, 12)));
    const std::string said = image_error_of(
        [&] { static_cast<void>(load_image(corpus + file, nullptr, nullptr, 2'000'000'000)); });
    INFO(said);
    CHECK(std::regex_match(said, std::regex("cannot load texture '.*': it would take \\d+ MiB of "
                                            "memory, and \\d+ MiB are free; half as wide and high "
                                            "it takes a quarter")));
  }
}

TEST_CASE(
    "every file of the corpus cut anywhere is refused, and so is a PNG file with a bit turned") {
  for (const std::string file : {"png_pal8_trns.png", "png_adam7_pal4_3x5.png",
                                 "png_rgb8_1x257.png", "jpg_420.jpg", "jpg_restart.jpg"}) {
    const std::vector<std::uint8_t> whole = bytes_of(corpus + file);
    REQUIRE_NOTHROW(static_cast<void>(texmap::decode_image(whole)));
    for (std::size_t length = 0; length < whole.size(); ++length) {
      CAPTURE(file);
      CAPTURE(length);
      CHECK_THROWS_AS(static_cast<void>(texmap::decode_image(texmap::Bytes(whole).first(length))),
                      texmap::FileError);
    }
  }
  const std::vector<std::uint8_t> whole = bytes_of(corpus + "png_pal8_short5.png");
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::vector<std::uint8_t> bytes = whole;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    CAPTURE(bit);
    CHECK_THROWS_AS(static_cast<void>(texmap::decode_image(bytes)), texmap::FileError);
  }
}
