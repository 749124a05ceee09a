// Radiance .hdr files: what loads, what does not, and the bias of writing and reading.
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

#include "engine/picture/codecs/read_hdr.hpp"
#include "engine/picture/load_light.hpp"
#include "engine/picture/save_png.hpp"
#include "made_hdr.hpp"
#include "math/srgb.hpp"
#include "support/image_errors.hpp"
#include "temporary_folder.hpp"

namespace texmap::test {
namespace {

/// "it loads", or what the error says.
std::string outcome(const HdrBytes& file) {
  try {
    static_cast<void>(read_hdr(file, max_light_texels));
    return "it loads";
  } catch (const FileError& error) {
    return error.what();
  }
}

/// A file with these floats, three a texel, as stb_image_write writes it.
HdrBytes written_by_stb(const std::vector<float>& light, int width, int height) {
  HdrBytes bytes;
  const auto append = [](void* context, void* data, int size) {
    auto* const out = static_cast<HdrBytes*>(context);
    const auto* const first = static_cast<const std::uint8_t*>(data);
    out->insert(out->end(), first, first + size);
  };
  REQUIRE(stbi_write_hdr_to_func(append, &bytes, width, height, 3, light.data()) != 0);
  return bytes;
}

/// What stb_image reads from a file.
std::vector<float> read_by_stb(const HdrBytes& file) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<float, void (*)(void*)> light(
      stbi_loadf_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels,
                             3),
      stbi_image_free);
  REQUIRE(light);
  return {light.get(), light.get() + static_cast<std::ptrdiff_t>(width) * height * 3};
}

/// Light between 1/8 and 8, every amount's logarithm equally likely; texels that share an exponent.
std::vector<float> random_light(std::size_t count) {
  std::vector<float> light;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < count; ++i) {
    state = state * 1664525U + 1013904223U;
    light.push_back(std::exp2(static_cast<float>(state >> 8) * 0x1p-24F * 6 - 3));
  }
  return light;
}

/// A file of one row.
HdrBytes one_row(int width, const HdrBytes& texels) {
  return hdr_start + (bytes_of_text(hdr_size(width, 1)) + texels);
}

}  // namespace

TEST_CASE("a damaged .hdr file is an error that says what is wrong, and the others load") {
  for (const HdrCase& item : hdr_corpus()) {
    CAPTURE(item.name);
    const std::string said = outcome(item.file);
    CAPTURE(said);
    CHECK(said.find(*item.error == '\0' ? "it loads" : item.error) != std::string::npos);
  }
}

TEST_CASE("every beginning of a whole file is an error, never a part of a picture") {
  const HdrBytes rows =
      new_row(8, runs(8)) + new_row(8, {8, 1, 2, 3, 4, 5, 6, 7, 8, 136, 9, 136, 9, 136, 128});
  const HdrBytes whole = hdr_start + (bytes_of_text(hdr_size(8, 2)) + rows);
  CHECK(outcome(whole) == "it loads");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const HdrBytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    CAPTURE(size);
    if (looks_like_hdr(cut)) CHECK(outcome(cut) != "it loads");
  }
}

TEST_CASE("a texel is the middle of its step, an exponent 0 is black, an exposure divides") {
  const std::string exposed = "#?RADIANCE\nEXPOSURE=2\nEXPOSURE=4\nFORMAT=32-bit_rle_rgbe\n\n";
  const std::vector<std::pair<HdrBytes, Color<float>>> table = {
      {one_row(2, flat(2)), {128.5F / 128, 64.5F / 128, 32.5F / 128}},
      {one_row(2, flat(2, {200, 1, 255, 0})), {0, 0, 0}},
      {one_row(2, flat(2, {128, 0, 1, 129})), {128.5F / 128, 0, 1.5F / 128}},
      {one_row(2, flat(2, {2, 1, 1, 1})), {0x2.8p-135F, 0x1.8p-135F, 0x1.8p-135F}},
      {exposed + (bytes_of_text(hdr_size(2, 1)) + flat(2)),
       {128.5F / 1024, 64.5F / 1024, 32.5F / 1024}},
  };
  for (const auto& [file, expected] : table) {
    const Color<float> texel = read_hdr(file, max_light_texels).pixels.front();
    CHECK(texel.r == expected.r);
    CHECK(texel.g == expected.g);
    CHECK(texel.b == expected.b);
  }
}

