// Chapter 09: texture filtering.
#include <doctest.h>

#include <numbers>

#include "09_texture_filtering/comparison.hpp"
#include "09_texture_filtering/ideal.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "support/lesson_laws.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"
#include "texture/uv_inverse.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_09::Lesson;

namespace {

Lesson filtered(const std::string& filter, const std::string& taps = "16") {
  return prepared<Lesson>({"--filter", filter, "--taps", taps});
}

/// The mean light of a picture's pixels, in levels.
double brightness(const Image& image) {
  const Mean mean = mean_of(image, 0, 0, image.width, image.height);
  return (mean.r + mean.g + mean.b) / 3;
}

}  // namespace

TEST_CASE("all numbers draw one picture, but where a texel or a byte is on its edge" *
          NeedsPacks<Lesson>{}) {
  for (const char* filter : {"nearest", "trilinear", "anisotropic"}) {
    CAPTURE(filter);
    const Lesson lesson = filtered(filter, "8");
    const auto in = [&]<class Real>(Real) { return picture<Real>(lesson, 403, 301); };
    const Image reference = in(1.0);
    const Image in_float = in(1.0F);
    expect_same_picture(in(Pack<double>(1)), reference);
    expect_same_picture(in(1.0L), reference, {.pixels = 8});
    expect_same_picture(in(Pack<float>(1)), in_float, {.pixels = 8});
    expect_same_picture(in_float, reference, {.pixels = 6000});  // towards the horizon, in noise
    CHECK(count_different(in_float, reference) > 0);
    if (lesson.needs_footprints())
      expect_same_picture(in_float, reference, {.pixels = 60, .levels = 2});
  }
}

TEST_CASE("packs and double draw the same bytes by each filter" * NeedsPacks<Lesson>{}) {
  for (const char* filter : {"bilinear", "ewa", "stochastic"}) {
    CAPTURE(filter);
    const Lesson lesson = filtered(filter);
    expect_same_picture(picture<Pack2<Pack<double>>>(lesson, 203, 151), picture(lesson, 203, 151));
  }
}

TEST_CASE("near the eye a pixel covers less than a texel, and no filter changes it") {
  const Image bilinear = picture(filtered("bilinear"));
  for (const char* filter : {"trilinear", "anisotropic"}) {
    Image other = picture(filtered(filter));
    long near = 0, far = 0;
    for (int row = 0; row < 600; ++row) {
      for (int column = 0; column < 800; ++column) {
        const bool differs = other.at(column, row) != bilinear.at(column, row);
        (row < 300 ? far : near) += differs ? 1 : 0;
      }
    }
    CHECK(far > 20000);
    CHECK(near < far);
  }
}

TEST_CASE("the errors of the filters on checkers to the horizon, and what they read for them") {
  const auto all = chapter_09::compare_filters(chapter_09::floor_of(Lesson{}), 0, false);
  const auto of = [&](const std::string& name) {
    for (const auto& one : all) {
      if (one.name == name) return one;
    }
    throw std::logic_error(name);
  };
  const double nearest = of("nearest").error;
  CHECK(of("nearest").reads == 1);
  CHECK(of("bilinear").reads == 4);
  CHECK(of("stochastic").reads == 1);
  CHECK(nearest > 0.29);
  CHECK(of("trilinear").error < nearest / 3);
  CHECK(of("anisotropic 8").reads < 40.5);
  CHECK(of("anisotropic 8").error < nearest / 20);
  CHECK(of("anisotropic").error < nearest / 28);
  CHECK(of("ewa").error < nearest / 12);
  CHECK(of("stochastic").error > of("anisotropic").error);  // one read is noise around the mean

  // Against their own ideals: no pyramid, no error; else the pyramid's, or one read's noise.
  CHECK(of("nearest").own_error == 0);
  CHECK(of("bilinear").own_error < 1e-9);
  CHECK(of("trilinear").own_error < of("trilinear").error / 4);
  CHECK(of("anisotropic").own_error < 0.0065);
  CHECK(of("ewa").own_error < 0.009);
  CHECK(of("ewa").own_error > 0.002);
  CHECK(of("stochastic").own_error > 0.3);
}

