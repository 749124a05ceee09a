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

}  // namespace

TEST_CASE("a damaged .hdr file is an error that says what is wrong, and the others load") {
  std::size_t bad = 0;
  for (const HdrCase& item : hdr_corpus()) {
    CAPTURE(item.name);
    const std::string said = outcome(item.file);
    CAPTURE(said);
    if (std::string(item.error).empty()) {
      CHECK(said == "it loads");
    } else {
      CHECK(said.find(item.error) != std::string::npos);
      ++bad;
    }
  }
  MESSAGE(bad << " damaged files");
  CHECK(bad >= 25);
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

TEST_CASE("a byte changed at random never does worse than an error") {
  const HdrBytes whole = hdr_start + (bytes_of_text(hdr_size(8, 3)) +
                                      (new_row(8, runs(8)) + (flat(8) + new_row(8, runs(8)))));
  std::uint32_t state = 7;
  int loaded = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    HdrBytes file = whole;
    for (int change = 0; change < 2; ++change) {
      state = state * 1664525U + 1013904223U;
      file[11 + (state >> 8) % (file.size() - 11)] = static_cast<std::uint8_t>(state >> 24);
    }
    const std::string said = outcome(file);
    loaded += said == "it loads" ? 1 : 0;
    REQUIRE(!said.empty());
  }
  CHECK(loaded > 1000);  // most changes are other light
  CHECK(loaded < 19000);
}

TEST_CASE("a texel is the middle of its step, an exponent 0 is black, an exposure divides") {
  const auto first = [](const HdrBytes& file) {
    return read_hdr(file, max_light_texels).texels.front();
  };
  const Color<float> plain = first(hdr_start + (bytes_of_text(hdr_size(2, 1)) + flat(2)));
  CHECK(plain.r == 128.5F / 128);
  CHECK(plain.g == 64.5F / 128);
  CHECK(plain.b == 32.5F / 128);
  const Color<float> black =
      first(hdr_start + (bytes_of_text(hdr_size(2, 1)) + flat(2, {200, 1, 255, 0})));
  CHECK(black.r == 0);
  CHECK(black.b == 0);
  const Color<float> partly =
      first(hdr_start + (bytes_of_text(hdr_size(2, 1)) + flat(2, {128, 0, 1, 129})));
  CHECK(partly.g == 0);
  CHECK(partly.b == 1.5F / 128);
  const HdrBytes exposed = "#?RADIANCE\nEXPOSURE=2\nEXPOSURE=4\nFORMAT=32-bit_rle_rgbe\n\n" +
                           (bytes_of_text(hdr_size(2, 1)) + flat(2));
  CHECK(first(exposed).r == 128.5F / 128 / 8);
  const Color<float> least =
      first(hdr_start + (bytes_of_text(hdr_size(2, 1)) + flat(2, {2, 1, 1, 1})));
  CHECK(least.r == 0x2.8p-135F);
}

TEST_CASE("runs of both kinds and texels one by one hold the same light") {
  const LightImage plain =
      read_hdr(hdr_start + (bytes_of_text(hdr_size(8, 2)) + flat(16)), max_light_texels);
  const LightImage with_new = read_hdr(
      hdr_start + (bytes_of_text(hdr_size(8, 2)) + (new_row(8, runs(8)) + new_row(8, runs(8)))),
      max_light_texels);
  const LightImage with_old =
      read_hdr(hdr_start + (bytes_of_text(hdr_size(8, 2)) +
                            (flat(1) + HdrBytes{1, 1, 1, 7} + flat(3) + HdrBytes{1, 1, 1, 5})),
               max_light_texels);
  // A count of two bytes: 300 texels are the first, 43 more and 1 times 256.
  const LightImage far =
      read_hdr(hdr_start + (bytes_of_text(hdr_size(300, 1)) +
                            (flat(1) + HdrBytes{1, 1, 1, 43} + HdrBytes{1, 1, 1, 1})),
               max_light_texels);
  REQUIRE(far.texels.size() == 300);
  for (const Color<float>& texel : far.texels) REQUIRE(texel.g == plain.texels[0].g);
  for (std::size_t i = 0; i < 16; ++i) {
    CHECK(with_new.texels[i].b == plain.texels[i].b);
    CHECK(with_old.texels[i].r == plain.texels[i].r);
  }
}

