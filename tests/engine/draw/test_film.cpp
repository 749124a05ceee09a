// Tests of engine/draw/film.hpp and gather.hpp, means of films and the error of two halves; and
// of develop.hpp, from light to bytes.
#include <doctest.h>

#include <cmath>
#include <vector>

#include "engine/draw/develop.hpp"
#include "engine/draw/gather.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

TEST_CASE("two films make the film of all their samples: each counts by how many it has") {
  Film few(1, 1, 1), many(1, 1, 3);
  few.set_light(0, 0, {1, 0, 8});
  many.set_light(0, 0, {0, 4, 8});
  few.add(many);
  CHECK(few.samples() == 4);
  CHECK(few.light(0, 0).r == 0.25);
  CHECK(few.light(0, 0).g == 3);
  CHECK(few.light(0, 0).b == 8);
}

const Sampler two_samples(SamplerKind::random, 2);

TEST_CASE(
    "the error of a growing film is half the difference of its halves, over the channels of its "
    "finished rows") {
  std::vector<double> told;
  const RenderSettings settings{.error_so_far = [&](double error) { told.push_back(error); }};
  GrowingFilm film(4, 2, two_samples, settings);
  FilmRows upper = film.rows(0, 1), lower = film.rows(1, 2);
  for (int column = 0; column < 4; ++column) film.set(upper, {column, 0}, {1, 1, 1}, {0, 0, 0});
  for (int column = 0; column < 4; ++column) film.set(lower, {column, 1}, {1, 1, 1}, {1, 1, 1});
  CHECK(told.empty());
  film.finish(upper);
  film.finish(lower);  // a row without a difference
  REQUIRE(told.size() == 2);
  CHECK(told[0] == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(told[1] == doctest::Approx(std::sqrt(0.125)).epsilon(1e-12));
  const Film done = film.take();
  CHECK(done.error == told[1]);
  CHECK(done.light(0, 0).r == 0.5);
  CHECK(done.light(0, 1).r == 1);
  Film first(2, 1, 5), second(2, 1, 5);
  second.set_light(0, 0, {1, 0, 0});  // one of six channels
  CHECK(error_of_halves(first, second) == doctest::Approx(0.5 / std::sqrt(6.0)).epsilon(1e-12));
}

TEST_CASE(
    "of an odd number of samples the second half has one more, one sample has no error, and the "
    "film keeps no row that somebody takes") {
  const RenderSettings settings{.error_so_far = {}};
  GrowingFilm five(1, 1, Sampler(SamplerKind::random, 5), settings);
  CHECK(five.first() == 2);
  CHECK(five.second() == 3);
  FilmRows row = five.rows(0, 1);
  five.set(row, {0, 0}, {2, 0, 0}, {3, 3, 0});  // means 1 and 1, 0 and 1
  five.finish(row);
  const Film film = five.take();
  CHECK(film.light(0, 0).g == doctest::Approx(0.6).epsilon(1e-9));
  CHECK(film.error == doctest::Approx(0.5 / std::sqrt(3.0)).epsilon(1e-12));

  double taken = 0;
  const RenderSettings failing{
      .error_so_far = [](double) { FAIL("no error yet"); },
      .take_row = [&](int number, const Rgb* light) { taken = 10 * number + light[0].g; }};
  GrowingFilm one(1, 2, Sampler(SamplerKind::random, 1), failing);
  FilmRows lower = one.rows(1, 2);
  one.set(lower, {0, 1}, {0, 0, 0}, {1, 2, 3});
  one.finish(lower);
  CHECK(taken == 12);
  const Film rest = one.take();
  CHECK(rest.error == infinity<double>());
  CHECK(rest.height() == 0);
}

constexpr Transfer transfers[] = {Transfer::srgb, Transfer::sqrt, Transfer::stb};

TEST_CASE("light becomes bytes by the curve that was asked for") {
  for (int byte = 0; byte < 256; ++byte) {
    CAPTURE(byte);
    REQUIRE(byte_of_light(srgb_decode(byte / 255.0), Transfer::srgb) == byte);
    REQUIRE(byte_of_light(std::pow(byte / 255.0, 2.2), Transfer::stb) == byte);
    REQUIRE(byte_of_light(square(byte / 256.0), Transfer::sqrt) == byte);
  }
  for (const Transfer transfer : transfers) {
    CHECK(byte_of_light(0.0, transfer) == 0);
    CHECK(byte_of_light(-1.0, transfer) == 0);
    CHECK(byte_of_light(std::nan(""), transfer) == 0);
    CHECK(byte_of_light(1.0, transfer) == 255);
    CHECK(byte_of_light(infinity<double>(), transfer) == 255);
  }
}

TEST_CASE("a byte is that of the exact curve, rounded to nearest") {
  for (int i = 0; i <= 100000; ++i) {
    const double light = i / 100000.0;
    REQUIRE(byte_of_light(light, Transfer::srgb) == std::lround(255 * srgb_encode(light)));
  }
}

/// Light of all sizes, in a picture that no pack divides; neighbors often share a channel.
Film any_film() {
  Dice dice;
  Film film(37, 23, 1);
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) {
      const Rgb left = film.light(std::max(column - 1, 0), row);
      const auto any = [&](double same) {
        if (!dice.once_in(3)) return same;
        return dice.once_in(4) ? std::abs(dice.any_size(-9, 1)) : dice.between(0, 1);
      };
      film.set_light(column, row, {any(left.r), any(left.g), any(left.b)});
    }
  }
  return film;
}

TEST_CASE("each pixel of a picture is its own light, and any number of threads develops it") {
  const Film film = any_film();
  for (const Transfer transfer : transfers) {
    const Image alone = develop(film, transfer, 1);
    for (int i = 0; i < film.width() * film.height(); ++i) {
      const Rgb light = film.light(i % film.width(), i / film.width());
      const Rgb8 bytes = alone.at(i % film.width(), i / film.width());
      REQUIRE(bytes.r == byte_of_light(light.r, transfer));
      REQUIRE(bytes.g == byte_of_light(light.g, transfer));
      REQUIRE(bytes.b == byte_of_light(light.b, transfer));
    }
    for (const int threads : {0, 2, 7}) CHECK(develop(film, transfer, threads) == alone);
  }
  CHECK(develop(film, Transfer::srgb) != develop(film, Transfer::sqrt));
}

}  // namespace
}  // namespace texmap::test
