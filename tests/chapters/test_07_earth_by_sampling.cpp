// Chapter 07: the light of a globe under the sky, against what can be known without drawing it.
#include <doctest.h>

#include <cmath>
#include <tuple>

#include "07_earth_by_sampling/lesson.hpp"
#include "compare/running.hpp"
#include "pictures.hpp"

using namespace texmap;
using chapter_07::Lesson;

namespace {

/// The lesson as its program prepares it, with one color in place of the picture if one is given.
Lesson lesson_with(std::vector<std::string> words, const Rgb8* paint = nullptr) {
  Lesson lesson = test::prepared<Lesson>(std::move(words));
  if (paint != nullptr) lesson.objects[0].paint.texture.exact.image = Image(1, 1, *paint);
  return lesson;
}

/// The film of a lesson: `samples` of a kind for each pixel.
template <class Real>
Film film_of(Lesson lesson, SamplerKind kind, int samples, int width = 64, int height = 36, int threads = 0,
             std::uint32_t seed = 0) {
  Film film(width, height);
  lesson.gathering = {Sampler(kind, samples, seed), samples / 2, &film};
  (void)render<Real>(lesson, view_of(lesson.stage.camera, width, height), {.threads = threads});
  film.count(samples / 2, samples - samples / 2);
  return film;
}

/// Root mean square difference of two films, over pixels and channels.
double apart(const Film& a, const Film& b) {
  double sum = 0;
  for (int row = 0; row < a.height(); ++row) {
    for (int column = 0; column < a.width(); ++column) {
      const Rgb p = a.light(column, row);
      const Rgb q = b.light(column, row);
      sum += square(p.r - q.r) + square(p.g - q.g) + square(p.b - q.b);
    }
  }
  return std::sqrt(sum / (3.0 * a.width() * a.height()));
}

/// How many samples the program says that it drew, and what error it states, in levels of 255.
struct Stated {
  long samples = 0;
  double error = 0;
};
Stated stated_by_program(const std::string& options) {
  const test::TemporaryFolder folder;
  const test::Outcome outcome =
      test::run(std::string(TEXMAP_CHAPTER) + " --width 64 --height 36 --out '" + (folder / "x.png") + "' " + options);
  REQUIRE(outcome.status == 0);
  const std::size_t error = outcome.out.find("about ");
  REQUIRE(error != std::string::npos);
  const std::size_t samples = outcome.out.find_last_of('\n', error);
  return {std::stol(outcome.out.substr(samples == std::string::npos ? 0 : samples + 1)),
          std::stod(outcome.out.substr(error + 6))};
}

/// Numbers for one path after another, the same whoever draws them.
struct Numbers {
  Sampler sampler;
  std::uint32_t sample = 0;
  std::uint32_t dimension = 0;
  [[nodiscard]] Sample2<double> pair() { return sampler.pair<double>(pixel_bits<double>(7, 3), sample, dimension++); }
};

}  // namespace

TEST_CASE("a white globe under a constant sky cannot be told from the sky") {
  const Rgb8 white{255, 255, 255};
  const Film film = film_of<double>(lesson_with({}, &white), SamplerKind::random, 4);
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) {
      const Rgb light = film.light(column, row);
      REQUIRE(std::abs(light.r - 0.7) < 1e-12);
      REQUIRE(std::abs(light.b - 1.0) < 1e-12);
    }
  }
  const Rgb8 gray_paint{188, 188, 188};
  CHECK(apart(film, film_of<double>(lesson_with({}, &gray_paint), SamplerKind::random, 4)) > 0.1);
}

TEST_CASE("white globes that light each other are as bright as the sky too, if paths may bounce long enough") {
  const Rgb8 white{255, 255, 255};
  Lesson lesson = lesson_with({"--bounces", "1000"}, &white);
  lesson.objects.push_back(lesson.objects[0]);
  lesson.objects[1].sphere = {{0, -2.5, 0}, 0.5};
  const Film film = film_of<double>(lesson, SamplerKind::sobol, 8);
  double darkest = 1;
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) darkest = std::min(darkest, film.light(column, row).r);
  }
  CHECK(darkest == doctest::Approx(0.7).epsilon(1e-12));

  lesson.sampling.bounces = 1;  // a path cut off brings no light
  const Film cut = film_of<double>(lesson, SamplerKind::sobol, 8);
  CHECK(apart(film, cut) > 0.001);
}

