// Chapter 11: bumps and normal maps.
#include <doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "11_bump_and_normal_maps/lesson.hpp"
#include "11_bump_and_normal_maps/sheets.hpp"
#include "11_bump_and_normal_maps/studs.hpp"
#include "engine/files/find_texture.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "support/lesson_laws.hpp"
#include "support/running.hpp"
#include "support/same_picture.hpp"
#include "support/sha256.hpp"
#include "support/shown_values.hpp"
#include "texture/uv_inverse.hpp"

using namespace texmap;
using namespace texmap::test;
using namespace texmap::chapter_11;

namespace {

constexpr int size = 300;

Lesson globe(const std::vector<std::string>& words) { return prepared<Lesson>(words); }
Image drawn(const Lesson& lesson) { return picture(lesson, size, size); }

}  // namespace

TEST_CASE("a constant height changes no pixel, whichever way its slopes are computed") {
  const Image plain = drawn(globe({"--bump", "off"}));
  for (const char* slopes : {"duals", "forward", "central"}) {
    CAPTURE(slopes);
    Lesson lesson = globe({"--slopes", slopes, "--relief", "5"});
    const auto height = Mapped<GlobeMapping, SmoothTexture>{{}, {LightImage(64, 32, {0.5F, 0, 0})}};
    lesson.bumps.height = height;
    CHECK(drawn(lesson) == plain);
  }
  CHECK(count_different(drawn(globe({})), plain) > 5000);
}

TEST_CASE("the Earth's bumps have no seam, and their normals are finite at the poles") {
  const Lesson lesson = globe({"--degrees", "0"});
  double worst = 0;
  for (int i = 1; i < 200; ++i) {
    const double v = i / 200.0;
    const auto normal_at_u = [&](double u) {
      const Vec3d n = direction_rtiow(Uv<double>{u, v});
      return lesson.bumps(Hit<double>{n, n, n}, 1.0);
    };
    worst = std::max(worst, largest(normal_at_u(1e-9) - normal_at_u(1 - 1e-9)));
  }
  CHECK(worst < 1e-4);
  for (const double y : {-1.0, 1.0}) {
    for (const double aside : {0.0, 1e-300, 1e-12, 1e-6}) {
      const Vec3d n{aside, y, -aside};
      const Vec3d normal = lesson.bumps(Hit<double>{n, n, n}, 1.0);
      CHECK(length(normal) == doctest::Approx(1).epsilon(1e-9));
      CHECK(normal.y * y >= 0);
    }
  }
}

TEST_CASE("everything that the program shows can be drawn, and a turntable") {
  const TemporaryFolder folder;
  const std::string program = "\"" TEXMAP_CHAPTER "\" --out \"" + (folder / "picture.png") + "\" ";
  for (const char* show : {"globe", "sheet", "poles", "daily"})
    CHECK(run(program + "--width 1 --height 1 --show " + show).status == 0);
  CHECK(run(program + "--width 20 --height 20 --turntable 3").status == 0);
  CHECK(std::filesystem::exists(folder / "picture_002.png"));
}

TEST_CASE("mountains are bumps in every convention: mirrored (u, v) do not invert them") {
  // In the daily exercise's convention u runs the other way: the same picture, mirrored in space.
  Lesson mirrored_globe = globe({"--convention", "daily", "--degrees", "10"});
  const Point lamp = mirrored_globe.stage.light.position;
  mirrored_globe.stage.light.position = {-lamp.x, lamp.y, lamp.z};
  CHECK(count_different(mirrored(drawn(mirrored_globe)), drawn(globe({})), 1) < 100);
  mirrored_globe.bumps.relief = -mirrored_globe.bumps.relief;
  CHECK(count_different(mirrored(drawn(mirrored_globe)), drawn(globe({})), 1) > 5000);
}

TEST_CASE("green is up or down in the image, in every convention: the normal is exact there") {
  // (128, 218, 218) is (1, 181, 181) / 255: it leans by 45 degrees, and north is up in the image.
  const TemporaryFolder folder;
  const std::string file = folder / "leaning.png";
  save_png(Image(2, 1, {128, 218, 218}), file);
  const Hit<double> hit{.normal = {0, 0, 1}, .point = {0, 0, 1}, .outside = {}};
  for (const char* convention : {"rtiow", "daily", "lecture"}) {
    CAPTURE(convention);
    for (const char* green : {"up", "down"}) {
      const Lesson lesson =
          globe({"--normals", file, "--green", green, "--convention", convention});
      const double north = std::string(green) == "up" ? 181 : -181;
      const double east = std::string(convention) == "daily" ? -1 : 1;  // where u grows
      CHECK(largest(lesson.bumps(hit, 1.0) - normalize(Vec3d{east, north, 181})) < 1e-9);
    }
  }
}