TEST_CASE("the mean of checkers over a box is exact: known places, and a box cut into small ones") {
  using chapter_09::white_in_box;
  CHECK(white_in_box(0.5, 0.5, 1, 1) == 1);
  CHECK(white_in_box(1.5, 0.5, 1, 1) == 0);
  CHECK(white_in_box(-0.5, -0.5, 0.25, 0.75) == 1);
  CHECK(white_in_box(1, 0.5, 1, 1) == 0.5);
  CHECK(white_in_box(0.75, 0.5, 1, 1) == 0.75);
  CHECK(white_in_box(0.75, 0.75, 1, 1) == 0.625);  // 9/16 + 1/16
  CHECK(white_in_box(7.3, -2.2, 2, 0.3) == doctest::Approx(0.5));
  for (const auto& [x, y, width, height] :
       {std::array{0.3, 0.9, 2.7, 0.4}, std::array{-5.2, 3.1, 0.7, 5.3}}) {
    double sum = 0;
    constexpr int parts = 400;
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; j < parts; ++j) {
        const double at_x = x + ((i + 0.5) / parts - 0.5) * width;
        const double at_y = y + ((j + 0.5) / parts - 0.5) * height;
        sum += std::fmod(std::floor(at_x) + std::floor(at_y) + 100, 2) == 0 ? 1 : 0;
      }
    }
    CHECK(std::abs(white_in_box(x, y, width, height) - sum / (parts * parts)) < 3e-3);
  }
}

TEST_CASE(
    "in levels without a pyramid's mixing, filters show their own ideal but for their texels") {
  constexpr int squares = 8, size = 256;
  const Pyramid pyramid = pyramid_of(light_of(checkers_image(size, squares), TexelLight::linear));
  const auto root_mean_square = [&](Filter filter, double along, double across) {
    const FilteredTexture texture{.pyramid = pyramid, .filter = filter};
    double sum = 0;
    for (int i = 0; i < 500; ++i) {
      const double u = 0.618034 * i, v = 0.414214 * i;
      const Uv<Dual<double>> uv{{u, along / size, 0}, {v, 0, across / size}};
      sum += square(texture.filtered(uv).r - chapter_09::ideal_light(texture, squares, uv));
    }
    return std::sqrt(sum / 500);
  };
  CHECK(root_mean_square(Filter::bilinear, 1, 1) < 1e-12);
  CHECK(root_mean_square(Filter::trilinear, 0.5, 0.5) < 1e-12);  // bilinear in level 0
  CHECK(root_mean_square(Filter::anisotropic, 16, 1) < 1e-12);   // 16 of them in a row
  CHECK(root_mean_square(Filter::trilinear, 4, 4) < 1e-12);      // bilinear in level 2
  CHECK(root_mean_square(Filter::trilinear, 3, 3) > 1e-3);       // two levels, mixed
  CHECK(root_mean_square(Filter::ewa, 12, 1.5) < 0.02);          // texels that are in or out
  CHECK(root_mean_square(Filter::ewa, 12, 1.5) > 1e-6);
}

TEST_CASE("--scene plane leaves the plane as it is, and --scene globe a globe under the sky") {
  const Lesson both = filtered("anisotropic");
  const Lesson plane = prepared<Lesson>({"--scene", "plane"});
  const View<> view = view_of(both.stage.camera, 200, 150);
  const Image with = picture(both, 200, 150), without = picture(plane, 200, 150);
  long globes = 0, wrong = 0;
  for (int row = 0; row < 150; ++row) {
    for (int column = 0; column < 200; ++column) {
      const auto ray = ray_through<double>(view, column, row);
      const bool globe = find_nearest(both.objects, ray).index >= 0;
      globes += globe ? 1 : 0;
      wrong += !globe && with.at(column, row) != without.at(column, row) ? 1 : 0;
    }
  }
  CHECK(globes > 300);
  CHECK(wrong == 0);
  CHECK(count_different(with, without) > globes / 2);

  const Lesson globe = prepared<Lesson>({"--scene", "globe"});
  REQUIRE(globe.objects.size() == 1);
  const View<> upward = view_of(globe.stage.camera, 200, 150);
  for (const double column : {-0.5, 199.5}) {
    const auto lowest = ray_through<double>(upward, column, 149.5);
    CHECK(!(distance_to(globe.floor, lowest) < infinity<double>()));
  }
  // One anisotropic look-up a pixel is near the mean of 64 rays, and one texel is not.
  const auto apart = [&](const char* filter) {
    const Lesson one = prepared<Lesson>({"--scene", "globe", "--filter", filter});
    double sum = 0;
    int pixels = 0;
    for (int row = 60; row < 90; ++row) {
      for (int column = 85; column < 115; ++column) {
        if (square(row - 74.5) + square(column - 99.5) > 120) continue;  // the globe's edge
        double mean = 0;
        for (int i = 0; i < 64; ++i) {
          mean += ray_color<double>(globe, upward, column + (i % 8 - 3.5) / 8,
                                    row + (i / 8 - 3.5) / 8, 1.0 / 8)
                      .g /
                  64;
        }
        sum += square(ray_color<double>(one, upward, column, row, 1.0).g - mean);
        ++pixels;
      }
    }
    return std::sqrt(sum / pixels);
  };
  CHECK(apart("anisotropic") < 0.015);
  CHECK(apart("nearest") > 3 * apart("anisotropic"));
}

