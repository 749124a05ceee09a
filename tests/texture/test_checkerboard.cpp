// Tests of common/texture/checkerboard.hpp: the parity of squares.
#include <doctest.h>

#include "support/lanes.hpp"
#include "texture/checkerboard.hpp"

namespace texmap::test {
namespace {

const Rgb even{0.25, 0.5, 0.75};
const Rgb odd{1, 0, 0.125};

/// 'e' for the even color, 'o' for the odd one, '?' for anything else.
template <class Real>
char square_at(const Checkerboard& board, Real u, Real v) {
  const Color<Real> color = board(Uv<Real>{u, v});
  if (color.r == Real(0.25) && color.g == Real(0.5) && color.b == Real(0.75)) return 'e';
  if (color.r == Real(1) && color.g == Real(0) && color.b == Real(0.125)) return 'o';
  return '?';
}

TEST_CASE_TEMPLATE("whole numbers alternate, negative and huge ones included", Real, float, double,
                   long double) {
  for (int i = -1000; i <= 1000; ++i) REQUIRE(is_even(static_cast<Real>(i)) == (i % 2 == 0));
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
  struct Row {
    double u, v;
    char square;
  };
  const Row table[] = {
      {0, 0, 'e'},       {0.125, 0.125, 'e'}, {0.25, 0, 'o'},      {0, 0.25, 'o'},
      {0.25, 0.25, 'e'}, {0.375, 0.125, 'o'}, {0.5, 0.25, 'o'},    {0.5, 0.5, 'e'},
      {0.75, 0.5, 'o'},  {0.875, 0.875, 'e'}, {0.125, 0.875, 'o'}, {1, 0, 'e'},
  };
  for (const Row& row : table) {
    CAPTURE(row.u);
    CAPTURE(row.v);
    CHECK(square_at(board, static_cast<Real>(row.u), static_cast<Real>(row.v)) == row.square);
  }
  CHECK(square_at(board, std::nextafter(Real(0.25), Real(0)), Real(0)) == 'e');
}

TEST_CASE_TEMPLATE("v = 1, a pole, belongs to the last row, as it does for a picture", Real, float,
                   double, long double, Pack<float>, Pack<double>) {
  using T = Scalar<Real>;
  for (const double squares : {1.0, 2.0, 3.0, 2.5, 10.0, 4095.0, 4096.0, 4194303.0}) {
    const Checkerboard board{even, odd, squares};
    CAPTURE(squares);
    for (const double u : {0.0, 0.3, 0.9}) {
      const auto at = [&](T v) {
        return lane(board(Uv<Real>{Real(static_cast<T>(u)), Real(v)}).r, 0);
      };
      const T below = std::nextafter(T(1), T(0));
      CHECK(at(T(1)) == at(below));
      CHECK(at(T(2)) == at(below));
    }
  }
  // A board of one square has one color.
  const Checkerboard one{even, odd, 1};
  CHECK(lane(one(Uv<Real>{Real(0), Real(1)}).r, 0) == T(0.25));
  const Uv<Real> nowhere{Real(0), Real(std::numeric_limits<T>::quiet_NaN())};
  CHECK(lane(one(nowhere).r, 0) == T(1));
}

TEST_CASE_TEMPLATE("below 0 squares go on by floor, so that none is double", Real, float, double,
                   long double) {
  const Checkerboard board{even, odd, 1};
  CHECK(square_at(board, Real(-0.5), Real(0)) == 'o');
  CHECK(square_at(board, Real(-1), Real(0)) == 'o');
  CHECK(square_at(board, Real(-1.5), Real(0)) == 'e');
  CHECK(square_at(board, Real(0), Real(-0.5)) == 'o');
  CHECK(square_at(board, Real(-0.5), Real(-0.5)) == 'e');
  CHECK(square_at(board, Real(-0.5), Real(-1.5)) == 'o');
}

TEST_CASE_TEMPLATE(
    "an even number of squares alternates across the seam, and an odd one puts two equal ones side "
    "by "
    "side",
    Real, float, double, long double) {
  for (int squares = 1; squares <= 40; ++squares) {
    const Checkerboard board{even, odd, static_cast<double>(squares)};
    CAPTURE(squares);
    const bool alike =
        square_at(board, Real(0), Real(0.01)) == square_at(board, below_one<Real>(), Real(0.01));
    CHECK(alike == (squares % 2 == 1));
  }
}

TEST_CASE_TEMPLATE("a pack finds in each lane the square that a single number finds", T, float,
                   double) {
  check_lanes_of_texture<T>(Checkerboard{even, odd, 7});
}

}  // namespace
}  // namespace texmap::test