TEST_CASE("a flat normal map leans by sqrt(2) / 255: each byte is within 2 levels of no map") {
  // By so much the cosine differs at most; times 0.88 and 255 that is 1.25, and bytes are cut off.
  const TemporaryFolder folder;
  const std::string file = folder / "flat.png";
  save_png(Image(2, 1, {128, 128, 255}), file);
  const Image plain = drawn(globe({"--bump", "off"}));
  const Image flat = drawn(globe({"--normals", file, "--texture", "earth.png"}));
  CHECK(flat != plain);
  CHECK(count_different(flat, plain, 2) == 0);
}

TEST_CASE("all 16 bits of a height and of a normal count, and alpha is no part of them") {
  BumpOptions options;
  options.image = TEXMAP_TESTS_DIR "/corpus/png_grey16_ramp.png";
  const SharedLight heights = options.load();
  for (int i = 0; i < 64; ++i) CHECK(heights.at(i, 0).r == static_cast<float>(8 * i) / 65535);

  const Hit<double> hit{.normal = {0, 0, 1}, .point = {0, 0, 1}, .outside = {}};
  const Vec3d stored{2 * 32800.0 - 65535, 2 * 56000.0 - 65535, 2 * 56100.0 - 65535};
  const Lesson lesson = globe({"--normals", TEXMAP_TESTS_DIR "/corpus/png_rgba16_normal.png"});
  CHECK(largest(lesson.bumps(hit, 1.0) - normalize(stored)) < 1e-6);
}

TEST_CASE("green down draws what the map with its green turned over draws, byte for byte") {
  const TemporaryFolder folder;
  const std::string file = folder / "turned.png";
  Image map = load_image(find_texture("bricks_normals.png"));
  for (Rgb8& texel : map.pixels) texel.g = static_cast<std::uint8_t>(255 - texel.g);
  save_png(map, file);
  const Image down = drawn(globe({"--normals", "bricks_normals.png", "--green", "down"}));
  CHECK(down == drawn(globe({"--normals", file})));
  CHECK(count_different(down, drawn(globe({"--normals", "bricks_normals.png"})), 5) > 5000);
}

TEST_CASE("all numbers draw the same picture" * NeedsFloat<Lesson>{}) {
  check_all_numbers(globe({"--relief-from", "space", "--relief", "0.03"}), 400);
}

TEST_CASE("differences with a good step draw what duals draw, and with a bad one they do not") {
  const std::vector<std::string> waves = {"--relief-from", "space", "--relief", "0.03"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = waves;
    words.insert(words.end(), more.begin(), more.end());
    return drawn(globe(words));
  };
  const Image duals = with({});
  expect_same_picture(with({"--slopes", "central", "--step", "1e-5"}), duals, {.pixels = 2});
  expect_same_picture(with({"--slopes", "forward", "--step", "1e-5"}), duals, {.levels = 1});
  CHECK(count_different(with({"--slopes", "forward", "--step", "0.02"}), duals, 5) > 3000);
  CHECK(count_different(with({"--slopes", "central", "--step", "1e-15"}), duals, 5) > 2000);
}

TEST_CASE(
    "rule A is wrong where green and v disagree, B where green and u do, C where green is down") {
  for (const Reading& reading : eight_readings(TangentRule::from_uv)) {
    CHECK(verdict_of(reading).bump == ((reading.green == Green::down) == reading.v_down));
  }
  for (const Reading& reading : eight_readings(TangentRule::crossed)) {
    CHECK(verdict_of(reading).bump == ((reading.green == Green::down) == reading.u_mirrored));
  }
  for (const Reading& reading : eight_readings(TangentRule::fixed)) {
    CHECK(verdict_of(reading).bump == (reading.green == Green::up));
    CHECK(verdict_of(reading).surface == ((reading.green == Green::down) == reading.u_mirrored));
  }
}

TEST_CASE("the daily exercise's picture of bricks that show the sky is drawn byte for byte") {
  const Image image = published_bricks(800, 600);
  // The published picture's own pixels, row by row.
  CHECK(sha256({&image.pixels[0].r, 3 * image.pixels.size()}) ==
        "8f8a4d49a5c33e1fd76dd2b3904ea00525a2246d2c8225f63695a1b509482a65");
}
