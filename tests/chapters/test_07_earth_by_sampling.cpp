// Chapter 07: the light of a globe under the sky, against what can be known without drawing it.
#include <doctest.h>

#include <cmath>
#include <string>

#include "07_earth_by_sampling/lesson.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "support/whole_numbers.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_07::Lesson;

namespace {

/// The lesson as its program prepares it, with one color in place of the picture if one is given.
Lesson lesson_with(const std::vector<std::string>& words, const Rgb8* paint = nullptr) {
  Lesson lesson = prepared<Lesson>(words);
  if (paint != nullptr) lesson.objects[0].paint.texture.image = Image(1, 1, *paint);
  return lesson;
}

/// What a budget buys for the lesson's picture, which reads each texel so often.
KernelPlan plan_for(const char* budget, const Lesson& lesson, double reads = 0) {
  return plan_surface(parse_budget(budget), lesson.objects[0].paint.texture.image, reads);
}

/// How a film is drawn, apart from its samples.
struct Drawn {
  Size size = {64, 36};
  int threads = 0;
  std::uint32_t seed = 0;
};

/// The film of a lesson: `samples` of a kind for each pixel. In double where the lesson has no
/// other number.
template <class Real>
Film film_of(const Lesson& lesson, SamplerKind kind, int samples, const Drawn& drawn = {},
             const KernelPlan& plan = {}) {
  const View<> view = view_of(lesson.stage.camera, drawn.size.width, drawn.size.height);
  const auto objects = planned_objects(plan, lesson.objects);
  return gather<number_in<Lesson, Real>>(
      lesson, objects, view, {Sampler(kind, samples, drawn.seed)},
      bounds_of_view(lesson, objects, plan.smoothing, samples), {.threads = drawn.threads});
}

/// A film keeps light within 2^-32 of itself.
constexpr double packing = 0x1p-31;

/// Root mean square difference of two films, over pixels and channels.
double apart(const Film& a, const Film& b) { return 2 * error_of_halves(a, b); }

/// How many samples the program says that it drew, and what error it states, in levels of 255.
struct Stated {
  long samples = 0;
  double error = 0;
};
Stated stated_by_program(const std::string& options) {
  const TemporaryFolder folder;
  const Outcome outcome = run("\"" TEXMAP_CHAPTER "\" --width 64 --height 36 --out \"" +
                              (folder / "x.png") + "\" " + options);
  REQUIRE(outcome.status == 0);
  const std::size_t error = outcome.out.find("about ");
  REQUIRE(error != std::string::npos);
  const std::size_t samples = outcome.out.find_last_of('\n', error);
  return {std::stol(outcome.out.substr(samples == std::string::npos ? 0 : samples + 1)),
          std::stod(outcome.out.substr(error + 6))};
}

/// The numbers of one sample, the same whoever draws them.
struct SampledNumbers {
  Sampler sampler;
  std::uint32_t sample;
  std::uint32_t dimension = 0;

  [[nodiscard]] Point2<double> next_2d() {
    return sampler.pair<double>(test::hash_row<double>(7, 3), sample, dimension++);
  }
};

/// Calls `look` with the light of every pixel.
template <class Look>
void for_each_pixel(const Film& film, const Look& look) {
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) look(film.light(column, row));
  }
}

}  // namespace

TEST_CASE("a white globe under a constant sky cannot be told from the sky") {
  const Rgb8 full{255, 255, 255};
  const Film film = film_of<double>(lesson_with({}, &full), SamplerKind::random, 4);
  for_each_pixel(film, [](const Rgb& light) {
    REQUIRE(std::abs(light.r - 0.7) < packing);
    REQUIRE(std::abs(light.b - 1.0) < packing);
  });
  const Rgb8 gray_paint{188, 188, 188};
  CHECK(apart(film, film_of<double>(lesson_with({}, &gray_paint), SamplerKind::random, 4)) > 0.1);
}

