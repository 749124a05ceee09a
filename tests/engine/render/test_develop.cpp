// Tests of engine/render/develop.hpp: from light to bytes, for all numbers and threads.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/render/develop.hpp"
#include "number/kinds/pack2.hpp"
#include "support/dice.hpp"
#include "support/shown_values.hpp"

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

TEST_CASE("a curve of fewer terms moves a byte by as many levels as it states") {
  int worst_by[7] = {};
  for (int i = 0; i <= 100000; ++i) {
    const double light = i / 100000.0;
    const auto exact = std::lround(255 * srgb_encode(light));
    REQUIRE(byte_of_light(light, Transfer::srgb) == exact);
    for (const int terms : {3, 4, 6}) {
      const auto byte = std::lround(byte_of_light(light, Transfer::srgb, terms));
      worst_by[terms] = std::max(worst_by[terms], static_cast<int>(std::abs(byte - exact)));
    }
  }
  CHECK(worst_by[3] == 2);
  CHECK(worst_by[4] == 1);
  CHECK(worst_by[6] == 1);
}

/// Light of all sizes, in a picture that no pack divides.
Film any_film() {
  Dice dice;
  Film film(37, 23, 1);
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) {
      const auto any = [&] {
        return dice.once_in(4) ? std::abs(dice.any_size(-9, 1)) : dice.between(0, 1);
      };
      film.set_light(column, row, {any(), any(), any()});
    }
  }
  return film;
}

TEST_CASE_TEMPLATE("packs and any number of threads develop the picture of double", Real, double,
                   Pack<double>, Pack2<Pack<double>>) {
  const Film film = any_film();
  for (const Transfer transfer : transfers) {
    for (const int terms : {0, 3, 4, 6}) {
      const Image alone = develop<double>(film, transfer, terms, 1);
      for (const int threads : {0, 1, 2, 7})
        CHECK(develop<Real>(film, transfer, terms, threads) == alone);
    }
  }
  CHECK(develop<Real>(film, Transfer::srgb) != develop<Real>(film, Transfer::sqrt));
  CHECK(develop<Real>(film, Transfer::srgb) != develop<Real>(film, Transfer::srgb, 3));
}

}  // namespace
}  // namespace texmap::test