TEST_CASE("under a sky that fades with height the light is the closed form: the sky's mean weighed by Lambert's cosine") {
  // The sky is a + b y for a direction's y, and the mean of y weighed by the cosine about n is 2/3 of n's y.
  const Rgb8 paint{188, 128, 64};
  Lesson lesson = lesson_with({"--sky", "gradient"}, &paint);
  const auto albedo = [](const auto& object, const auto& hit) { return object.paint(hit); };
  const int samples = 4096;
  for (const Point aim : {Point{0, 0, 2}, Point{0.7, 1.5, 1.1}, Point{-1.2, -1.4, 0.8}}) {
    const Ray<double> ray{{0, 0, 12}, normalize(aim - Point{0, 0, 12})};
    const Vec3<double> n = hit_at(lesson.objects[0].sphere, ray, distance_to(lesson.objects[0].sphere, ray)).normal;
    Numbers numbers{Sampler(SamplerKind::sobol, samples)};
    Rgb sum{};
    for (int i = 0; i < samples; ++i) {
      numbers.sample = static_cast<std::uint32_t>(i);
      numbers.dimension = 0;
      sum = sum + light_along(lesson.objects, ray, lesson.stage.sky, albedo, 50, numbers);
    }
    const double height = (2.0 / 3 * n.y + 1) / 2;
    CHECK(sum.r / samples == doctest::Approx(srgb_decode(188 / 255.0) * (1 - 0.5 * height)).epsilon(2e-4));
    CHECK(sum.g / samples == doctest::Approx(srgb_decode(128 / 255.0) * (1 - 0.3 * height)).epsilon(2e-4));
    CHECK(sum.b / samples == doctest::Approx(srgb_decode(64 / 255.0)).epsilon(2e-4));
  }
}

TEST_CASE("what the scene does not require changes nothing: paths that are followed bring what is known without them") {
  for (const std::string sky : {"constant", "gradient"}) {
    const Lesson alone = lesson_with({"--sky", sky});
    CHECK(alone.foresight(view_of(alone.stage.camera, 64, 36))->light.has_value() == (sky == "constant"));
    Lesson followed = alone;  // a second globe that nobody sees makes the first one's paths be followed
    followed.objects.push_back(followed.objects[0]);
    followed.objects[1].sphere = {{0, 0, 1000}, 0.001};
    CHECK(apart(film_of<double>(alone, SamplerKind::sobol, 8), film_of<double>(followed, SamplerKind::sobol, 8)) < 1e-12);
  }
}

TEST_CASE("where the globe cannot be seen no sample is drawn, and the picture is that of drawing them") {
  Lesson lesson = lesson_with({});
  const View view = view_of(lesson.stage.camera, 64, 36);
  const ScreenBounds bounds = screen_bounds(view, lesson.objects[0].sphere);
  CHECK(bounds.left > 10);
  CHECK(bounds.right < 54);
  REQUIRE(lesson.foresight(view).has_value());
  CHECK(lesson.foresight(view)->objects.left == bounds.left);
  CHECK(lesson.foresight(view)->light->r == 0.7);
  // The outline is closed by tangents: no ray through a pixel outside meets the globe, and some through each edge inside do.
  const auto met = [&](double column, double row) {
    return distance_to(lesson.objects[0].sphere, ray_through(view, column, row)) < infinity<double>();
  };
  bool touched = false;
  for (double row = -0.5; row <= 35.5; row += 0.125) {
    for (double column = -0.5; column <= 63.5; column += 0.125) {
      if (column < bounds.left + 0.5 || column > bounds.right - 0.5) REQUIRE_FALSE(met(column, row));
      touched = touched || (column < bounds.left + 1.5 && met(column, row));
    }
  }
  CHECK(touched);
  Lesson everywhere = lesson;
  everywhere.lens.shift = 1e-300;  // asks for what is not known beforehand, and moves nothing
  const Film film = film_of<double>(lesson, SamplerKind::random, 4);
  const Film drawn = film_of<double>(everywhere, SamplerKind::random, 4);
  CHECK(apart(film, drawn) < 1e-12);
}