TEST_CASE(
    "white globes that light each other are as bright as the sky too, if paths may bounce long "
    "enough") {
  const Rgb8 full{255, 255, 255};
  Lesson lesson = lesson_with({"--bounces", "1000"}, &full);
  lesson.objects.push_back(lesson.objects[0]);
  lesson.objects[1].shape = {{0, -2.5, 0}, 0.5};
  const Film film = film_of<double>(lesson, SamplerKind::sobol, 8);
  double darkest = 1;
  for_each_pixel(film, [&](const Rgb& light) { darkest = std::min(darkest, light.r); });
  CHECK(std::abs(darkest - 0.7) < packing);

  lesson.sampling.bounces = 1;  // a path cut off brings no light
  const Film cut = film_of<double>(lesson, SamplerKind::sobol, 8);
  CHECK(apart(film, cut) > 0.001);
}

TEST_CASE(
    "under a sky that fades with height the light is the closed form: the sky's mean weighed by "
    "Lambert's cosine") {
  // The sky is a + b y for a direction's y; the cosine-weighted mean of y about n is 2/3 of n's y.
  const Rgb8 paint{188, 128, 64};
  Lesson lesson = lesson_with({"--sky", "gradient"}, &paint);
  constexpr std::uint32_t samples = 4096;
  for (const Point aim : {Point{0, 0, 2}, Point{0.7, 1.5, 1.1}, Point{-1.2, -1.4, 0.8}}) {
    const Ray<double> ray{{0, 0, 12}, normalize(aim - Point{0, 0, 12})};
    const Vec3<double> n =
        hit_at(lesson.objects[0].shape, ray, distance_to(lesson.objects[0].shape, ray)).normal;
    Rgb sum{};
    for (std::uint32_t i = 0; i < samples; ++i) {
      SampledNumbers random{Sampler(SamplerKind::sobol, samples), i};
      sum = sum + light_along(lesson.objects, ray, lesson.stage.sky, 50, random);
    }
    const double height = (2.0 / 3 * n.y + 1) / 2;
    CHECK(sum.r / samples ==
          doctest::Approx(srgb_decode(188 / 255.0) * (1 - 0.5 * height)).epsilon(2e-4));
    CHECK(sum.g / samples ==
          doctest::Approx(srgb_decode(128 / 255.0) * (1 - 0.3 * height)).epsilon(2e-4));
    CHECK(sum.b / samples == doctest::Approx(srgb_decode(64 / 255.0)).epsilon(2e-4));
  }
}

TEST_CASE("where a budget makes smooth pixels patches, their light is that of samples, nearly") {
  // A ramp: the next texel is another color, but not by much.
  Image ramp(2048, 1024);
  for (int y = 0; y < ramp.height; ++y) {
    for (int x = 0; x < ramp.width; ++x)
      ramp.at(x, y) = {static_cast<std::uint8_t>(64 + x / 17),
                       static_cast<std::uint8_t>(64 + y / 9),
                       static_cast<std::uint8_t>(64 + std::abs(x - 1024) / 9)};
  }
  Lesson lesson = lesson_with({"--sky", "gradient"});
  lesson.objects[0].paint.texture = {{ramp}, TexelLight::linear};
  const KernelPlan smooth = plan_for("levels=1", lesson);
  KernelPlan plain = smooth, coarse = smooth;
  plain.smoothing = {};
  coarse.smoothing.most_curvature_error = 0.01;  // far more than the budget: now places are off
  const auto film = [&]<class Real>(Real, const KernelPlan& plan, int samples = 32) {
    return film_of<Real>(lesson, SamplerKind::random, samples, {.size = {200, 112}}, plan);
  };
  const Film with = film(1.0, smooth), without = film(1.0, plain);
  CHECK(apart(with, without) > 0);
  CHECK(apart(with, without) < 2e-6);
  CHECK(apart(film(1.0, coarse), without) > 2 * apart(with, without));
  CHECK(apart(with, film(Pack2<Pack<double>>(1.0), smooth)) == 0);
  // Fewer samples than a patch is worth.
  CHECK(apart(film(1.0, smooth, 31), film(1.0, plain, 31)) == 0);
}

