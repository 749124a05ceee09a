// Tests of common/texture/solid_checkerboard.hpp: the parity of cubes.
#include <doctest.h>

#include <cmath>
#include <cstdint>

#include "support/dice.hpp"
#include "support/lanes.hpp"
#include "texture/solid_checkerboard.hpp"

namespace texmap::test {
namespace {

const Rgb even{0.25, 0.5, 0.75};
const Rgb odd{1, 0, 0.125};

/// 'e' for the even color, 'o' for the odd one, '?' for anything else.
template <class Real>
char cube_at(const SolidCheckerboard& board, Real x, Real y, Real z) {
  const Color<Real> color = board(Vec3<Real>{x, y, z});
  if (color.r == Real(0.25) && color.g == Real(0.5) && color.b == Real(0.75)) return 'e';
  if (color.r == Real(1) && color.g == Real(0) && color.b == Real(0.125)) return 'o';
  return '?';
}

/// 1 where the cell of length 1 that `x` lies in is odd: by whole numbers.
template <class Real>
int parity(Real x) {
  return static_cast<int>(static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x))) &
                          1U);
}

/// What `cube_at` should find with cells of length 1.
template <class Real>
char true_cube_at(Real x, Real y, Real z) {
  return ((parity(x) ^ parity(y)) ^ parity(z)) == 0 ? 'e' : 'o';
}

TEST_CASE_TEMPLATE("the eight cubes around the origin alternate", Real, float, double,
                   long double) {
  const SolidCheckerboard board{even, odd, 2};
  for (int i = 0; i < 8; ++i) {
    const Real x = (i & 1) != 0 ? 1 : -1;
    const Real y = (i & 2) != 0 ? 1 : -1;
    const Real z = (i & 4) != 0 ? 1 : -1;
    CAPTURE(i);
    CHECK(cube_at(board, x, y, z) == (x * y * z > 0 ? 'e' : 'o'));
  }
}

TEST_CASE_TEMPLATE("P33: below 0 cubes go on by floor, so that none is double", Real, float, double,
                   long double) {
  const SolidCheckerboard board{even, odd, 1};
  struct Row {
    double at;
    char cube;
  };
  const Row table[] = {{-2, 'e'}, {-1.5, 'e'}, {-1, 'o'}, {-0.5, 'o'}, {-0.0, 'e'},
                       {0, 'e'},  {0.5, 'e'},  {1, 'o'},  {1.5, 'o'}};
  for (const Row& row : table) {
    CAPTURE(row.at);
    CHECK(cube_at(board, Real(row.at), Real(0), Real(0)) == row.cube);
    CHECK(cube_at(board, Real(0), Real(row.at), Real(0)) == row.cube);
    CHECK(cube_at(board, Real(0), Real(0), Real(row.at)) == row.cube);
  }
  CHECK(cube_at(board, Real(-0.5), Real(-0.5), Real(0)) == 'e');
  CHECK(cube_at(board, Real(-0.5), Real(-0.5), Real(-0.5)) == 'o');
  CHECK(cube_at(board, -std::numeric_limits<Real>::denorm_min(), Real(0), Real(0)) == 'o');
}

TEST_CASE_TEMPLATE("a cube's lower faces belong to it, and its upper ones to its neighbors", Real,
                   float, double, long double) {
  const SolidCheckerboard board{even, odd, 0.25};
  for (int i = -1000; i <= 1000; ++i) {
    const Real face = static_cast<Real>(i) * Real(0.25);
    REQUIRE(cube_at(board, face, Real(0), Real(0)) == (i % 2 == 0 ? 'e' : 'o'));
    REQUIRE(cube_at(board, std::nextafter(face, -infinity<Real>()), Real(0), Real(0)) ==
            (i % 2 == 0 ? 'o' : 'e'));
  }
}

TEST_CASE_TEMPLATE("neighbors at 1e12 differ, with cells of any power of two", Real, double,
                   long double) {
  for (const double cell : {0.25, 1.0, 8.0}) {
    const SolidCheckerboard board{even, odd, cell};
    const Real start = Real(1e12) * Real(cell);
    for (int i = 0; i < 1000; ++i) {
      const Real x = start + (static_cast<Real>(i) + Real(0.5)) * Real(cell);
      REQUIRE(cube_at(board, x, Real(0), -x) == 'o');  // -x - 1 is odd where x is even
      REQUIRE(cube_at(board, x, Real(0), Real(0)) == (i % 2 == 0 ? 'e' : 'o'));
      REQUIRE(cube_at(board, -x, Real(0), Real(0)) == (i % 2 == 0 ? 'o' : 'e'));
    }
  }
}

TEST_CASE_TEMPLATE("numbers of cells with a sum that does not fit still give the right color", Real,
                   float, double, long double) {
  const SolidCheckerboard board{even, odd, 1};
  const Real last = std::ldexp(Real(1), std::numeric_limits<Real>::digits) - Real(1);  // odd
  CHECK(cube_at(board, last, Real(0), Real(0)) == 'o');
  CHECK(cube_at(board, last, last - Real(2), Real(1)) == 'o');
  CHECK(cube_at(board, last, last - Real(1), Real(0)) == 'o');
  CHECK(cube_at(board, last, last, Real(0)) == 'e');
  CHECK(cube_at(board, -last, -last, -last) == 'o');
}

TEST_CASE_TEMPLATE(
    "a face that the number holds lies where its cube begins, for every cell length; multiplying "
    "by 1 / cell moves some",
    Real, float, double, long double) {
  int moved = 0;
  for (int cells = 3; cells <= 49; cells += 2) {
    const SolidCheckerboard board{even, odd, static_cast<double>(cells)};
    const Real inverse = Real(1) / static_cast<Real>(cells);
    for (int i = -500; i <= 500; ++i) {
      const Real face = static_cast<Real>(i * cells);
      REQUIRE(cube_at(board, face, Real(0), Real(0)) == (i % 2 == 0 ? 'e' : 'o'));
      if (std::floor(face * inverse) != static_cast<Real>(i)) ++moved;
    }
  }
  MESSAGE("moved: " << moved << " of 24024");
  CHECK(moved > 150);
}

TEST_CASE_TEMPLATE("a point at no place has one of the two colors", Real, float, double,
                   long double) {
  const SolidCheckerboard board{even, odd, 1};
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(cube_at(board, nan, Real(0), Real(0)) == 'o');
  CHECK(cube_at(board, nan, nan, Real(0)) == 'e');
  CHECK(cube_at(board, infinity<Real>(), Real(0), Real(0)) == 'e');
  CHECK(cube_at(board, -infinity<Real>(), Real(0), Real(0)) == 'e');
  CHECK(cube_at(board, Real(1e30L), Real(0), Real(1)) == 'o');
}

TEST_CASE_TEMPLATE("a pack finds in each lane the cube that a single number finds", T, float,
                   double) {
  using Many = Pack<T>;
  Dice dice;
  for (const double cell : {1.0, 0.3}) {
    const SolidCheckerboard board{even, odd, cell};
    for (const double range : {3.0, 1e6, 1e12}) {
      for (int i = 0; i < 500; ++i) {
        check_each_lane<Many>([&board](const auto& p) { return board(p); },
                              any_vectors<Many>(dice, -range, range));
      }
    }
  }
}

}  // namespace
}  // namespace texmap::test
