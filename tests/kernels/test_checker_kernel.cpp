// Tests of common/kernels/checker_kernel.hpp: squares without angles, against squares by angles in 50 digits.
#include "checker_kernel.hpp"

#include <doctest.h>

#include "checkerboard.hpp"
#include "mapped.hpp"
#include "worst_error.hpp"

namespace texmap {
namespace {

/// What 50 digits say of a direction.
struct Judged {
  bool even;
  double from_u_edge, from_v_edge;  ///< distance from the nearest edge, in turns and half turns
};

template <class T>
Judged judge(const Vec3<T>& p, int squares) {
  using std::acos;  // the C library's own would be that of double
  static const Reference half_circle = acos(Reference(-1));
  const Reference x = Reference(p.x);
  const Reference y = Reference(p.y);
  const Reference z = Reference(p.z);
  // At z = -0 the reference numbers would find the other end of the seam.
  const Reference u = p.z == 0 ? Reference(p.x < 0 ? 0 : 0.5) : Reference(Reference(0.5) - atan2(z, x) / (2 * half_circle));
  const Reference v = atan2(Reference(sqrt(x * x + z * z)), Reference(-y)) / half_circle;
  const Reference column = floor(u * squares);
  const Reference row = floor(v * squares);
  const auto from_edge = [&](const Reference& w) {
    const Reference scaled = w * squares;
    return static_cast<double>(abs(scaled - floor(scaled + Reference(0.5))) / squares);
  };
  return {(static_cast<int>(column) + static_cast<int>(row)) % 2 == 0, from_edge(u), from_edge(v)};
}

template <class Real>
bool says_even(const Vec3<Scalar<Real>>& p, int squares) {
  const Real yes = select(is_even_square(Vec3<Real>{Real(p.x), Real(p.y), Real(p.z)}, squares), Real(1), Real(0));
  return lane(yes, 0) == 1;
}

/// Directions all over the globe and, for each number of squares, at all distances from edges.
template <class T>
std::vector<Vec3<T>> directions(int squares, int count) {
  std::vector<Vec3<T>> all;
  Dice dice;
  const double smallest = std::log10(static_cast<double>(std::numeric_limits<T>::epsilon())) - 2;
  for (int i = 0; i < count; ++i) {
    long double u = dice.between(0, 1);
    long double v = dice.between(0, 1);
    const int edge = static_cast<int>(dice.between(0, squares));
    if (i % 4 == 1) u = edge / static_cast<long double>(squares) + dice.any_size(smallest, smallest + 4);
    if (i % 4 == 2) v = edge / static_cast<long double>(squares) + dice.any_size(smallest, smallest + 3);
    if (i % 4 == 3) v = abs(dice.any_size(-9, -1));
    const long double a = 2 * std::numbers::pi_v<long double> * u;
    const long double b = std::numbers::pi_v<long double> * v;
    all.push_back(
        {static_cast<T>(-std::sin(b) * std::cos(a)), static_cast<T>(-std::cos(b)), static_cast<T>(std::sin(b) * std::sin(a))});
  }
  return all;
}

TEST_CASE_TEMPLATE("every even number of squares up to 64 is right, but within rounding of an edge", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  int wrong = 0;
  double u_band = 0;
  double v_band = 0;
  for (int squares = 2; squares <= 64; squares += 2) {
    for (const Vec3<T>& p : directions<T>(squares, 500)) {
      const Judged judged = judge(p, squares);
      if (says_even<Real>(p, squares) == judged.even) continue;
      ++wrong;
      // The nearer edge is to blame.
      double& band = judged.from_u_edge < judged.from_v_edge ? u_band : v_band;
      band = std::max(band, std::min(judged.from_u_edge, judged.from_v_edge));
    }
  }
  const double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  MESSAGE(sizeof(T) << " bytes: " << wrong << " of 16000 wrong, within " << u_band / epsilon << " epsilons in u, "
                    << v_band / epsilon << " in v");
  // Without more digits than T's nobody can say how near an edge is.
  if (std::numeric_limits<Reference>::digits <= std::numeric_limits<T>::digits) return;
  CHECK(u_band <= epsilon / 16);
  CHECK(v_band <= epsilon / 8);
  // Only double's inputs are fine enough, and many enough, to come near the bounds.
  if (sizeof(T) == 8) {
    CHECK(epsilon / 16 <= 2 * u_band);
    CHECK(epsilon / 8 <= 2 * v_band);
  }
}

TEST_CASE_TEMPLATE("on the axes and the planes between them it is Checkerboard's square, edges and poles too", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  const double values[] = {0.0, -0.0, 1.0, -1.0};
  for (int squares = 2; squares <= 64; squares += 2) {
    const Mapped<RtiowMapping, Checkerboard> by_angles{{}, {{1, 1, 1}, {0, 0, 0}, static_cast<double>(squares)}};
    for (const double x : values) {
      for (const double y : values) {
        for (const double z : values) {
          if (x == 0 && y == 0 && z == 0) continue;
          // Only what the angles' formula has exactly: an axis, or the equator along an axis.
          if (abs(x) + abs(y) + abs(z) != 1) continue;
          CAPTURE(squares);
          CAPTURE(x);
          CAPTURE(y);
          CAPTURE(z);
          const Vec3<Real> p{Real(x), Real(y), Real(z)};
          const Uv<Real> uv = uv_rtiow(p);
          const bool even = lane(by_angles.texture(uv).r, 0) == 1;
          CHECK(says_even<Real>({Scalar<Real>(x), Scalar<Real>(y), Scalar<Real>(z)}, squares) == even);
        }
      }
    }
  }
}

TEST_CASE_TEMPLATE("the length of a direction does not matter", Real, TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  int different = 0;
  for (const Vec3<T>& p : directions<T>(10, 400)) {
    for (const T size : {T(0x1p-30), T(0x1p30)}) {
      if (says_even<Real>(p * size, 10) != says_even<Real>(p, 10)) ++different;
    }
  }
  CHECK(different == 0);
}

TEST_CASE("the texture has the two colors") {
  const DirectionCheckerboard board{{1, 0, 0}, {0, 0, 1}, 2};
  CHECK(board(Point{-1, -0.5, 0.1}).r == 1);
  CHECK(board(Point{-1, -0.5, -0.1}).b == 1);
  CHECK(board(Point{-1, 0.5, 0.1}).b == 1);
}

}  // namespace
}  // namespace texmap