TEST_CASE("smooth pixels are patches, each pixel is judged by itself, and the light is that of samples by themselves") {
  // A ramp: the next texel is another color, but not by much.
  Image ramp(2048, 1024);
  for (int y = 0; y < ramp.height; ++y) {
    for (int x = 0; x < ramp.width; ++x) {
      const auto byte = [](int part, int whole) { return static_cast<std::uint8_t>(64 + 127 * part / whole); };
      ramp.at(x, y) = {byte(x, ramp.width), byte(y, ramp.height), byte(std::abs(2 * x - ramp.width), ramp.width)};
    }
  }
  for (const std::string sky : {"constant", "gradient"}) {
    Lesson smooth = lesson_with({"--sky", sky, "--budget", "levels=1", "--quiet"});
    smooth.objects[0].paint.texture.roots = {};
    smooth.objects[0].paint.texture.exact = {.image = ramp, .light = TexelLight::linear};
    Lesson plain = smooth;
    plain.budget.smoothing = {};
    const View view = view_of(smooth.stage.camera, 200, 112);

    PixelLists lists;
    for (int row = 0; row < 112; ++row) {
      add_row<double>(lists, row, 200, smooth.ready<double>(view), *smooth.foresight(view));
    }
    CHECK(lists.beside.size() + lists.patches.size() + lists.others.size() == 200 * 112);
    CHECK(lists.patches.size() > lists.others.size());
    PixelLists unsmoothed;
    for (int row = 0; row < 112; ++row) {
      add_row<double>(unsmoothed, row, 200, plain.ready<double>(view), *plain.foresight(view));
    }
    CHECK(unsmoothed.patches.empty());

    const Film with = film_of<double>(smooth, SamplerKind::random, 32, 200, 112);
    const Film without = film_of<double>(plain, SamplerKind::random, 32, 200, 112);
    Lesson coarse = smooth;  // far more than the budget: now places are off
    coarse.budget.smoothing.most_bend = 0.01;
    CHECK(apart(film_of<double>(coarse, SamplerKind::random, 32, 200, 112), without) > 10 * apart(with, without));
    double worst = 0;
    for (int row = 0; row < 112; ++row) {
      for (int column = 0; column < 200; ++column) {
        const Rgb a = with.light(column, row);
        const Rgb b = without.light(column, row);
        const auto levels = [](double x, double y) { return std::abs(srgb_encode(x) - srgb_encode(y)) * 255; };
        worst = std::max({worst, levels(a.r, b.r), levels(a.g, b.g), levels(a.b, b.b)});
      }
    }
    CHECK(worst < 0.2);
    // Fewer samples than a patch is worth.
    CHECK(apart(film_of<double>(smooth, SamplerKind::random, 31, 50, 28),
                film_of<double>(plain, SamplerKind::random, 31, 50, 28)) == 0);
#ifdef TEXMAP_HAVE_PACKS
    CHECK(apart(with, film_of<Paired<Pack<double>>>(smooth, SamplerKind::random, 32, 200, 112)) == 0);
    CHECK(apart(film_of<float>(smooth, SamplerKind::random, 32, 200, 112),
                film_of<Pack<float>>(smooth, SamplerKind::random, 32, 200, 112)) == 0);
#endif
  }
}

TEST_CASE("a budget changes no more of the picture than it allows") {
  const Film exact = film_of<double>(lesson_with({}), SamplerKind::sobol, 16);
  const double off = apart(exact, film_of<double>(lesson_with({"--budget", "texels=0.01", "--quiet"}), SamplerKind::sobol, 16));
  CHECK(off > 0);
  CHECK(off < 1e-3);
  CHECK(apart(exact, film_of<double>(lesson_with({"--budget", "texels=5", "--quiet"}), SamplerKind::sobol, 16)) > 3 * off);
  CHECK_THROWS_AS((void)lesson_with({"--budget", "texels=none"}), UsageError);
}

