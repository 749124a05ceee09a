// Tests of engine/render/film.hpp and of gather.hpp: packed light, and the error from two halves.
#include <doctest.h>

#include <algorithm>
#include <vector>

#include "engine/render/gather.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

Rgb packed(const Rgb& light) { return PackedLight(light).light(); }

/// The channel of a color by its number.
double channel(const Rgb& c, int k) { return k == 0 ? c.r : k == 1 ? c.g : c.b; }

TEST_CASE("three channels take 16 bytes, and numbers of 32 digits come back as they were") {
  CHECK(sizeof(PackedLight) == 16);
  const double exact[] = {0, 1, 0.5, 0.75, 255, 0x1.fffffffep+0, 0x1p-1022, 0x1p1023, 1.0 / 1024};
  for (const double r : exact) {
    for (const double g : exact) {
      for (const double b : exact) {
        const Rgb light = packed({r, g, b});
        REQUIRE((light.r == r && light.g == g && light.b == b));
      }
    }
  }
  CHECK(packed({}).g == 0);
  CHECK(PackedLight().light().r == 0);
}

TEST_CASE("packed light is within 2^-32 of itself in each channel, and nearly so far at worst") {
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto any = [&] { return std::abs(dice.any_size(-300, 300)); };
    const Rgb light{any(), any(), i % 2 == 0 ? any() : dice.between(1, 2)};
    const Rgb kept = packed(light);
    for (int k = 0; k < 3; ++k)
      worst = std::max(worst, std::abs(channel(kept, k) / channel(light, k) - 1));
  }
  CHECK(worst <= 0x1p-32 * (1 + 1e-9));
  CHECK(worst > 0.99 * 0x1p-32);
}

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

TEST_CASE("the error of the mean of two halves is half their difference, over all channels") {
  Film first(2, 1, 5), second(2, 1, 5);
  CHECK(error_of_halves(first, second) == 0);
  second.set_light(0, 0, {1, 0, 0});  // one of six channels
  CHECK(error_of_halves(first, second) == doctest::Approx(0.5 / std::sqrt(6.0)).epsilon(1e-12));
  second.set_light(0, 0, {1, 1, 1});
  second.set_light(1, 0, {1, 1, 1});
  CHECK(error_of_halves(first, second) == 0.5);
}

const SampleRange two_samples{Sampler(SamplerKind::random, 2)};

TEST_CASE(
    "the error of a growing film is that of its finished rows, and of its halves at the end") {
  std::vector<double> told;
  GrowingFilm film(4, 2, two_samples, [&](double error) { told.push_back(error); });
  for (int column = 0; column < 4; ++column) film.set({column, 0}, {1, 1, 1}, {0, 0, 0});
  for (int column = 0; column < 4; ++column) film.set({column, 1}, {1, 1, 1}, {1, 1, 1});
  CHECK(told.empty());
  film.finish_rows(0, 1);
  film.finish_rows(1, 2);  // a row without a difference
  REQUIRE(told.size() == 2);
  CHECK(told[0] == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(told[1] == doctest::Approx(std::sqrt(0.125)).epsilon(1e-12));
  const Film done = film.take();
  CHECK(done.error == told[1]);
  CHECK(done.light(0, 0).r == 0.5);
  CHECK(done.light(0, 1).r == 1);
}

TEST_CASE("of an odd number of samples the second half has one more, and one sample has no error") {
  GrowingFilm five(1, 1, {Sampler(SamplerKind::random, 5)}, {});
  CHECK(five.first() == 2);
  CHECK(five.second() == 3);
  five.set({0, 0}, {2, 0, 0}, {3, 3, 0});  // means 1 and 1, 0 and 1
  five.finish_rows(0, 1);
  const Film film = five.take();
  CHECK(film.light(0, 0).r == doctest::Approx(1).epsilon(1e-9));
  CHECK(film.light(0, 0).g == doctest::Approx(0.6).epsilon(1e-9));
  CHECK(film.error == doctest::Approx(0.5 / std::sqrt(3.0)).epsilon(1e-12));

  int told = 0;
  GrowingFilm one(1, 1, {Sampler(SamplerKind::random, 1)}, [&](double) { ++told; });
  one.set({0, 0}, {0, 0, 0}, {1, 1, 1});
  one.finish_rows(0, 1);
  CHECK(told == 0);
  CHECK(one.take().error == infinity<double>());
}

}  // namespace
}  // namespace texmap::test
