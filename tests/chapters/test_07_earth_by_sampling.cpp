// Chapter 07: the light of a globe under the sky, against what can be known without drawing it.
#include <doctest.h>

#include <cmath>
#include <string>

#include "07_earth_by_sampling/lesson.hpp"
#include "sampling/sampled_numbers.hpp"
#include "support/films.hpp"
#include "support/running.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_07::Lesson;

namespace {

/// The lesson as its program prepares it, in the scene of the book; with one color in place of the
/// picture if one is given.
Lesson lesson_with(std::vector<std::string> words, const Rgb8* paint = nullptr) {
  words.insert(words.end(), {"--scene", "book"});
  Lesson lesson = prepared<Lesson>(words);
  if (paint != nullptr) lesson.objects[0].paint.texture.image = Image(1, 1, *paint);
  return lesson;
}

/// The lesson with its ground, which is as good as a plane; globe and ground each in one color.
Lesson on_ground(Rgb8 globe, Rgb8 ground) {
  Lesson lesson = prepared<Lesson>({"--bounces", "1000"});
  lesson.objects[0].paint.texture.image = Image(1, 1, globe);
  lesson.objects[1] = {{{0, -2 - 1e6, 0}, 1e6}, lesson.objects[1].paint};
  lesson.objects[1].paint.texture.image = Image(1, 1, ground);
  return lesson;
}

/// The light that comes from a point, seen from the lesson's eye: the mean of many samples.
Rgb light_from(const Point& point, const Lesson& lesson) {
  constexpr std::uint32_t samples = 4096;
  const Point eye = lesson.stage.camera.eye;
  const Ray<double> ray{eye, normalize(point - eye)};
  Rgb sum{};
  for (std::uint32_t i = 0; i < samples; ++i) {
    SampledNumbers<double> random{{SamplerKind::sobol, samples}, i};
    sum = sum + light_along(lesson.objects, ray, lesson.stage.sky, lesson.sampling.bounces, random);
  }
  return sum * (1.0 / samples);
}

/// What a budget buys for the lesson's picture, which reads each texel so often.
KernelPlan plan_for(const char* budget, const Lesson& lesson, double reads = 0) {
  return plan_surface(parse_budget(budget), lesson.objects[0].paint.texture.image, reads);
}

/// A film keeps light within 2^-32 of itself.
constexpr double packing = 0x1p-31;

/// How many samples the program says that it drew, and what error it states, in levels of 255.
struct Stated {
  long samples = 0;
  double error = 0;
};
Stated stated_by_program(const std::string& options) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("\"" TEXMAP_CHAPTER "\" --scene book --width 64 --height 36 --out \"" +
          (folder / "x.png") + "\" " + options);
  REQUIRE(outcome.status == 0);
  const std::size_t error = outcome.out.find("about ");
  REQUIRE(error != std::string::npos);
  const std::size_t samples = outcome.out.find_last_of('\n', error);
  return {std::stol(outcome.out.substr(samples == std::string::npos ? 0 : samples + 1)),
          std::stod(outcome.out.substr(error + 6))};
}

}  // namespace

TEST_CASE("a white globe under a constant sky cannot be told from the sky") {
  const Rgb8 full{255, 255, 255};
  const Film film = film_of(lesson_with({}, &full), 4);
  for_each_pixel(film, [](const Rgb& light) {
    REQUIRE(std::abs(light.r - 0.7) < packing);
    REQUIRE(std::abs(light.b - 1.0) < packing);
  });
  const Rgb8 gray_paint{188, 188, 188};
  CHECK(apart(film, film_of(lesson_with({}, &gray_paint), 4)) > 0.1);
}

TEST_CASE(
    "a white globe and a white ground that light each other are as bright as the sky too, if paths "
    "may bounce long enough") {
  const Rgb8 full{255, 255, 255};
  Lesson lesson = on_ground(full, full);
  const Film film = film_of(lesson, 8);
  double darkest = 1;
  for_each_pixel(film, [&](const Rgb& light) { darkest = std::min(darkest, light.r); });
  CHECK(std::abs(darkest - 0.7) < packing);

  lesson.sampling.bounces = 1;  // a path cut off brings no light
  const Film cut = film_of(lesson, 8);
  CHECK(apart(film, cut) > 0.001);
}

TEST_CASE("a black globe takes from the ground the share (radius / distance of its center) cubed") {
  // The share of a plane's light that a sphere hides: cos (r / D)^2, and here cos is r / D.
  const Lesson lesson = on_ground({0, 0, 0}, {188, 188, 188});
  for (const Point& point : {Point{0, -2, 2.5}, Point{3, -2, 1}, Point{-6, -2, 4}}) {
    const double share = std::pow(2 / length(point), 3);
    CHECK(light_from(point, lesson).r ==
          doctest::Approx(0.7 * srgb_decode(188 / 255.0) * (1 - share)).epsilon(1e-3));
  }
}