TEST_CASE("a curve of fewer terms moves a byte by as many levels as it states, and a budget in levels counts it in") {
  int moved_by_four = 0;
  int moved_by_three = 0;
  for (int i = 0; i <= 100000; ++i) {
    const double light = i / 100000.0;
    const int exact = byte_of_light(light, Transfer::srgb);
    const int four = std::abs(byte_of_light(light, Transfer::srgb, 4) - exact);
    const int three = std::abs(byte_of_light(light, Transfer::srgb, 3) - exact);
    REQUIRE(exact == std::lround(255 * srgb_encode(light)));
    REQUIRE(four <= 1);
    REQUIRE(three <= 2);
    moved_by_four += four;
    moved_by_three += three > 1 ? 1 : 0;
  }
  CHECK(moved_by_four > 0);
  CHECK(moved_by_three > 0);

  // What the curve is off by before bytes are rounded, and what the mapping may cost, are together within the budget.
  for (const auto& [words, terms, limit] : {std::tuple{"levels=0.9", 0, 0.9}, std::tuple{"levels=1", 6, 1.0},
                                            std::tuple{"levels=2", 4, 2.0}, std::tuple{"levels=8", 3, 8.0}}) {
    const Lesson lesson = lesson_with({"--budget", words, "--quiet"});
    CHECK(lesson.sampling.srgb_terms == terms);
    const double curve = terms == 0   ? 0
                         : terms == 6 ? fits::SrgbCurve<6>::worst
                         : terms == 4 ? fits::SrgbCurve<4>::worst
                                      : fits::SrgbCurve<3>::worst;
    const double left = limit - curve;
    const UvChoice& choice = lesson.objects[0].paint.mapping.choice;
    CHECK(choice.worst_levels <= left);
    CHECK(choice.worst_levels > 0.05 * left);  // and not dearer than it has to be
  }
  CHECK(lesson_with({"--budget", "texels=1", "--quiet"}).sampling.srgb_terms == 0);
}

TEST_CASE("the error told while a picture is drawn becomes the one told at the end") {
  const Lesson lesson = lesson_with({});
  const Film film = film_of<double>(lesson, SamplerKind::random, 8);
  CHECK(film.error_so_far() == doctest::Approx(film.error()).epsilon(1e-12));

  Film half_drawn(4, 2);
  half_drawn.begin(1, 1);
  CHECK(half_drawn.error_so_far() == infinity<double>());
  for (int column = 0; column < 4; ++column) half_drawn.add(column, 0, {1, 1, 1}, {0, 0, 0});
  half_drawn.finish_row(0);
  CHECK(half_drawn.error_so_far() == doctest::Approx(0.5).epsilon(1e-12));
  half_drawn.finish_row(1);  // a row without a difference
  CHECK(half_drawn.error_so_far() == doctest::Approx(std::sqrt(0.125)).epsilon(1e-12));
}