TEST_CASE("filters are compared on the lesson's own floor, also where the lesson is not there") {
  const auto of_lesson = chapter_09::floor_of(Lesson{});
  const chapter_09::FloorView alone;
  for (const Vec3d& point : {Vec3d{3, 0, -7}, Vec3d{-40, 0, -900}}) {
    const auto uv = of_lesson.mapping(point), same = alone.mapping(point);
    CHECK(uv.u == same.u);
    CHECK(uv.v == same.v);
  }
  const auto figures = chapter_09::compare_filters(of_lesson, 2, false);
  const auto alike = chapter_09::compare_filters(alone, 1, false);
  REQUIRE(figures.size() == chapter_09::filters_compared);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    CHECK(figures[i].error == alike[i].error);
    CHECK(figures[i].reads == alike[i].reads);
  }
}

TEST_CASE("any number of samples has the same mean: each has a smaller footprint") {
  for (const char* filter : {"trilinear", "anisotropic", "ewa", "stochastic"}) {
    CAPTURE(filter);
    const Lesson lesson = filtered(filter);
    const View<> view = view_of(lesson.stage.camera, 200, 150);
    const auto light = [&](int samples) {
      double sum = 0;
      for (int row = 60; row < 150; ++row) {
        for (int column = 0; column < 200; ++column) {
          double pixel = 0;
          for (int i = 0; i < samples; ++i) {
            const PixelOffset offset = pixel_offset(i);
            pixel += ray_color<double>(lesson, view, column + offset.column, row + offset.row,
                                       1 / std::sqrt(samples))
                         .g;
          }
          sum += pixel / samples;
        }
      }
      return sum / (90 * 200);
    };
    const double one = light(1);
    // One random texel a pixel: its noise, 0.3, over the root of 18,000 pixels, four times.
    const double allowed = lesson.filtering.filter == Filter::stochastic ? 0.009 : 0.003;
    CHECK(std::abs(light(4) - one) < allowed);
    CHECK(std::abs(light(16) - one) < allowed);
  }
}

TEST_CASE("a globe far away shows the mean of its visible half, weighted by projected area") {
  const Image earth = TextureFile{"earth.png"}.load();
  const FilteredTexture texture{.pyramid = pyramid_of(light_of(earth, TexelLight::linear)),
                                .wrap = Wrap::spherical};
  const LightImage light = light_of(earth, TexelLight::linear);
  Color<double> half{}, evenly{};
  double weights = 0, even_weights = 0;
  for (int row = 0; row < light.height; ++row) {
    for (int column = 0; column < light.width; ++column) {
      const double v = 1 - (row + 0.5) / light.height;
      const Vec3d direction = direction_rtiow(Uv<double>{(column + 0.5) / light.width, v});
      const double area = std::sin(std::numbers::pi * v), seen = std::max(direction.z, 0.0) * area;
      const Color<float>& texel = light.at(column, row);
      half = half + Rgb{texel.r, texel.g, texel.b} * seen;
      weights += seen;
      if (direction.z > 0) {
        evenly = evenly + Rgb{texel.r, texel.g, texel.b} * area;
        even_weights += area;
      }
    }
  }
  // The globe fills 6 pixels across; filtered with footprints, each pixel's light times its share.
  const Sphere<> globe{.center = {0, 0, 0}, .radius = 1};
  const Camera camera{.eye = {0, 0, 1000}, .target = {0, 0, 0}, .fov_y_degrees = 0.2};
  const View<> view = view_of(camera, 48, 48);
  Color<double> sum{};
  double pixels = 0;
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 48; ++column) {
      const auto ray = ray_through(view, Dual<double>{double(column), 1.0, 0.0},
                                   Dual<double>{double(row), 0.0, 1.0});
      const Dual<double> distance = distance_to(globe, ray);
      if (!(distance.value < 1e300)) continue;
      const auto uv = uv_rtiow(normal_at(globe, ray, distance));
      sum = sum + texture.filtered(uv);
      pixels += 1;
    }
  }
  CHECK(pixels > 500);
  CHECK(std::abs(sum.r / pixels - half.r / weights) < 0.004);
  CHECK(std::abs(sum.g / pixels - half.g / weights) < 0.004);
  CHECK(std::abs(sum.b / pixels - half.b / weights) < 0.004);
  // Weighted by area alone it is another color.
  CHECK(std::abs(evenly.g / even_weights - half.g / weights) > 0.008);
}