TEST_CASE("over a black ground the globe has the share of the sky that is above its ground") {
  const Lesson lesson = on_ground({188, 188, 188}, {0, 0, 0});
  for (const Point& n : {Point{0, 0, 1}, Point{0.36, 0.8, 0.48}, Point{-0.6, -0.48, 0.64}}) {
    CHECK(light_from(n * 2.0, lesson).g ==
          doctest::Approx(0.8 * srgb_decode(188 / 255.0) * (1 + n.y) / 2).epsilon(1e-3));
  }
}

TEST_CASE(
    "under a sky that fades with height the light is the closed form: the sky's mean weighed by "
    "Lambert's cosine") {
  // The sky is a + b y for a direction's y; the cosine-weighted mean of y about n is 2/3 of n's y.
  const Rgb8 paint{188, 128, 64};
  Lesson lesson = lesson_with({"--sky", "gradient"}, &paint);
  for (const Point& n : {Point{0, 0, 1}, Point{0.36, 0.8, 0.48}, Point{-0.6, -0.64, 0.48}}) {
    const Rgb light = light_from(n * 2.0, lesson);
    const double height = (2.0 / 3 * n.y + 1) / 2;
    CHECK(light.r == doctest::Approx(srgb_decode(188 / 255.0) * (1 - 0.5 * height)).epsilon(2e-4));
    CHECK(light.g == doctest::Approx(srgb_decode(128 / 255.0) * (1 - 0.3 * height)).epsilon(2e-4));
    CHECK(light.b == doctest::Approx(srgb_decode(64 / 255.0)).epsilon(2e-4));
  }
}

TEST_CASE("where a budget makes smooth pixels patches, their light is that of samples, nearly") {
  // A ramp: the next texel is another color, but not by much.
  const Image ramp = image_of(2048, 1024, [](int x, int y) {
    return Rgb8{static_cast<std::uint8_t>(64 + x / 17), static_cast<std::uint8_t>(64 + y / 9),
                static_cast<std::uint8_t>(64 + std::abs(x - 1024) / 9)};
  });
  Lesson lesson = lesson_with({"--sky", "gradient"});
  lesson.objects[0].paint.texture = {{ramp}, TexelLight::linear};
  const KernelPlan smooth = plan_for("levels=1", lesson);
  KernelPlan plain = smooth, coarse = smooth;
  plain.smoothing = {};
  coarse.smoothing.most_curvature_error = 0.01;  // far more than the budget: now places are off
  const auto film = [&]<class Real>(Real, const KernelPlan& plan, int samples = 32) {
    return film_of<Real>(lesson, samples, {.size = {200, 112}, .kind = SamplerKind::random}, plan);
  };
  const Film with = film(1.0, smooth), without = film(1.0, plain);
  CHECK(apart(with, without) > 0);
  CHECK(apart(with, without) < 2e-6);
  CHECK(apart(film(1.0, coarse), without) > 2 * apart(with, without));
  CHECK(apart(with, film(Pack2<Pack<double>>(1.0), smooth)) == 0);
  // Fewer samples than a patch is worth.
  CHECK(apart(film(1.0, smooth, 11), film(1.0, plain, 11)) == 0);
}

TEST_CASE("a budget changes no more of the picture than it allows") {
  const Lesson lesson = lesson_with({});
  const Film exact = film_of(lesson, 16);
  const auto off = [&](const char* budget) {
    return apart(exact, film_of(lesson, 16, {}, plan_for(budget, lesson)));
  };
  CHECK(off("exact") == 0);
  CHECK(off("texels=0.01") > 0);
  CHECK(off("texels=0.01") < 1e-3);
  CHECK(off("texels=5") > 3 * off("texels=0.01"));
  CHECK_THROWS_AS((void)lesson_with({"--budget", "texels=none"}), UsageError);
}

TEST_CASE("a budget draws a far sphere in float by a form that holds there, or is refused") {
  const auto drawn = [](std::vector<std::string> words) {
    words.insert(words.end(), {"--quiet", "--scene", "book", "--zoom", "1e5"});
    Ready<Lesson> ready("far", words);
    ready.lesson.objects[0].shape.radius = 1e-5;  // 1.2e6 radii away
    ready.build();
    return Session(ready.chosen).draw(ready.lesson, 32, 18);
  };
  const Image exact = drawn({});
  CHECK(count_different(exact, drawn({"--budget", "texels=1"}), 4) == 0);
  CHECK_THROWS_AS((void)drawn({"--number", "float", "--budget", "texels=1e-6"}), UsageError);
}

TEST_CASE("without an object the picture is the sky") {
  Ready<Lesson> ready("sky", {"--quiet", "--scene", "book", "--sky", "constant"});
  ready.build();
  ready.lesson.objects = {};
  const Image sky = Session(ready.chosen).draw(ready.lesson, 16, 9);
  CHECK(count_different(sky, Image(16, 9, sky.pixels[0])) == 0);
  CHECK(sky.pixels[0].b > 0);
}

