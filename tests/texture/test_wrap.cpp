// Tests of texture/wrap.hpp: what lies beyond the edges of an image, and of the triangle article
// where it differs; of floor_mapping.hpp. Textures that repeat: published/test_look_up.
#include "texture/wrap.hpp"

#include <doctest.h>

#include "number/dual.hpp"
#include "number/kinds/pack.hpp"
#include "published/uv.hpp"
#include "support/dice.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/texel.hpp"

namespace texmap::test {
namespace {

/// The remainder of a division that rounds down, in whole numbers.
int modulo(int x, int n) { return (x % n + n) % n; }
int mirrored_whole(int x, int n) {
  const int within = modulo(x, 2 * n);
  return within < n ? within : 2 * n - 1 - within;
}

/// How many whole numbers of four periods `wrapped(x, n)` does not take to `expected(x, n)`.
template <class Wrapped, class Expected>
long count_wrong(const Wrapped& wrapped, const Expected& expected) {
  long wrong = 0;
  for (int n = 1; n <= 4096; n += n < 65 ? 1 : n / 4) {
    for (int x = -4 * n; x <= 4 * n; ++x) wrong += wrapped(x, n) != expected(x, n) ? 1 : 0;
  }
  return wrong;
}

TEST_CASE_TEMPLATE("repeat and mirror are those of whole numbers, at every place of eight periods",
                   Real, float, double, long double, Pack<float>, Pack<double>) {
  const auto repeated = [](int x, int n) {
    return static_cast<int>(lane(remainder_of(Real(x), Real(n)), 0));
  };
  const auto mirror = [](int x, int n) {
    return static_cast<int>(lane(mirrored(Real(x), Real(n)), 0));
  };
  CHECK(count_wrong(repeated, modulo) == 0);
  CHECK(count_wrong(mirror, mirrored_whole) == 0);
}

TEST_CASE("over a pole one comes down on the other side, half a turn on; twice is no step at all") {
  for (const int rows : {1, 2, 3, 8}) {
    for (const int columns : {2, 4, 10, 16}) {
      for (int row = -2 * rows; row < 2 * rows; ++row) {
        for (int column = -columns; column < 2 * columns; ++column) {
          const auto at = [&](double x, double y) {
            const auto texel = wrapped_texel(Wrap::spherical, x, y, columns, rows);
            return std::pair(texel.column, texel.row);
          };
          const auto here = at(column, row);
          REQUIRE(at(column + columns / 2, -1 - row) == here);
          REQUIRE(at(column + columns / 2, 2 * rows - 1 - row) == here);
          REQUIRE(at(column, row + 2 * rows) == here);
        }
      }
    }
  }
}

TEST_CASE("inside the image every mode shows the image; the border is seen outside alone") {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border, Wrap::spherical}) {
    for (int row = -6; row < 9; ++row) {
      for (int column = -8; column < 12; ++column) {
        const auto texel = wrapped_texel<double>(wrap, column, row, 4, 3);
        const bool inside = column >= 0 && column < 4 && row >= 0 && row < 3;
        if (inside) CHECK((texel.column == column && texel.row == row));
        CHECK(texel.inside == (inside || wrap != Wrap::border));
      }
    }
  }
}

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
  for (const Wrap wrap : {Wrap::mirror, Wrap::clamp})
    CHECK(wrapped_coordinate(wrap, Real(1)) == Real(1));
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

}  // namespace
}  // namespace texmap::test
