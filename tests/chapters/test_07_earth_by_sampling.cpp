// Chapter 07: the light of a globe under the sky, against what can be known without drawing it.
#include <doctest.h>

#include <cmath>
#include <optional>
#include <regex>
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
      bounds_of_view(lesson, objects, view, plan.smoothing, samples), {.threads = drawn.threads});
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

/// What is known of the lesson's picture before a ray is followed.
std::optional<ViewBounds> known_of(const Lesson& lesson, Size size = {64, 36},
                                   const Smoothing& smoothing = {}) {
  return bounds_of_view(lesson, lesson.objects,
                        view_of(lesson.stage.camera, size.width, size.height), smoothing, 32);
}

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

TEST_CASE(
    "what the scene does not require changes nothing: paths that are followed bring what is known "
    "without them") {
  for (const std::string sky : {"constant", "gradient"}) {
    const Lesson alone = lesson_with({"--sky", sky});
    CHECK(known_of(alone)->light.has_value() == (sky == "constant"));
    Lesson followed =
        alone;  // a second globe that nobody sees makes the first one's paths be followed
    followed.objects.push_back(followed.objects[0]);
    followed.objects[1].shape = {{0, 0, 1000}, 0.001};
    CHECK(apart(film_of<double>(alone, SamplerKind::sobol, 8),
                film_of<double>(followed, SamplerKind::sobol, 8)) < packing);
  }
}

TEST_CASE(
    "where the globe cannot be seen no sample is drawn, and the picture is that of drawing them") {
  Lesson lesson = lesson_with({});
  const View<> view = view_of(lesson.stage.camera, 64, 36);
  const ScreenBounds bounds = screen_bounds(view, lesson.objects[0].shape);
  CHECK(bounds.left > 10);
  CHECK(bounds.right < 54);
  REQUIRE(known_of(lesson).has_value());
  CHECK(known_of(lesson)->objects.left == bounds.left);
  CHECK(known_of(lesson)->light->r == 0.7);
  // Tangents bound the outline: no ray through a pixel outside meets the globe, and some rays just
  // inside each edge do.
  const auto met = [&](double column, double row) {
    return distance_to(lesson.objects[0].shape, ray_through(view, column, row)) <
           infinity<double>();
  };
  bool touched = false;
  for (double row = -0.5; row <= 35.5; row += 0.125) {
    for (double column = -0.5; column <= 63.5; column += 0.125) {
      if (column < bounds.left + 0.5 || column > bounds.right - 0.5)
        REQUIRE_FALSE(met(column, row));
      touched = touched || (column < bounds.left + 1.5 && met(column, row));
    }
  }
  CHECK(touched);
  Lesson everywhere = lesson;
  everywhere.sampling.lens.shift =
      1e-300;  // asks for what is not known beforehand, and moves nothing
  const Film film = film_of<double>(lesson, SamplerKind::random, 4);
  const Film drawn = film_of<double>(everywhere, SamplerKind::random, 4);
  CHECK_FALSE(known_of(everywhere).has_value());
  CHECK(apart(film, drawn) < packing);
}

TEST_CASE(
    "smooth pixels are patches, each pixel is judged by itself, and the light is that of samples "
    "by themselves") {
  // A ramp: the next texel is another color, but not by much.
  Image ramp(2048, 1024);
  for (int y = 0; y < ramp.height; ++y) {
    for (int x = 0; x < ramp.width; ++x) {
      const auto byte = [](int part, int whole) {
        return static_cast<std::uint8_t>(64 + 127 * part / whole);
      };
      ramp.at(x, y) = {byte(x, ramp.width), byte(y, ramp.height),
                       byte(std::abs(2 * x - ramp.width), ramp.width)};
    }
  }
  for (const std::string sky : {"constant", "gradient"}) {
    Lesson lesson = lesson_with({"--sky", sky});
    lesson.objects[0].paint.texture = {{ramp}, TexelLight::linear};
    constexpr Size size = {200, 112};
    const KernelPlan smooth = plan_for("levels=1", lesson);
    KernelPlan plain = smooth;
    plain.smoothing = {};

    const View<> view = view_of(lesson.stage.camera, size.width, size.height);
    const auto scene = prepare_scene<double>(view, lesson.objects, lesson.stage.sky);
    const auto listed = [&](const KernelPlan& plan) {
      PixelLists lists;
      for (int row = 0; row < size.height; ++row)
        add_row<double>(lists, row, size.width, scene, *known_of(lesson, size, plan.smoothing));
      return lists;
    };
    const PixelLists lists = listed(smooth);
    CHECK(lists.misses.size() + lists.patches.size() + lists.others.size() == 200 * 112);
    CHECK(lists.patches.size() > lists.others.size());
    CHECK(listed(plain).patches.empty());

    const auto film = [&]<class Real>(Real, const KernelPlan& plan) {
      return film_of<Real>(lesson, SamplerKind::random, 32, {.size = size}, plan);
    };
    const Film with = film(1.0, smooth);
    const Film without = film(1.0, plain);
    KernelPlan coarse = smooth;  // far more than the budget: now places are off
    coarse.smoothing.most_curvature_error = 0.01;
    CHECK(apart(film(1.0, coarse), without) > 10 * apart(with, without));
    double worst = 0;
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const Rgb a = with.light(column, row);
        const Rgb b = without.light(column, row);
        const auto levels = [](double x, double y) {
          return std::abs(srgb_encode(x) - srgb_encode(y)) * 255;
        };
        worst = std::max({worst, levels(a.r, b.r), levels(a.g, b.g), levels(a.b, b.b)});
      }
    }
    CHECK(worst < 0.2);
    // Fewer samples than a patch is worth.
    const auto few = [&](const KernelPlan& plan) {
      return film_of<double>(lesson, SamplerKind::random, 31, {.size = {50, 28}}, plan);
    };
    CHECK(apart(few(smooth), few(plain)) == 0);
    CHECK(apart(with, film(Pack2<Pack<double>>(1.0), smooth)) == 0);
    CHECK(apart(film(1.0F, smooth), film(Pack<float>(1.0F), smooth)) == 0);
  }
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

