// Tests of texture/wrapped.hpp and floor_mapping.hpp, and of the triangle article where it differs.
#include <doctest.h>

#include <cmath>
#include <limits>

#include "number/dual.hpp"
#include "published/uv.hpp"
#include "support/dice.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/image_texture.hpp"
#include "texture/wrapped.hpp"

namespace texmap::test {
namespace {

template <class Real>
int texel(Wrap wrap, Real u, int n) {
  return texel_number(wrapped_coordinate(wrap, u), n, TexelRounding::floor);
}

TEST_CASE_TEMPLATE("coordinates far outside come back into [0, 1], and those inside stay", Real,
                   float, double, long double) {
  Dice dice;
  for (int i = 0; i < 20000; ++i) {
    const Real inside = static_cast<Real>(dice.uniform(0, 1));
    const Real any = dice.anything<Real>();
    for (const Wrap wrap : {Wrap::mirror, Wrap::repeat, Wrap::clamp}) {
      REQUIRE(wrapped_coordinate(wrap, any) >= Real(0));
      REQUIRE(wrapped_coordinate(wrap, any) <= Real(1));
      if (inside < Real(1)) REQUIRE(wrapped_coordinate(wrap, inside) == inside);
    }
    REQUIRE(wrapped_coordinate(Wrap::repeat, any) < Real(1));
  }
}

TEST_CASE_TEMPLATE("exact places: a step further, mirrored, at the edge", Real, float, double,
                   long double) {
  struct Row {
    double x, repeat, mirror, clamp;
  };
  for (const Row& row : {Row{-0.25, 0.75, 0.25, 0}, Row{1.25, 0.25, 0.75, 1}, Row{1, 0, 1, 1},
                         Row{3.25, 0.25, 0.75, 1}, Row{2.25, 0.25, 0.25, 1}}) {
    CAPTURE(row.x);
    CHECK(wrapped_coordinate(Wrap::repeat, Real(row.x)) == Real(row.repeat));
    CHECK(wrapped_coordinate(Wrap::mirror, Real(row.x)) == Real(row.mirror));
    CHECK(wrapped_coordinate(Wrap::clamp, Real(row.x)) == Real(row.clamp));
  }
}

TEST_CASE("every texel has the same share of a period; the article's texel 0 has two around 0") {
  constexpr int n = 8;
  constexpr int steps = 1000;  // of a texel
  std::array<int, n> mirror{}, repeat{}, article{};
  for (int i = -n * steps; i < n * steps; ++i) {  // u from -1 to 1
    const double u = (i + 0.5) / (n * steps);
    ++mirror[static_cast<std::size_t>(texel(Wrap::mirror, u, n))];
    ++repeat[static_cast<std::size_t>(texel(Wrap::repeat, u, n))];
    ++article[static_cast<std::size_t>(published::index_triangle(u, n))];
  }
  for (std::size_t k = 0; k < n; ++k) {
    CHECK(mirror[k] == 2 * steps);
    CHECK(repeat[k] == 2 * steps);
    CHECK(article[k] == 2 * steps);
  }
  // It is one run of two texels. In a repeated pattern all others are one wide.
  for (const double u : {-0.99, 0.99}) CHECK(published::index_triangle(u / n, n) == 0);
}

TEST_CASE("the article mirrors at 0 and repeats at 1; mirror mirrors at both") {
  constexpr int n = 16;
  for (int i = 0; i < 10000; ++i) {
    const double u = (i + 0.5) / 10000;
    REQUIRE(published::index_triangle(-u, n) == texel(Wrap::mirror, -u, n));
    REQUIRE(published::index_triangle(1 + u, n) == texel(Wrap::repeat, 1 + u, n));
  }
  CHECK(texel(Wrap::mirror, 1.1, n) == 14);
}

TEST_CASE("derivatives keep their size; in the mirror they turn round") {
  const Dual<double> u{-0.25, 3, 5};
  CHECK(wrapped_coordinate(Wrap::repeat, u).dx == 3);
  CHECK(wrapped_coordinate(Wrap::mirror, u).dx == -3);
  CHECK(wrapped_coordinate(Wrap::mirror, u).dy == -5);
  CHECK(wrapped_coordinate(Wrap::clamp, u).dx == 0);
}

TEST_CASE(
    "on the floor a copy begins at the origin and is as large as it says; it reads from above") {
  const FloorMapping mapping{.size = 8};
  struct Row {
    Vec3d point;
    double u, v;
  };
  for (const Row& row : {Row{{0, 0, 0}, 0.5, 0}, Row{{-4, 0, 0}, 0, 0}, Row{{4, 0, -8}, 1, 1},
                         Row{{2, 0, -2}, 0.75, 0.25}, Row{{0, -7, 4}, 0.5, -0.5}}) {
    const Uv<double> uv = mapping(row.point);
    CHECK(uv.u == row.u);
    CHECK(uv.v == row.v);
  }
}

TEST_CASE("a wrapped texture repeats its colors in u and in v") {
  Image image(2, 2);
  image.at(0, 0) = {255, 0, 0};
  image.at(1, 1) = {0, 255, 0};
  const Wrapped<ImageTexture> tiles{Wrap::repeat, {image}};
  CHECK(tiles(Uv<double>{0.25, 0.75}).r == 1);
  CHECK(tiles(Uv<double>{5.25, -0.25}).r == 1);
  CHECK(tiles(Uv<double>{5.75, -0.75}).g == 1);
}

}  // namespace
}  // namespace texmap::test