/// The lesson as somebody writes it who wants double alone.
struct InDouble : Lesson {
  static constexpr About about{.idea = "in double", .numbers = Numbers::only_double};
  Color<double> operator()(const auto& scene, const PixelPlace<double>& at, auto& random) const {
    return Lesson::operator()(scene, at, random);
  }
};
TEST_CASE("a lesson of paths in plain double is drawn in double, whatever was chosen") {
  const Lesson lesson = lesson_with({});
  InDouble plain;
  static_cast<Lesson&>(plain) = lesson;
  const View<> view = view_of(lesson.stage.camera, 32, 18);
  const auto bounds = bounds_of_view(plain.objects, plain.stage.sky, plain.sampling.lens, {}, 16);
  const Film film = gather(plain, plain.objects, view, {Sampler(SamplerKind::sobol, 16, 0)}, bounds,
                           NumberKind::float_pack, {});
  CHECK(apart(film, film_of(lesson, 16, {.size = {32, 18}})) == 0);
}

/// The lesson as somebody writes it who halves all light.
struct InHalfLight : Lesson {
  template <class Real>
  Color<Real> operator()(const auto& scene, const PixelPlace<Real>& at, auto& random) const {
    return Lesson::operator()(scene, at, random) * Real(0.5);
  }
};
TEST_CASE("a reader's lesson has the light of the pixels without an object, too") {
  const Lesson lesson = lesson_with({});
  InHalfLight half;
  static_cast<Lesson&>(half) = lesson;
  const Film film = film_of(half, 16), whole = film_of(lesson, 16);
  CHECK(std::abs(film.light(0, 0).r / whole.light(0, 0).r - 0.5) < 1e-6);      // the sky
  CHECK(std::abs(film.light(32, 18).r / whole.light(32, 18).r - 0.5) < 1e-6);  // the globe
}

TEST_CASE("the picture is the same for any number of threads and for packs of any width") {
  const Lesson lesson = lesson_with({"--sky", "gradient"});
  for (const SamplerKind kind : {SamplerKind::random, SamplerKind::stratified,
                                 SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const Drawn drawn = {.size = {61, 33}, .threads = 1, .kind = kind};
    Drawn on_three = drawn, other_seed = drawn;
    on_three.threads = 3;
    other_seed.seed = 1;
    const Film one = film_of(lesson, 9, drawn);
    CHECK(apart(one, film_of(lesson, 9, on_three)) == 0);
    CHECK(apart(one, film_of<Pack<double>>(lesson, 9, drawn)) < 1e-4);
    CHECK(apart(film_of<float>(lesson, 9, drawn), film_of<Pack<float>>(lesson, 9, drawn)) < 1e-3);
    CHECK(apart(one, film_of(lesson, 9, other_seed)) > 1e-3);
  }
}

TEST_CASE(
    "the film's estimate of its error is about right for random samples, and not too small for "
    "patterns") {
  const Lesson lesson = lesson_with({});
  const Film truth = film_of<float>(lesson, 8192, {.seed = 99});
  for (const SamplerKind kind :
       {SamplerKind::random, SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const Film film = film_of<float>(lesson, 64, {.kind = kind});
    const double ratio = film.error / apart(film, truth);
    CHECK(ratio > 0.85);
    if (kind == SamplerKind::random) CHECK(ratio < 1.15);
  }
  CHECK(film_of<float>(lesson, 1).error == infinity<double>());
}

TEST_CASE("a lens blurs what is out of focus and nothing else, and an exposure blurs what moves") {
  const auto film = [](const std::vector<std::string>& words) {
    return film_of<float>(lesson_with(words), 64);
  };
  const Film pinhole = film({});
  const double in_focus = apart(pinhole, film({"--defocus", "2", "--focus", "11"}));
  CHECK(apart(pinhole, film({"--defocus", "2", "--focus", "4"})) > 2 * in_focus);
  CHECK(apart(pinhole, film({"--shift", "0.5"})) > in_focus);
}

TEST_CASE("the program draws as many samples as were asked for, or stops at the error that was") {
  CHECK(stated_by_program("").samples == 64);
  CHECK(stated_by_program("--samples 16").samples == 16);
  const Stated coarse = stated_by_program("--samples 4096 --target-error 3");
  const Stated fine = stated_by_program("--samples 4096 --target-error 1");
  CHECK(coarse.error <= 3.005);  // it is told with two decimals
  CHECK(fine.error <= 1.005);
  CHECK(coarse.samples < fine.samples);
  CHECK(fine.samples < 4000);
  CHECK(stated_by_program("--time-limit 1e-6").samples == 16);  // the first pair is always drawn
  // A limit without --samples
  const Stated most =
      stated_by_program("--width 1 --height 1 --sampler random --target-error 1e-9");
  CHECK(most.samples == 1 << 20);
}
