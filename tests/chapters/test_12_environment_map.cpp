// Chapter 12: a picture as the sky, against what is known without drawing it.
#include <doctest.h>

#include <cmath>
#include <string>

#include "07_earth_by_sampling/lesson.hpp"
#include "12_environment_map/lesson.hpp"
#include "engine/files/find_texture.hpp"
#include "engine/files/load_light.hpp"
#include "engine/files/save_png.hpp"
#include "engine/run/sky_options.hpp"
#include "support/films.hpp"
#include "support/running.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_12::Lesson;

namespace {

template <class Real = double, class AnyLesson>
Image developed(const AnyLesson& lesson, int samples, const Drawn& drawn = {}) {
  return develop(film_of<Real>(lesson, samples, drawn), Transfer::srgb);
}

/// The lesson under another sky, its light gathered in that way.
Lesson under(LightImage map, SkyLighting way = SkyLighting::cosine, double degrees = 0) {
  Lesson lesson;
  lesson.stage.sky = SkyLight(Environment(std::move(map), TexelFilter::bilinear, degrees));
  lesson.sky.matte.way = way;
  return lesson;
}

LightImage sky_of_the_chapter() { return load_light(find_texture("sky.hdr")); }

/// The light of a whole sky: brightness times solid angle, of each channel.
Rgb energy_of(const LightImage& map) { return SkyMoments(Environment(map)).sums()[0]; }

}  // namespace

TEST_CASE(
    "under a constant picture a ball is drawn as in chapter 07 under its uniform sky: 0 pixels") {
  auto before = prepared<chapter_07::Lesson>({"--scene", "book"});
  const Rgb8 paint = {188, 128, 64};
  before.objects[0].paint.texture.image = Image(1, 1, paint);
  Lesson after = under(LightImage(8, 4, {0.7F, 0.8F, 1.0F}));
  after.stage.camera = before.stage.camera;
  const auto& levels = light_of_bytes<double>(TexelLight::linear);
  after.objects = {{.shape = before.objects[0].shape,
                    .paint = {{levels[paint.r], levels[paint.g], levels[paint.b]}}}};
  const Image expected = developed(before, 16);
  expect_same_picture(developed(after, 16), expected);
  after.objects[0].paint.mirrors = true;  // a mirror of that color sees the same light everywhere
  expect_same_picture(developed(after, 16), expected);
  after.stage.sky = SkyLight(Environment(LightImage(8, 4, {0.7F, 0.82F, 1.0F})));
  CHECK(count_different(developed(after, 16), expected) > 1000);
}

TEST_CASE("--sky-mirrored exchanges the left and the right of the picture, and nothing else") {
  const LightImage map = sky_of_the_chapter();
  const Lesson lesson = prepared<Lesson>({"--sky-mirrored", "--light", "cosine"});
  const LightImage& mirrored = lesson.stage.sky.picture.map();
  bool same = mirrored.width == map.width;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Color<float>&a = mirrored.at(map.width - 1 - column, row), &b = map.at(column, row);
      same = same && a.r == b.r && a.g == b.g && a.b == b.b;
    }
  }
  CHECK(same);
}

TEST_CASE("white furnace: under a sky of ones the white chapter cannot be told from the sky") {
  Lesson lesson = under(LightImage(8, 4, gray(1.0F)));
  lesson.sampling.bounces = 1000;
  for (auto& object : lesson.objects) object.paint.color = {1, 1, 1};
  for_each_pixel(film_of(lesson, 4), [](const Rgb& light) {
    REQUIRE(light.r == 1);
    REQUIRE(light.b == 1);
  });
  lesson.stage.sky = SkyLight(Environment(LightImage(8, 4, gray(0.5F))));
  CHECK(film_of(lesson, 1).light(32, 20).g == 0.5);
}

TEST_CASE("all ways gather the same light: their pictures come together as samples grow") {
  const Size size = {32, 18};
  const Drawn drawn = {.size = size};
  LightImage map = sky_of_the_chapter();
  for (Color<float>& texel : map.pixels) {  // a weaker sun: chance alone must find it, too
    const auto limited = [](float x) { return std::min(x, 20.0F); };
    texel = {limited(texel.r), limited(texel.g), limited(texel.b)};
  }
  const Film reference = film_of<Pack<double>>(under(map, SkyLighting::mis), 4096, drawn);
  for (const SkyLighting way :
       {SkyLighting::uniform, SkyLighting::cosine, SkyLighting::importance}) {
    CAPTURE(static_cast<int>(way));
    const double few = apart(film_of<Pack<double>>(under(map, way), 64, drawn), reference);
    const double many = apart(film_of<Pack<double>>(under(map, way), 4096, drawn), reference);
    CHECK(many < few / 5);
    CHECK(many < 0.012);
  }
  // Nine coefficients have no noise, but no shadows: more samples do not help.
  const double without_shadows =
      apart(film_of<Pack<double>>(under(map, SkyLighting::coefficients), 256, drawn), reference);
  CHECK(without_shadows > 0.01);
}

