// Radiance .hdr files: the bias of writing and reading, and what the content of a file decides. The
// rest is in damaged.tsv.
#include <doctest.h>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_HDR  // the programs have no .hdr decoder of stb_image
#include <stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/files/load_light.hpp"
#include "engine/files/read_hdr.hpp"
#include "engine/files/save_png.hpp"
#include "math/srgb.hpp"
#include "support/dice.hpp"
#include "temporary_folder.hpp"

namespace texmap::test {
namespace {

using HdrBytes = std::vector<std::uint8_t>;

HdrBytes operator+(const std::string& text, const HdrBytes& bytes) {
  HdrBytes all(text.begin(), text.end());
  all.insert(all.end(), bytes.begin(), bytes.end());
  return all;
}

/// What stands before the texels.
std::string head(int width, int height) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
         std::to_string(width) + "\n";
}

/// `count` times the same texel, one by one.
HdrBytes flat(std::size_t count) {
  HdrBytes bytes;
  for (std::size_t i = 0; i < count; ++i) bytes.insert(bytes.end(), {128, 64, 32, 129});
  return bytes;
}

/// Light between 1/8 and 8, every amount's logarithm equally likely; texels that share an exponent.
std::vector<float> random_light(std::size_t count) {
  std::vector<float> light;
  Dice dice;
  while (light.size() < count) light.push_back(std::exp2(static_cast<float>(dice.between(-3, 3))));
  return light;
}

}  // namespace

TEST_CASE("writing and reading by stb loses light, and the middle of the step gives it back") {
  constexpr int width = 512, height = 256;
  const std::vector<float> light = random_light(width * height * 3);
  HdrBytes file;
  const auto append = [](void* context, void* data, int size) {
    const auto* const first = static_cast<const std::uint8_t*>(data);
    auto* const out = static_cast<HdrBytes*>(context);
    out->insert(out->end(), first, first + size);
  };
  REQUIRE(stbi_write_hdr_to_func(append, &file, width, height, 3, light.data()) != 0);
  int stb_width = 0, stb_height = 0, channels = 0;
  const std::unique_ptr<float, void (*)(void*)> theirs(
      stbi_loadf_from_memory(file.data(), static_cast<int>(file.size()), &stb_width, &stb_height,
                             &channels, 3),
      stbi_image_free);
  REQUIRE(theirs);
  const LightImage ours = read_hdr(file, max_light_texels);
  REQUIRE(ours.width == width);
  double sum = 0, sum_of_theirs = 0, sum_of_ours = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    const float* const by_stb = theirs.get() + 3 * i;
    int exponent = 0;
    std::frexp(std::max({by_stb[0], by_stb[1], by_stb[2]}), &exponent);
    const float half_a_step = std::ldexp(1.0F, exponent - 9);
    const float by_us[] = {ours.pixels[i].r, ours.pixels[i].g, ours.pixels[i].b};
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(by_us[k] == (by_stb[k] == 0 ? 0 : by_stb[k] + half_a_step));
      sum += light[3 * i + k];
      sum_of_theirs += by_stb[k];
      sum_of_ours += by_us[k];
    }
  }
  CHECK(1 - sum_of_theirs / sum > 0.003);
  CHECK(std::abs(1 - sum_of_ours / sum) < 1e-4);
}

TEST_CASE("the content decides what a file is, and PNG bytes become light by the sRGB curve") {
  const TemporaryFolder folder;
  put(folder / "sky.png", head(2, 1) + flat(2));
  CHECK(load_light(folder / "sky.png").pixels[0].r == 128.5F / 128);
  save_png(Image(2, 1, {188, 255, 0}), folder / "sky.hdr");
  const LightImage light = load_light(folder / "sky.hdr");
  CHECK(light.pixels[1].r == doctest::Approx(srgb_decode(188 / 255.0)));
  CHECK(light.pixels[1].g == 1);
  CHECK(light.pixels[1].b == 0);
  put(folder / "bad.hdr", head(2, 2) + flat(3));
  put(folder / "other.hdr", std::string("GIF89a...") + HdrBytes());
  put(folder / "exr.hdr", std::string("v/1\1\2...") + HdrBytes());
  save_png(Image(4096, 2049), folder / "large.png");
  for (const auto& item : std::vector<std::pair<std::string, std::string>>{
           {"bad.hdr", "': the Radiance file is damaged: it ends in row 1"},
           {"other.hdr", "': it is a GIF picture, not a PNG, JPEG or Radiance .hdr file"},
           {"exr.hdr", "try: pfsin FILE | pfsout out.hdr"},
           {"large.png", "a sky may have at most 8388608"},
           {"none.hdr", ""}}) {
    const std::string path = folder / item.first;
    const std::string said = image_error_of([&] { static_cast<void>(load_light(path)); });
    INFO("said: ", said);
    CHECK(said.find("cannot load texture '" + path) == 0);
    CHECK(said.find(item.second) != std::string::npos);
  }
}

}  // namespace texmap::test
