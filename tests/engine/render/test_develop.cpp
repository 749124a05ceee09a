// Tests of engine/render/develop.hpp: from light to bytes.
#include <doctest.h>

#include <cmath>

#include "engine/render/develop.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

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
      REQUIRE(bytes.b == byte_of_light(light.b, transfer));
    }
    for (const int threads : {0, 2, 7}) CHECK(develop(film, transfer, threads) == alone);
  }
  CHECK(develop(film, Transfer::srgb) != develop(film, Transfer::sqrt));
}

}  // namespace
}  // namespace texmap::test
