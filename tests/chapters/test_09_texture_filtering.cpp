// Chapter 09: texture filtering.
#include <doctest.h>

#include "09_texture_filtering/comparison.hpp"
#include "09_texture_filtering/ideal.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "engine/files/find_texture.hpp"
#include "engine/files/load_image.hpp"
#include "support/lesson_laws.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_09::Lesson;

namespace {

Lesson filtered(const std::string& filter, const std::string& taps = "16") {
  return prepared<Lesson>({"--filter", filter, "--taps", taps});
}

}  // namespace

TEST_CASE("all numbers draw one picture, but where a texel or a byte is on its edge" *
          NeedsPacks<Lesson>{}) {
  for (const char* filter :
       {"nearest", "trilinear", "anisotropic", "bilinear", "ewa", "stochastic"}) {
    CAPTURE(filter);
    const Lesson lesson = filtered(filter, "8");
    const auto in = [&]<class Real>(Real) { return picture<Real>(lesson, 403, 301); };
    const Image reference = in(1.0);
    expect_same_picture(in(Pack2<Pack<double>>(1)), reference);
    if (lesson.filtering.filter == Filter::ewa || lesson.filtering.filter == Filter::stochastic)
      continue;  // texels that are in or out, and other chances
    const Image in_float = in(1.0F);
    expect_same_picture(in(1.0L), reference, {.pixels = 8});
    expect_same_picture(in(Pack<float>(1)), in_float, {.pixels = 8});
    expect_same_picture(in_float, reference, {.pixels = 6000});  // towards the horizon, in noise
    CHECK(count_different(in_float, reference) > 0);
    if (lesson.needs_footprints())
      expect_same_picture(in_float, reference, {.pixels = 60, .levels = 2});
  }
}

TEST_CASE("one read along the footprint is the trilinear filter, and more reads are sharper") {
  const Image one = picture(filtered("anisotropic", "1"), 403, 301);
  expect_same_picture(one, picture(filtered("trilinear"), 403, 301));
  CHECK(count_different(one, picture(filtered("anisotropic", "2"), 403, 301)) > 1000);
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

TEST_CASE("the mean of checkers over a box is exact: known places, and between them") {
  using chapter_09::white_in_box;
  CHECK(white_in_box(0.5, 0.5, 1, 1) == 1);
  CHECK(white_in_box(1.5, 0.5, 1, 1) == 0);
  CHECK(white_in_box(-0.5, -0.5, 0.25, 0.75) == 1);
  CHECK(white_in_box(1, 0.5, 1, 1) == 0.5);
  CHECK(white_in_box(0.75, 0.5, 1, 1) == 0.75);
  CHECK(white_in_box(0.75, 0.75, 1, 1) == 0.625);  // 9/16 + 1/16
  CHECK(white_in_box(7.3, -2.2, 2, 0.3) == doctest::Approx(0.5));
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

TEST_CASE(
    "both globes and every copy of the lesson have one pyramid, level 0 as the file's bytes") {
  const auto lesson = prepared<Lesson>();
  const auto copy = lesson;
  const Pyramid& pyramid = lesson.objects[0].paint.texture.pyramid;
  CHECK(copy.objects[1].paint.texture.pyramid.smaller.pixels.data() ==
        pyramid.smaller.pixels.data());
  CHECK(3 * pyramid.smaller.pixels.size() - pyramid.original.size() < 3 * 2048);
  const Image bytes = load_image(find_texture("earth.png"));
  const float light = light_of_bytes<float>(TexelLight::linear)[bytes.at(700, 300).g];
  CHECK(pyramid.at(700, 300).g == light);
}

TEST_CASE("--scene plane leaves the plane as it is, and --scene globe a globe under the sky") {
  const Lesson both = filtered("anisotropic");
  const Lesson plane = prepared<Lesson>({"--scene", "plane"});
  const Image with = picture(both, 200, 150), without = picture(plane, 200, 150);
  const std::vector<int> seen = objects_seen(both, 200, 150);
  const auto globes = std::count(seen.begin(), seen.end(), 0);
  CHECK(globes > 300);
  CHECK(changed_elsewhere(with, without, seen, {0, 1}) == 0);
  CHECK(count_different(with, without) > globes / 2);

  const Lesson globe = prepared<Lesson>({"--scene", "globe"});
  REQUIRE(globe.objects.size() == 1);
  const View<> upward = view_of(globe.stage.camera, 200, 150);
  for (const double column : {-0.5, 199.5}) {
    const auto lowest = ray_through<double>(upward, column, 149.5);
    CHECK(!(distance_to(globe.floor, lowest) < infinity<double>()));
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
  Chosen chosen("test", Offer{.line = line}, Lesson::about);
  Session session(chosen);
  CHECK_THROWS_AS(chapter_09::show_sheet(session, {}, "plot.svg", {}), UsageError);
}