TEST_CASE("a budget changes no more of the picture than it allows") {
  const Lesson lesson = lesson_with({});
  const Film exact = film_of<double>(lesson, SamplerKind::sobol, 16);
  const auto off = [&](const char* budget) {
    return apart(exact,
                 film_of<double>(lesson, SamplerKind::sobol, 16, {}, plan_for(budget, lesson)));
  };
  CHECK(off("exact") == 0);
  CHECK(off("texels=0.01") > 0);
  CHECK(off("texels=0.01") < 1e-3);
  CHECK(off("texels=5") > 3 * off("texels=0.01"));
  CHECK_THROWS_AS((void)lesson_with({"--budget", "texels=none"}), UsageError);
}

TEST_CASE("the picture is the same for any number of threads and for packs of any width") {
  const Lesson lesson = lesson_with({"--sky", "gradient"});
  constexpr Size size = {61, 33};
  for (const SamplerKind kind : {SamplerKind::random, SamplerKind::stratified,
                                 SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const Film one = film_of<double>(lesson, kind, 9, {.size = size, .threads = 1});
    CHECK(apart(one, film_of<double>(lesson, kind, 9, {.size = size, .threads = 3})) == 0);
    CHECK(apart(one, film_of<Pack<double>>(lesson, kind, 9, {.size = size})) < 1e-4);
    CHECK(apart(film_of<float>(lesson, kind, 9, {.size = size}),
                film_of<Pack<float>>(lesson, kind, 9, {.size = size})) < 1e-3);
    CHECK(apart(one, film_of<double>(lesson, kind, 9, {.size = size, .seed = 1})) >
          1e-3);  // another seed
  }
}

TEST_CASE(
    "the film's estimate of its error is about right for random samples, and not too small for "
    "patterns") {
  const Lesson lesson = lesson_with({});
  const Film truth = film_of<float>(lesson, SamplerKind::sobol, 8192, {.seed = 99});
  for (const SamplerKind kind :
       {SamplerKind::random, SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const Film film = film_of<float>(lesson, kind, 64);
    const double ratio = film.error / apart(film, truth);
    CHECK(ratio > 0.85);
    if (kind == SamplerKind::random) CHECK(ratio < 1.15);
  }
  CHECK(film_of<float>(lesson, SamplerKind::random, 1).error == infinity<double>());
}

TEST_CASE("a lens blurs what is out of focus and nothing else, and an exposure blurs what moves") {
  const auto film = [](const std::vector<std::string>& words) {
    return film_of<float>(lesson_with(words), SamplerKind::sobol, 64);
  };
  const Film pinhole = film({});
  const double in_focus = apart(pinhole, film({"--defocus", "2", "--focus", "11"}));
  CHECK(apart(pinhole, film({"--defocus", "2", "--focus", "4"})) > 2 * in_focus);
  CHECK(apart(pinhole, film({"--shift", "0.5"})) > in_focus);
}

TEST_CASE("the program draws as many samples as were asked for, or stops at the error that was") {
  CHECK(stated_by_program("").samples == 100);
  CHECK(stated_by_program("--samples 16").samples == 16);
  const Stated coarse = stated_by_program("--samples 4096 --target-error 3");
  const Stated fine = stated_by_program("--samples 4096 --target-error 1");
  CHECK(coarse.error <= 3.005);  // it is told with two decimals
  CHECK(fine.error <= 1.005);
  CHECK(coarse.samples < fine.samples);
  CHECK(fine.samples < 4000);
  CHECK(stated_by_program("--time-limit 1e-6").samples == 16);  // the first pair is always drawn
  // A limit without --samples: pairs that double up to 2^14 samples, then as many as fit into 2^20.
  const Stated most =
      stated_by_program("--width 1 --height 1 --sampler random --target-error 1e-9");
  CHECK(most.samples == 2 * (8 * 4095 + 30 * 16384));
}