TEST_CASE(
    "the choice is what the sky requires: nothing under a constant one, mis under a sun; whatever "
    "mis costs, within a factor of 10") {
  const auto choice = [](LightImage map) {
    const SkyNoise noise = noise_of(SkyLight(Environment(std::move(map))));
    const SkyLighting best = best_lighting(noise);
    for (const double wrong : {0.1, 0.5, 2.0, 10.0})
      CHECK(best_lighting(noise, cost_of_mis * wrong) == best);
    return best;
  };
  CHECK(choice(LightImage(8, 4, gray(3.0F))) == SkyLighting::cosine);
  CHECK(choice(LightImage(8, 4)) == SkyLighting::cosine);
  LightImage gradient(64, 32);
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 64; ++column)
      gradient.at(column, row) = gray(1 - static_cast<float>(row) / 80);
  }
  CHECK(choice(gradient) == SkyLighting::cosine);
  CHECK(choice(sky_of_the_chapter()) == SkyLighting::mis);
  // The cost does count where the noises are near each other.
  const SkyNoise near = {.cosine = 1.6, .mis = 1};
  CHECK(best_lighting(near) == SkyLighting::cosine);
  CHECK(best_lighting(near, 2.5) == SkyLighting::mis);
}

TEST_CASE("the picture is the same for any number of threads and for packs of any width") {
  for (const SkyLighting way : {SkyLighting::uniform, SkyLighting::cosine, SkyLighting::importance,
                                SkyLighting::mis, SkyLighting::coefficients}) {
    Lesson lesson = under(sky_of_the_chapter(), way, 30);
    const Drawn drawn = {.size = {61, 33}, .threads = 1};
    const Image one = developed(lesson, 9, drawn);
    CHECK(developed(lesson, 9, {.size = {61, 33}, .threads = 3}) == one);
    expect_same_picture(developed<Pack<double>>(lesson, 9, drawn), one, {.pixels = 1});
    expect_same_picture(developed<long double>(lesson, 9, drawn), one, {.pixels = 6});
    const Image in_float = developed<float>(lesson, 9, drawn);
    expect_same_picture(developed<Pack<float>>(lesson, 9, drawn), in_float, {.pixels = 4});
    // Paths near an edge take the other side.
    expect_same_picture(in_float, one, {.pixels = 100});
    CHECK(count_different(developed(lesson, 9, {.size = {61, 33}, .seed = 1}), one) > 100);
  }
}

TEST_CASE("a stop more is twice the light, and a full turn is none") {
  const auto lesson = [](const std::vector<std::string>& words) { return prepared<Lesson>(words); };
  const Film plain = film_of(lesson({"--light", "mis"}), 4);
  const Film brighter = film_of(lesson({"--light", "mis", "--exposure", "1"}), 4);
  double worst = 0;
  for (int row = 0; row < 36; ++row) {
    for (int column = 0; column < 64; ++column)
      worst = std::max(
          worst, std::abs(brighter.light(column, row).g / plain.light(column, row).g / 2 - 1));
  }
  CHECK(worst < 1e-8);
  CHECK(developed(lesson({"--degrees", "360"}), 4) == developed(lesson({}), 4));
  CHECK(count_different(developed(lesson({"--degrees", "90"}), 4), developed(lesson({}), 4)) >
        1000);
}

TEST_CASE("a PNG of the same sky loses most of the sun: its light is cut off at 1") {
  const LightImage full = sky_of_the_chapter();
  Image png(full.width, full.height);
  for (std::size_t i = 0; i < full.pixels.size(); ++i) {
    const auto byte = [](float x) {
      return static_cast<std::uint8_t>(byte_of_light(static_cast<double>(x), Transfer::srgb));
    };
    png.pixels[i] = {byte(full.pixels[i].r), byte(full.pixels[i].g), byte(full.pixels[i].b)};
  }
  const TemporaryFolder folder;
  save_png(png, folder / "sky.png");
  const Rgb all = energy_of(full), left = energy_of(load_light(folder / "sky.png"));
  const double red_missing = 100 * (1 - left.r / all.r), blue_missing = 100 * (1 - left.b / all.b);
  CHECK(red_missing > 20);
  CHECK(red_missing > blue_missing + 3);  // what is left is bluer
  const auto by_png = prepared<Lesson>({"--sky", folder / "sky.png", "--light", "mis"});
  CHECK(best_lighting(noise_of(by_png.stage.sky)) == SkyLighting::cosine);  // no sun is left
}

TEST_CASE("the program refuses a sky of an odd width, and says which light auto took") {
  const TemporaryFolder folder;
  const std::string program = "\"" TEXMAP_CHAPTER "\" --width 16 --height 9 --samples 2 --out \"" +
                              (folder / "x.png") + "\" ";
  const std::string sky = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 3\nthree texels";
  put(folder / "sky.hdr", {sky.begin(), sky.end()});
  const Outcome odd = run(program + "--sky \"" + (folder / "sky.hdr") + "\"");
  CHECK(odd.status == 1);
  CHECK(has(odd.err, "it is 3 pixels wide, and the width of a sky must be even"));
  CHECK(has(run(program).out, "--light mis\n"));
  CHECK_FALSE(has(run(program + "--light cosine").out, "--light"));
  CHECK(run(program + "--budget levels=1").status == 2);
}