TEST_CASE("the picture is the same for any number of threads and for packs of any width") {
  const Lesson lesson = lesson_with({"--sky", "gradient"});
  for (const SamplerKind kind : {SamplerKind::random, SamplerKind::stratified, SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const Film one = film_of<double>(lesson, kind, 9, 61, 33, 1);
    CHECK(apart(one, film_of<double>(lesson, kind, 9, 61, 33, 3)) == 0);
#ifdef TEXMAP_HAVE_PACKS
    CHECK(apart(one, film_of<Pack<double>>(lesson, kind, 9, 61, 33)) < 1e-4);
    CHECK(apart(film_of<float>(lesson, kind, 9, 61, 33), film_of<Pack<float>>(lesson, kind, 9, 61, 33)) < 1e-3);
#endif
    CHECK(apart(one, film_of<double>(lesson, kind, 9, 61, 33, 1, 1)) > 1e-3);  // another seed
  }
}

TEST_CASE("the error falls as each sampler promises, and even patterns are worth many random samples") {
  const Lesson lesson = lesson_with({});
  const Film truth = film_of<float>(lesson, SamplerKind::sobol, 8192, 64, 36, 0, 99);
  const auto error = [&](SamplerKind kind, int samples) { return apart(truth, film_of<float>(lesson, kind, samples)); };
  const double random_16 = error(SamplerKind::random, 16);
  const double random_64 = error(SamplerKind::random, 64);
  CHECK(random_16 / random_64 == doctest::Approx(2).epsilon(0.1));
  for (const SamplerKind kind : {SamplerKind::stratified, SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const double even_64 = error(kind, 64);
    const double worth = square(random_64 / even_64);
    MESSAGE("sampler " << static_cast<int>(kind) << ": 64 samples are worth " << 64 * worth << " random ones");
    CHECK(worth > 4);
    CHECK(error(kind, 16) / even_64 > 2.2);
  }
}

TEST_CASE("the film's estimate of its error is about right for random samples, and not too small for patterns") {
  const Lesson lesson = lesson_with({});
  const Film truth = film_of<float>(lesson, SamplerKind::sobol, 8192, 64, 36, 0, 99);
  for (const SamplerKind kind : {SamplerKind::random, SamplerKind::multi_jitter, SamplerKind::sobol}) {
    const Film film = film_of<float>(lesson, kind, 64);
    const double ratio = film.error() / apart(film, truth);
    CHECK(ratio > 0.85);
    if (kind == SamplerKind::random) CHECK(ratio < 1.15);
  }
  CHECK(film_of<float>(lesson, SamplerKind::random, 1).error() == infinity<double>());
}

TEST_CASE("a lens blurs what is out of focus and nothing else, and an exposure blurs what moves") {
  const Lesson sharp = lesson_with({});
  const Film pinhole = film_of<float>(sharp, SamplerKind::sobol, 64);
  const double in_focus =
      apart(pinhole, film_of<float>(lesson_with({"--defocus", "2", "--focus", "11"}), SamplerKind::sobol, 64));
  const double out_of_focus =
      apart(pinhole, film_of<float>(lesson_with({"--defocus", "2", "--focus", "4"}), SamplerKind::sobol, 64));
  CHECK(out_of_focus > 2 * in_focus);
  CHECK(apart(pinhole, film_of<float>(lesson_with({"--shift", "0.5"}), SamplerKind::sobol, 64)) > in_focus);
}

TEST_CASE("rays start anywhere on the lens, which is as wide as its angle says, and meet in the point in focus") {
  const View view = view_of(Lesson{}.stage.camera, 64, 36);
  const LensOptions lens{.defocus_degrees = 3, .focus_distance = 8};
  const double radius = 8 * std::tan(1.5 * std::numbers::pi / 180);
  const double pixel = view.pixel * 8;  // as wide as this at that distance
  const Ray<double> pinhole = ray_through(view, 20.0, 30.0);
  const auto at_focus = [&](const Ray<double>& ray) {
    return ray.origin + ray.direction * (8 / dot(ray.direction, view.forward));
  };
  Numbers numbers{Sampler(SamplerKind::sobol, 1024)};
  double widest = 0;
  Point sum{};
  for (std::uint32_t i = 0; i < 1024; ++i) {
    numbers.sample = i;
    numbers.dimension = 0;
    const Ray<double> ray = lens.ray(view, 20.0, 30.0, numbers);
    const Point offset = ray.origin - view.eye;
    widest = std::max(widest, length(offset));
    sum = sum + offset;
    REQUIRE(std::abs(dot(offset, view.forward)) < 1e-12);
    REQUIRE(largest(at_focus(ray) - at_focus(pinhole)) < 0.51 * pixel);
  }
  CHECK(widest < radius * (1 + 1e-12));
  CHECK(widest > 0.99 * radius);
  CHECK(length(sum) / 1024 < 0.01 * radius);
}

TEST_CASE("a scene that moves up is seen by an eye that moves down as far") {
  const View view = view_of(Lesson{}.stage.camera, 64, 36);
  const LensOptions lens{.shift = 0.5};
  Numbers numbers{Sampler(SamplerKind::sobol, 1024)};
  double sum = 0;
  for (std::uint32_t i = 0; i < 1024; ++i) {
    numbers.sample = i;
    numbers.dimension = 0;
    const double fallen = view.eye.y - lens.ray(view, 20.0, 30.0, numbers).origin.y;
    REQUIRE(fallen >= 0);
    REQUIRE(fallen <= 0.5);
    sum += fallen;
  }
  CHECK(sum / 1024 == doctest::Approx(0.25).epsilon(0.01));
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
  CHECK(stated_by_program("--samples 100 --target-error 0.001").samples == 48);  // 16 and 32; the next pair would be beyond
}

TEST_CASE("light becomes bytes by the curve that was asked for") {
  for (int byte = 0; byte < 256; ++byte) {
    const double light = srgb_decode(byte / 255.0);
    REQUIRE(byte_of_light(light, Transfer::srgb) == byte);
    REQUIRE(byte_of_light(std::pow(byte / 255.0, 2.2), Transfer::stb) == byte);
  }
  CHECK(byte_of_light(0.25, Transfer::sqrt) == 128);
  CHECK(byte_of_light(2, Transfer::sqrt) == 255);
  CHECK(byte_of_light(std::nan(""), Transfer::srgb) == 0);
  // Seed 2's bytes of light: 184 of 256 remain, and codes 1 to 20 are black.
  const auto& kept = light_of_bytes<double>(TexelLight::stb);
  CHECK(std::count(kept.begin(), kept.end(), 0.0) == 21);
  int levels = 1;
  for (std::size_t i = 1; i < kept.size(); ++i) levels += kept[i] != kept[i - 1] ? 1 : 0;
  CHECK(levels == 184);
}