TEST_CASE("runs of both kinds and texels one by one hold the same light") {
  const HdrBytes one = flat(1, {10, 20, 30, 129});
  for (const HdrBytes& file :
       {one_row(8, flat(8, {10, 20, 30, 129})), one_row(8, new_row(8, runs(8, {10, 20, 30, 129}))),
        one_row(8, one + HdrBytes{1, 1, 1, 3} + one + HdrBytes{1, 1, 1, 3}),
        // A count of two bytes: 300 texels are the first, 43 more and 1 times 256.
        one_row(300, one + HdrBytes{1, 1, 1, 43} + HdrBytes{1, 1, 1, 1})}) {
    for (const Color<float>& texel : read_hdr(file, max_light_texels).pixels) {
      REQUIRE(texel.r == 10.5F / 128);
      REQUIRE(texel.g == 20.5F / 128);
      REQUIRE(texel.b == 30.5F / 128);
    }
  }
}

TEST_CASE("writing and reading by stb loses light, and the middle of the step gives it back") {
  constexpr int width = 512, height = 256;
  const std::vector<float> light = random_light(width * height * 3);
  const HdrBytes file = written_by_stb(light, width, height);
  const std::vector<float> theirs = read_by_stb(file);
  const LightImage ours = read_hdr(file, max_light_texels);
  REQUIRE(ours.width == width);
  double sum = 0, sum_of_theirs = 0, sum_of_ours = 0;
  double brightest = 0, brightest_corrected = 0;  // relative bias of each texel's largest channel
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    const std::size_t first = 3 * i;
    const float most = std::max({theirs[first], theirs[first + 1], theirs[first + 2]});
    int exponent = 0;
    std::frexp(most, &exponent);
    const float half_a_step = std::ldexp(1.0F, exponent - 9);
    const float truth = std::max({light[first], light[first + 1], light[first + 2]});
    const float channels[] = {ours.pixels[i].r, ours.pixels[i].g, ours.pixels[i].b};
    for (std::size_t k = 0; k < 3; ++k) {
      const float by_stb = theirs[first + k];
      REQUIRE(channels[k] == (by_stb == 0 ? 0 : by_stb + half_a_step));
      sum += light[first + k];
      sum_of_theirs += by_stb;
      sum_of_ours += channels[k];
      if (light[first + k] != truth) continue;
      brightest += by_stb / truth - 1;
      brightest_corrected += channels[k] / truth - 1;
    }
  }
  const auto count = static_cast<double>(ours.pixels.size());
  CHECK(1 - sum_of_theirs / sum > 0.003);
  CHECK(std::abs(1 - sum_of_ours / sum) < 1e-4);
  // The brightest channel's mantissa is m = 128 to 255, in a logarithmic world 1 / (m ln 2) often:
  // half a step of it is on average (1 / 128 - 1 / 256) / (2 ln 2).
  CHECK(brightest / count ==
        doctest::Approx(-(1 / 128.0 - 1 / 256.0) / (2 * std::log(2.0))).epsilon(0.01));
  CHECK(std::abs(brightest_corrected / count) < 3e-5);
}

TEST_CASE("the content decides what a file is, and PNG bytes become light by the sRGB curve") {
  const TemporaryFolder folder;
  put(folder / "sky.png", one_row(2, flat(2)));
  CHECK(load_light(folder / "sky.png").pixels[0].r == 128.5F / 128);
  save_png(Image(2, 1, {188, 255, 0}), folder / "sky.hdr");
  const LightImage light = load_light(folder / "sky.hdr");
  CHECK(light.pixels[1].r == doctest::Approx(srgb_decode(188 / 255.0)));
  CHECK(light.pixels[1].g == 1);
  CHECK(light.pixels[1].b == 0);
  put(folder / "bad.hdr", hdr_start + (bytes_of_text(hdr_size(2, 2)) + flat(3)));
  put(folder / "other.hdr", bytes_of_text("GIF89a..."));
  save_png(Image(4096, 2049), folder / "large.png");
  for (const auto& item : std::vector<std::pair<std::string, std::string>>{
           {"bad.hdr", "': the Radiance file is damaged: it ends in row 1"},
           {"other.hdr", "': it is not a PNG, JPEG or Radiance .hdr file"},
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
