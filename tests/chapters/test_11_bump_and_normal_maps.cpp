// Chapter 11: bumps and normal maps.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "11_bump_and_normal_maps/lesson.hpp"
#include "11_bump_and_normal_maps/sheets.hpp"
#include "11_bump_and_normal_maps/studs.hpp"
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

/// The daily exercise's check: mean and standard deviation of each channel of a square.
struct Figures {
  double mean[3], deviation[3];
};
Figures figures_of(const Image& image, int center_column, int center_row, int edge) {
  double sum[3] = {0, 0, 0}, squares[3] = {0, 0, 0};
  for (int row = center_row - edge / 2; row < center_row + edge / 2; ++row) {
    for (int column = center_column - edge / 2; column < center_column + edge / 2; ++column) {
      const Rgb8 p = image.at(column, row);
      const double channels[3] = {1.0 * p.r, 1.0 * p.g, 1.0 * p.b};
      for (int k = 0; k < 3; ++k) {
        sum[k] += channels[k];
        squares[k] += channels[k] * channels[k];
      }
    }
  }
  Figures figures{};
  const double count = static_cast<double>(edge) * edge;
  for (int k = 0; k < 3; ++k) {
    figures.mean[k] = sum[k] / count;
    figures.deviation[k] = std::sqrt(squares[k] / count - figures.mean[k] * figures.mean[k]);
  }
  return figures;
}

/// How many pixels of that square show a ball.
int ball_pixels(int center_column, int center_row, int edge) {
  const double ball_x = center_column < 400 ? -1.5 : 1.5;
  int count = 0;
  for (int row = center_row - edge / 2; row < center_row + edge / 2; ++row) {
    for (int column = center_column - edge / 2; column < center_column + edge / 2; ++column) {
      const Vec3d to_pixel{(column / 799.0 - 0.5) * 8 / 3, (0.5 - row / 599.0) * 2, -1};
      const Sphere<> ball{.center = {ball_x, 0, 0}};
      const Ray<double> ray{{0, 0, 5}, normalize(to_pixel)};
      count += distance_to(ball, ray) < infinity<double>() ? 1 : 0;
    }
  }
  return count;
}

/// A normal map of a lesson's bumps: an image that holds, for each (u, v), their normal relative to
/// dP/du, dP/dv and the globe's normal.
Image normal_map_of(const Lesson& lesson, int width, int height) {
  Image map(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Vec3d n = direction_rtiow(Uv<double>{(column + 0.5) / width, 1 - (row + 0.5) / height});
      const Hit<double> hit{n, n, n, n};
      const Frame<double> frame = frame_about(n);
      const auto uv = uv_rtiow(with_steps(hit, frame, 1.0).normal);
      const TangentFrame<double> along = tangents(TangentRule::from_uv, n, point_by_uv(frame, uv));
      const Vec3d bumped = lesson.bumps(hit, 1.0);
      map.at(column, row) = color_of_normal(
          {dot(bumped, along.tangent), dot(bumped, along.bitangent), dot(bumped, n)});
    }
  }
  return map;
}

/// The lesson with a normal map in place of its heights.
struct MappedLesson {
  Lesson lesson;
  NormalMap<RtiowMapping, BilinearTexture> map;
  Stage stage = lesson.stage;

  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(
        lesson.objects, ray, stage.sky, [&](const auto& object, const Hit<Real>& hit) {
          const Vec3<Real> normal = map(hit, inverse_radius<Real>(object.shape));
          const LightSample<Real> light = sample_light(stage.light, lesson.objects, hit, normal);
          return object.paint(hit) * lambert(lesson.surface, light);
        });
  }
};

/// The picture turned by 90 degrees against the clock.
Image quarter_turned(const Image& image) {
  Image turned(image.height, image.width);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column)
      turned.at(row, image.width - 1 - column) = image.at(column, row);
  }
  return turned;
}

/// Where a plate's large stud is bright: the mean direction from its center, weighted by light.
Vec3d lit_side(const Image& plate, bool u_mirrored) {
  const double center_x = u_mirrored ? 0.58 : 0.42, center_y = 0.56;
  Vec3d sum{};
  for (int row = 0; row < plate.height; ++row) {
    for (int column = 0; column < plate.width; ++column) {
      const double x = (column + 0.5) / plate.width - center_x;
      const double y = 1 - (row + 0.5) / plate.height - center_y;
      if (x * x + y * y > 0.3 * 0.3) continue;
      sum = sum + Vec3d{x, y, 0} * static_cast<double>(plate.at(column, row).r);
    }
  }
  return sum;
}

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