TEST_CASE("stb_image reads the same mantissas: half a step less where they are not 0") {
  constexpr int width = 61, height = 17;
  const std::vector<float> light = random_light(width * height * 3);
  const HdrBytes file = written_by_stb(light, width, height);
  const std::vector<float> theirs = read_by_stb(file);
  const LightImage ours = read_hdr(file, max_light_texels);
  REQUIRE(ours.width == width);
  for (std::size_t i = 0; i < ours.texels.size(); ++i) {
    const float most = std::max({theirs[3 * i], theirs[3 * i + 1], theirs[3 * i + 2]});
    int exponent = 0;
    std::frexp(most, &exponent);
    const float half = std::ldexp(1.0F, exponent - 9);
    const float green = theirs[3 * i + 1];
    REQUIRE(ours.texels[i].g == (green == 0 ? 0 : green + half));
    REQUIRE(ours.texels[i].r == (theirs[3 * i] == 0 ? 0 : theirs[3 * i] + half));
  }
}

TEST_CASE("writing and reading by stb loses light, and the middle of the step gives it back") {
  constexpr int width = 512, height = 256;
  const std::vector<float> light = random_light(width * height * 3);
  const HdrBytes file = written_by_stb(light, width, height);
  const std::vector<float> theirs = read_by_stb(file);
  const LightImage ours = read_hdr(file, max_light_texels);
  double sum = 0, sum_of_theirs = 0, sum_of_ours = 0, bias = 0, corrected = 0;
  double brightest = 0, brightest_mended = 0;
  for (std::size_t i = 0; i < ours.texels.size(); ++i) {
    const float most = std::max({light[3 * i], light[3 * i + 1], light[3 * i + 2]});
    const float channels[] = {ours.texels[i].r, ours.texels[i].g, ours.texels[i].b};
    for (std::size_t k = 0; k < 3; ++k) {
      const double truth = light[3 * i + k];
      sum += truth;
      sum_of_theirs += theirs[3 * i + k];
      sum_of_ours += channels[k];
      bias += theirs[3 * i + k] / truth - 1;
      corrected += channels[k] / truth - 1;
      if (light[3 * i + k] == most) {
        brightest += theirs[3 * i + k] / truth - 1;
        brightest_mended += channels[k] / truth - 1;
      }
    }
  }
  const auto count = static_cast<double>(3 * ours.texels.size());
  MESSAGE("light lost: " << 100 * (1 - sum_of_theirs / sum) << " % without, "
                         << 100 * (1 - sum_of_ours / sum) << " % with half a step");
  MESSAGE("mean relative bias: all channels "
          << bias / count << " and " << corrected / count << ", the brightest of each texel "
          << brightest / count * 3 << " and " << brightest_mended / count * 3);
  CHECK(1 - sum_of_theirs / sum > 0.003);
  CHECK(std::abs(1 - sum_of_ours / sum) < 1e-4);
  // The brightest channel's mantissa is m = 128 to 255, in a logarithmic world 1 / (m ln 2) often:
  // half a step of it is on average (1 / 128 - 1 / 256) / (2 ln 2).
  CHECK(brightest / count * 3 ==
        doctest::Approx(-(1 / 128.0 - 1 / 256.0) / (2 * std::log(2.0))).epsilon(0.01));
  CHECK(std::abs(brightest_mended / count * 3) < 3e-5);
}

TEST_CASE("the content decides what a file is, and PNG bytes become light by the sRGB curve") {
  const TemporaryFolder folder;
  put(folder / "sky.png", hdr_start + (bytes_of_text(hdr_size(2, 1)) + flat(2)));
  CHECK(load_light(folder / "sky.png").texels[0].r == 128.5F / 128);
  save_png(Image(2, 1, {188, 255, 0}), folder / "sky.hdr");
  const LightImage light = load_light(folder / "sky.hdr");
  CHECK(light.texels[1].r == doctest::Approx(srgb_decode(188 / 255.0)));
  CHECK(light.texels[1].g == 1);
  CHECK(light.texels[1].b == 0);
  const auto error_of = [&](const std::string& name) {
    try {
      static_cast<void>(load_light(folder / name));
      return std::string();
    } catch (const FileError& error) {
      return std::string(error.what());
    }
  };
  put(folder / "bad.hdr", hdr_start + (bytes_of_text(hdr_size(2, 2)) + flat(3)));
  CHECK(error_of("bad.hdr") == "cannot load texture '" + (folder / "bad.hdr") +
                                   "': the Radiance file is damaged: it ends in row 1");
  put(folder / "other.hdr", bytes_of_text("GIF89a..."));
  CHECK(error_of("other.hdr").find("it is not a PNG, JPEG or Radiance .hdr file") !=
        std::string::npos);
  save_png(Image(4096, 2049), folder / "large.png");
  CHECK(error_of("large.png").find("a sky may have at most 8388608") != std::string::npos);
  CHECK(error_of("none.hdr").find("none.hdr") != std::string::npos);
}

}  // namespace texmap::test
