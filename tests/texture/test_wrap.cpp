// Tests of common/texture/wrap.hpp: what lies beyond the edges of an image.
#include "texture/wrap.hpp"

#include <doctest.h>

#include "number/kinds/pack.hpp"

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

TEST_CASE("a coordinate wrapped at once leads to the neighbors that are wrapped one by one") {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    for (const int n : {1, 2, 3, 8, 37}) {
      for (int x = -4 * n; x < 4 * n; ++x) {
        // A quarter of a texel to the right of the middle of texel x.
        const double place = wrapped_coordinate(wrap, (x + 0.75) / n) * n - 0.5;
        const double left = std::floor(place);
        const Neighbors<double> found = wrapped_neighbors(wrap, left, static_cast<double>(n));
        const auto at = [&](int texel) {
          return wrapped_texel<double>(wrap, texel, 0, n, 1).column;
        };
        // A mirror image exchanges them, and their weights.
        const bool turned = std::abs(place - left - 0.75) < 1e-9;
        const bool edge = wrap == Wrap::clamp && (x < 0 || x >= n);
        if (!edge) REQUIRE(std::abs(place - left - (turned ? 0.75 : 0.25)) < 1e-9);
        REQUIRE((turned ? found.second : found.first) == at(x));
        REQUIRE((turned ? found.first : found.second) == at(x + 1));
      }
    }
  }
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

}  // namespace
}  // namespace texmap::test