TEST_CASE("a globe with its map turned by half, and u too, is the same picture") {
  const auto with = [](bool turned) {
    Lesson lesson = filtered("anisotropic");
    if (!turned) return lesson;
    const Image map = TextureFile{"earth.png"}.load();
    Image shifted = map;
    for (int row = 0; row < map.height; ++row) {
      for (int column = 0; column < map.width; ++column)
        shifted.at(column, row) = map.at((column + map.width / 2) % map.width, row);
    }
    for (auto& object : lesson.objects) {
      object.paint.texture.pyramid = pyramid_of(light_of(shifted, TexelLight::linear));
      object.paint.mapping.rotation = rotation_y(60 + 180);
    }
    return lesson;
  };
  const Image plain = picture(with(false)), turned = picture(with(true));
  expect_same_picture(plain, turned, {.levels = 1});
  CHECK(count_different(plain, turned) < 20);
  Lesson only_rotated = with(false);
  for (auto& object : only_rotated.objects) object.paint.mapping.rotation = rotation_y(240);
  CHECK(count_different(plain, picture(only_rotated), 1) > 5000);
}

TEST_CASE("the filter decides whether rays bring derivatives") {
  CHECK(!filtered("nearest").needs_footprints());
  CHECK(!filtered("bilinear").needs_footprints());
  for (const char* filter : {"trilinear", "anisotropic", "ewa", "stochastic"})
    CHECK(filtered(filter).needs_footprints());
}

TEST_CASE("a budget takes the cheapest filter that keeps it, and none where no pixel needs one") {
  const auto plan = [](const Lesson& lesson, double levels) {
    return chapter_09::plan_filter(chapter_09::planned_scene(lesson), levels, 400, 300);
  };
  const Lesson lesson = filtered("anisotropic");
  CHECK(plan(lesson, 255).filter == Filter::bilinear);
  CHECK(plan(lesson, 25).filter == Filter::trilinear);
  int taps = 0;
  for (const double levels : {12.0, 7.0, 4.0, 2.8}) {
    const auto chosen = plan(lesson, levels);
    CHECK(chosen.filter == Filter::anisotropic);
    CHECK(chosen.taps > taps);
    taps = chosen.taps;
  }
  CHECK(plan(lesson, 0.001).text.find("no filter is within the budget") != std::string::npos);

  Lesson close =
      lesson;  // a hand above the floor, looking straight down but for the "up" of Camera
  close.stage.camera = {.eye = {0, 0.5, 0}, .target = {0, 0, -0.001}, .fov_y_degrees = 40};
  CHECK(plan(close, 1).filter == Filter::bilinear);
  CHECK(plan(close, 1).text.find("none needs a filter") != std::string::npos);
}

TEST_CASE("wrong options are refused, and a floor that is not there is named") {
  using Words = std::vector<std::string>;
  for (const Words& words :
       {Words{"--taps", "0"}, Words{"--taps", "65"}, Words{"--filter", "sharp"},
        Words{"--wrap", "spherical"}, Words{"--number", "interval"}}) {
    CAPTURE(words[0]);
    CHECK_THROWS_AS(static_cast<void>(prepared<Lesson>(words)), UsageError);
  }
  CHECK_THROWS_WITH_AS(static_cast<void>(prepared<Lesson>({"--floor", "nothing.png"})),
                       doctest::Contains("nothing.png"), FileError);
}

TEST_CASE("a plot of errors needs the floor that they are measured on") {
  CommandLine line("test", "");
  Session session("test", line, Lesson::about);
  CHECK_THROWS_AS(chapter_09::show_sheet(session, {}, "plot.svg", {}), UsageError);
}

TEST_CASE("--help says why there are no intervals") {
  Lesson lesson;
  CommandLine line("09", "");
  lesson.options(line);
  const Session session("09", line, Lesson::about, offers_for(lesson));
  CHECK(line.help().find("not interval: where rounding") != std::string::npos);
}

TEST_CASE("averaging bytes instead of light would make the horizon too dark") {
  const Image image = picture(filtered("anisotropic"));
  const Rgb8 horizon = image.at(400, 181);
  CHECK(std::abs(horizon.g - 187) <= 1);  // half the light of white: the byte 187 or 188
  CHECK(brightness(image) > 100);
}
