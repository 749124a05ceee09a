// Tests of common/texture/checkerboard.hpp and solid_checkerboard.hpp: the parity of squares and of
// cubes. That no color is wrong off their edges, tests/extremes searches.
#include <doctest.h>

#include "texture/solid_checkerboard.hpp"

namespace texmap::test {
namespace {

const Rgb even{0.25, 0.5, 0.75};
const Rgb odd{1, 0, 0.125};

/// 'e' for the even color, 'o' for the odd one, '?' for anything else.
template <class Real>
char letter_of(const Color<Real>& color) {
  if (color.r == Real(0.25) && color.g == Real(0.5) && color.b == Real(0.75)) return 'e';
  if (color.r == Real(1) && color.g == Real(0) && color.b == Real(0.125)) return 'o';
  return '?';
}
template <class Real>
char square_at(const Checkerboard& board, Real u, Real v) {
  return letter_of(board(Uv<Real>{u, v}));
}
template <class Real>
char cube_at(const SolidCheckerboard& board, Real x, Real y, Real z) {
  return letter_of(board(Vec3<Real>{x, y, z}));
}

TEST_CASE_TEMPLATE("huge whole numbers have a parity, and what is none has one too", Real, float,
                   double, long double) {
  const Real last = std::ldexp(Real(1), std::numeric_limits<Real>::digits) - Real(1);
  CHECK_FALSE(is_even(last));
  CHECK(is_even(last - Real(1)));
  CHECK_FALSE(is_even(-last));
  CHECK(is_even(Real(1e30L)));
  CHECK(is_even(infinity<Real>()));
  CHECK(is_even(-infinity<Real>()));
  CHECK_FALSE(is_even(std::numeric_limits<Real>::quiet_NaN()));
}

TEST_CASE_TEMPLATE("squares alternate in u and in v", Real, float, double, long double) {
  const Checkerboard board{even, odd, 4};
  for (int i = -8; i <= 8; ++i) {  // below 0 squares go on, so that none is double
    for (int j = -8; j < 8; ++j) {
      const bool is_even = (i + 8) / 2 % 2 == (j + 8) / 2 % 2;
      CHECK(square_at(board, Real(i) / Real(8), Real(j) / Real(8)) == (is_even ? 'e' : 'o'));
    }
  }
  CHECK(square_at(board, std::nextafter(Real(0.25), Real(0)), Real(0)) == 'e');
}

TEST_CASE_TEMPLATE("v = 1, a pole, belongs to the last row, as it does for a picture", Real, float,
                   double, long double) {
  for (const double squares : {1.0, 2.0, 3.0, 2.5, 10.0, 4095.0, 4096.0, 4194303.0}) {
    const Checkerboard board{even, odd, squares};
    CAPTURE(squares);
    const char last = square_at(board, Real(0.3), below_one<Real>());
    CHECK(square_at(board, Real(0.3), Real(1)) == last);
    CHECK(square_at(board, Real(0.3), Real(2)) == last);
  }
}

TEST_CASE_TEMPLATE(
    "a cube's lower faces belong to it, its upper ones to its neighbors, for every length that the "
    "number holds; multiplying by 1 / cell moves some",
    Real, float, double, long double) {
  int moved = 0;
  for (double cell = 0.25; cell <= 49; cell += cell < 1 ? 0.75 : 2) {
    const SolidCheckerboard board{even, odd, cell};
    const Real inverse = Real(1) / static_cast<Real>(cell);
    for (int i = -500; i <= 500; ++i) {
      const Real face = static_cast<Real>(i) * static_cast<Real>(cell);
      const Real below = std::nextafter(face, -infinity<Real>());
      REQUIRE(cube_at(board, face, Real(0), Real(0)) == (i % 2 == 0 ? 'e' : 'o'));
      if (cell <= 1) REQUIRE(cube_at(board, below, Real(0), Real(0)) == (i % 2 == 0 ? 'o' : 'e'));
      moved += std::floor(face * inverse) != static_cast<Real>(i) ? 1 : 0;
    }
  }
  CHECK(moved > 150);
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

}  // namespace
}  // namespace texmap::test