TEST_CASE("the error told while a picture is drawn becomes the one told at the end") {
  const Lesson lesson = lesson_with({});
  double told = 0;
  const Film film =
      gather<double>(lesson, lesson.objects, view_of(lesson.stage.camera, 64, 36),
                     {Sampler(SamplerKind::random, 8)}, {},
                     {.threads = 1, .error_so_far = [&](double error) { told = error; }});
  CHECK(film.error > 0);
  CHECK(told == doctest::Approx(film.error).epsilon(1e-12));
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
    "the error falls as each sampler promises, and even patterns are worth many random samples") {
  const Lesson lesson = lesson_with({});
  const Film truth = film_of<float>(lesson, SamplerKind::sobol, 8192, {.seed = 99});
  const auto error = [&](SamplerKind kind, int samples) {
    return apart(truth, film_of<float>(lesson, kind, samples));
  };
  const double random_16 = error(SamplerKind::random, 16);
  const double random_64 = error(SamplerKind::random, 64);
  CHECK(random_16 / random_64 == doctest::Approx(2).epsilon(0.1));
  for (const SamplerKind kind :
       {SamplerKind::stratified, SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const double even_64 = error(kind, 64);
    const double worth = square(random_64 / even_64);
    MESSAGE("sampler " << static_cast<int>(kind) << ": 64 samples are worth " << 64 * worth
                       << " random ones");
    CHECK(worth > 4);
    CHECK(error(kind, 16) / even_64 > 2.2);
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
  const Lesson sharp = lesson_with({});
  const Film pinhole = film_of<float>(sharp, SamplerKind::sobol, 64);
  const double in_focus = apart(
      pinhole,
      film_of<float>(lesson_with({"--defocus", "2", "--focus", "11"}), SamplerKind::sobol, 64));
  const double out_of_focus = apart(
      pinhole,
      film_of<float>(lesson_with({"--defocus", "2", "--focus", "4"}), SamplerKind::sobol, 64));
  CHECK(out_of_focus > 2 * in_focus);
  CHECK(apart(pinhole, film_of<float>(lesson_with({"--shift", "0.5"}), SamplerKind::sobol, 64)) >
        in_focus);
}

TEST_CASE("the program draws as many samples as were asked for, or stops at the error that was") {
  const Stated sixteen = stated_by_program("--samples 16");
  CHECK(sixteen.samples == 16);
  CHECK(sixteen.error > 0);
  CHECK(sixteen.error < 20);
  const Stated coarse = stated_by_program("--samples 4096 --target-error 3");
  const Stated fine = stated_by_program("--samples 4096 --target-error 1");
  CHECK(coarse.error <= 3.005);  // it is told with two decimals
  CHECK(fine.error <= 1.005);
  CHECK(coarse.samples < fine.samples);
  CHECK(fine.samples < 4000);
  CHECK(stated_by_program("--samples 100 --target-error 0.001").samples ==
        48);  // 16 and 32; the next pair would be beyond
}

TEST_CASE(
    "a limit without --samples draws until it is met, up to 2^20 samples, not the usual 100") {
  CHECK(stated_by_program("").samples == 100);
  const Stated fine = stated_by_program("--target-error 0.3");
  CHECK(fine.error <= 0.305);  // it is told with two decimals
  CHECK(fine.samples > 200);
  CHECK(stated_by_program("--time-limit 1e-6").samples == 16);  // the first pair is always drawn
  // A pixel that stays above its error: pairs that double up to 2^14 samples, then as many as fit.
  const Stated most =
      stated_by_program("--width 1 --height 1 --sampler random --target-error 1e-9");
  CHECK(most.samples == 2 * (8 * 4095 + 30 * 16384));
}

TEST_CASE("the rays a second that the program states are columns times rows times samples") {
  const TemporaryFolder folder;
  const Outcome outcome = run("\"" TEXMAP_CHAPTER
                              "\" --width 96 --height 27 --samples 1000 --number double --threads 1"
                              " --out \"" +
                              (folder / "x.png") + "\"");
  REQUIRE(outcome.status == 0);
  const std::regex form("render (\\d+\\.\\d), .*, (\\d+\\.\\d) million rays/s\n$");
  std::smatch part;
  REQUIRE(std::regex_search(outcome.out, part, form));
  const double milliseconds = std::stod(part[1]);
  const double rays = std::stod(part[2]);
  const double expected = 96 * 27 * 1000 / 1000.0;  // thousands a millisecond are millions a second
  REQUIRE(milliseconds > 1);
  CHECK(rays >= expected / (milliseconds + 0.051) - 0.051);
  CHECK(rays <= expected / (milliseconds - 0.051) + 0.051);
}