TEST_CASE("at sea, where all nine texels of height are 0, no pixel changes") {
  const Lesson lesson = globe({});
  const Image bumps = drawn(lesson);
  const Image plain = drawn(globe({"--bump", "off"}));
  const LightImage relief = lesson.bump.load();
  const View<> view = view_of(lesson.stage.camera, size, size);
  const GlobeMapping mapping{lesson.turn.rotation(), {}};
  int sea = 0, changed_at_sea = 0, changed = 0;
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const Ray<double> ray = ray_through<double>(view, column, row);
      const double distance = distance_to(lesson.objects[0].shape, ray);
      if (!(distance < infinity<double>())) continue;
      const Uv<double> uv = mapping(normal_at(lesson.objects[0].shape, ray, distance));
      const int middle_column = static_cast<int>(uv.u * relief.width);
      const int middle_row = static_cast<int>((1 - uv.v) * relief.height);
      bool flat = true;
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
          const int at_column = (middle_column + i + relief.width) % relief.width;
          const int at_row = std::clamp(middle_row + j, 0, relief.height - 1);
          flat = flat && relief.at(at_column, at_row).r == 0;
        }
      }
      const bool differs = bumps.at(column, row) != plain.at(column, row);
      sea += flat ? 1 : 0;
      changed_at_sea += flat && differs ? 1 : 0;
      changed += differs ? 1 : 0;
    }
  }
  CHECK(sea > 20000);
  CHECK(changed_at_sea == 0);
  CHECK(changed > 5000);
}

TEST_CASE("the Earth's bumps have no seam, and their normals are finite at the poles") {
  const Lesson lesson = globe({"--degrees", "0"});
  double worst = 0;
  for (int i = 1; i < 200; ++i) {
    const double v = i / 200.0;
    const auto normal_at_u = [&](double u) {
      const Vec3d n = direction_rtiow(Uv<double>{u, v});
      return lesson.bumps(Hit<double>{n, n, n, n}, 1.0);
    };
    worst = std::max(worst, largest(normal_at_u(1e-9) - normal_at_u(1 - 1e-9)));
  }
  CHECK(worst < 1e-4);
  for (const double y : {-1.0, 1.0}) {
    for (const double aside : {0.0, 1e-300, 1e-12, 1e-6}) {
      const Vec3d n{aside, y, -aside};
      const Vec3d normal = lesson.bumps(Hit<double>{n, n, n, n}, 1.0);
      CHECK(length(normal) == doctest::Approx(1).epsilon(1e-9));
      CHECK(normal.y * y >= 0);
    }
  }
}

TEST_CASE("a missing height image is an error with its name, and a wrong option names its range") {
  const TemporaryFolder folder;
  const std::string program = "\"" TEXMAP_CHAPTER "\" --out \"" + (folder / "picture.png") + "\" ";
  const Outcome missing = run(program + "--relief-image no_such_file.png");
  CHECK(missing.status == 1);
  CHECK(missing.err.find("no_such_file.png") != std::string::npos);
  const Outcome wrong = run(program + "--step 0");
  CHECK(wrong.status == 2);
  CHECK(wrong.err.find("--step takes a number from 1e-300 to 1, not '0'") != std::string::npos);
  for (const char* show : {"globe", "sheet", "poles", "daily"}) {
    CAPTURE(show);
    CHECK(run(program + "--width 40 --height 30 --show " + show).status == 0);
    CHECK(run(program + "--width 1 --height 1 --show " + show).status == 0);
  }
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

TEST_CASE("a normal map made from the heights draws their picture within its 8 bits") {
  Lesson lesson = globe({"--degrees", "0", "--relief-from", "space", "--relief", "0.03"});
  const Image expected = drawn(lesson);
  MappedLesson mapped{lesson, {.mapping = {}, .texture = {normal_map_of(lesson, 1024, 512)}}};
  const Image image = drawn(lesson);
  const Image by_map = picture(mapped, size, size);
  int worst = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    worst = std::max(worst, levels_apart(by_map.pixels[i], expected.pixels[i]));
  MESSAGE("worst " << worst << " levels; " << count_different(by_map, expected, 1)
                   << " pixels by more than one of " << size * size);
  CHECK(worst <= 4);
  expect_same_picture(by_map, expected, {.pixels = size * size / 100, .levels = 2});
  SUBCASE("and the map read with green down does not") {
    mapped.map.green = Green::down;
    CHECK(count_different(picture(mapped, size, size), expected, 4) > 5000);
  }
}

TEST_CASE("heights and lamp turned together give the same picture, turned") {
  // These waves are the same after a quarter turn about the axis that points at the eye.
  Lesson lesson = globe({"--relief-from", "space", "--relief", "0.03"});
  const Image before = drawn(lesson);
  const Point lamp = lesson.stage.light.position;
  lesson.stage.light.position = {-lamp.y, lamp.x, lamp.z};
  expect_same_picture(drawn(lesson), quarter_turned(before), {.levels = 1});
  CHECK(count_different(drawn(lesson), before, 5) > 5000);

  SUBCASE("also the Earth, with lamp and eye turned about the axis") {
    const Image earth = drawn(globe({"--degrees", "170"}));
    Lesson turned = globe({"--degrees", "80"});
    // What was seen at +z is then at +x.
    const auto quarter = [](const Point& p) { return Point{p.z, p.y, -p.x}; };
    turned.stage.light.position = quarter(turned.stage.light.position);
    turned.stage.camera.eye = quarter(turned.stage.camera.eye);
    const long apart = count_different(drawn(turned), earth, 1);
    turned.stage.light.position = {turned.stage.light.position.x, turned.stage.light.position.y,
                                   -turned.stage.light.position.z};
    const long wrong = count_different(drawn(turned), earth, 1);
    MESSAGE(apart << " pixels, with the lamp elsewhere " << wrong);
    CHECK(apart < 100);
    CHECK(wrong > 5000);
  }
}

TEST_CASE("the sheet's words are what the plates show: a bump is lit on the lamp's side") {
  constexpr int plate = 96;
  int bumps = 0;
  for (const TangentRule rule : {TangentRule::from_uv, TangentRule::crossed, TangentRule::fixed}) {
    for (const Reading& reading : eight_readings(rule)) {
      const Image drawn_plate = draw_plate(reading, stud_normals(plate, reading.green), plate);
      const Verdict verdict = verdict_of(reading);
      CAPTURE(verdict.word());
      const double towards_lamp = dot(lit_side(drawn_plate, reading.u_mirrored), to_lamp);
      CHECK((towards_lamp > 0) == verdict.bump);
      bumps += verdict.bump ? 1 : 0;
      // Lit exactly towards the lamp or away from it: a surface. Anywhere else: none.
      const Vec3d side = normalize(lit_side(drawn_plate, reading.u_mirrored));
      const Vec3d lamp_side = normalize(Vec3d{to_lamp.x, to_lamp.y, 0});
      CHECK((std::abs(dot(side, lamp_side)) > 0.99) == verdict.surface);
    }
  }
  CHECK(bumps == 12);
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

TEST_CASE("the daily exercise's figures hold on our picture of its bricks, and show the sky") {
  const Image image = published_bricks(800, 600);
  const Figures left = figures_of(image, 200, 300, 100);
  const Figures right = figures_of(image, 600, 300, 100);
  const Figures published_left{{186.4, 210.8, 247.6}, {29.6, 35.9, 42.2}};
  const Figures published_right{{188.7, 211.7, 248.5}, {18.5, 31.1, 37.3}};
  for (int k = 0; k < 3; ++k) {
    CHECK(std::abs(left.mean[k] - published_left.mean[k]) < 0.051);
    CHECK(std::abs(left.deviation[k] - published_left.deviation[k]) < 0.051);
    CHECK(std::abs(right.mean[k] - published_right.mean[k]) < 0.051);
    CHECK(std::abs(right.deviation[k] - published_right.deviation[k]) < 0.051);
  }
  // Of 10,000 pixels in each square so many show the ball.
  CHECK(ball_pixels(200, 300, 100) == 298);
  CHECK(ball_pixels(600, 300, 100) == 298);
  CHECK(ball_pixels(490, 300, 80) == 6400);  // the ball is here
  // A black ball would have passed: the check demands a mean above 10.
  CHECK(right.mean[0] * (1 - 298 / 10000.0) > 180);
#ifdef TEXMAP_REFERENCE_PLATFORM
  // The published picture's own pixels, row by row.
  std::vector<std::uint8_t> bytes;
  for (const Rgb8 p : image.pixels) bytes.insert(bytes.end(), {p.r, p.g, p.b});
  CHECK(sha256(std::span<const std::uint8_t>(bytes)) ==
        "8f8a4d49a5c33e1fd76dd2b3904ea00525a2246d2c8225f63695a1b509482a65");
#endif
}
