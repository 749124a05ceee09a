// Dual numbers: each function's derivative is the textbook's; values are the plain number's.
#include <doctest.h>

#include <cmath>
#include <limits>

#include "number/dual.hpp"
#include "number/kinds/interval.hpp"
#include "support/lanes.hpp"
#include "texture/image_texture.hpp"
#include "texture/uv.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// x, moving by 1 for a step of the first parameter and by 2 for one of the second.
template <class Real>
Dual<Real> moving(const Real& x) {
  return {x, Real(1), Real(2)};
}

/// Checks a function of one number: its value to the bit, its slope to a few roundings.
template <class T, class Function>
void check_slope(const Function& function, T x, T slope) {
  const Dual<T> dual = function(moving(x));
  CAPTURE(x);
  CHECK(alike(dual.value, function(x)));
  const T few = 8 * std::numeric_limits<T>::epsilon();
  CHECK(std::abs(dual.dx - slope) <= few * std::abs(slope));
  CHECK(std::abs(dual.dy - 2 * slope) <= few * std::abs(2 * slope));
}

}  // namespace

TEST_CASE_TEMPLATE("functions have the slopes of the textbook", T, float, double, long double) {
  Dice dice(7);
  for (int i = 0; i < 200; ++i) {
    const T x = static_cast<T>(dice.power_of_ten(-3, 0.5L));
    check_slope<T>([](auto y) { return y * y * y; }, x, 3 * x * x);
    check_slope<T>([](auto y) { return decltype(y)(T(1)) / y; }, x, -1 / (x * x));
    check_slope<T>([](auto y) { return (decltype(y)(T(3)) - y) - -y - y; }, x, T(-1));
    check_slope<T>([](auto y) { return sqrt(y); }, x, 1 / (2 * std::sqrt(x)));
    check_slope<T>([](auto y) { return exp(y); }, x, std::exp(x));
    check_slope<T>([](auto y) { return log1p(y); }, x, 1 / (1 + x));
    check_slope<T>([](auto y) { return sin(y); }, x, std::cos(x));
    check_slope<T>([](auto y) { return cos(y); }, x, -std::sin(x));
    check_slope<T>([](auto y) { return power(y, T(2.5)); }, x, T(2.5) * std::pow(x, T(1.5)));
    check_slope<T>([](auto y) { return atan2(y, decltype(y)(T(2))); }, x, 2 / (4 + x * x));
    check_slope<T>([](auto y) { return atan2(decltype(y)(T(2)), y); }, x, -2 / (4 + x * x));
    check_slope<T>([](auto y) { return abs(-y); }, x, T(1));
    check_slope<T>([](auto y) { return y - floor(y); }, x, T(1));
    check_slope<T>([](auto y) { return max(y, decltype(y)(T(-1))); }, x, T(1));
    check_slope<T>([](auto y) { return min(y, decltype(y)(T(-1))); }, x, T(0));
  }
}

TEST_CASE_TEMPLATE("clamp keeps slopes where it guards against rounding, and not beyond", T, float,
                   double, long double) {
  const Dual<T> zero(T(0)), one(T(1));
  const auto slope = [&](T x) { return clamp(moving(x), zero, one).dx; };
  const T step = std::numeric_limits<T>::epsilon();
  CHECK(slope(T(0)) == 1);
  CHECK(slope(T(0.5)) == 1);
  CHECK(slope(T(1)) == 1);
  CHECK(slope(T(1) + step) == 1);
  CHECK(clamp(moving(T(1) + step), zero, one).value == 1);
  CHECK(slope(T(1) + 4 * step) == 0);
  CHECK(slope(T(-0.25)) == 0);
  CHECK(alike(clamp(moving(std::numeric_limits<T>::quiet_NaN()), zero, one).value, T(0)));
}

TEST_CASE("at a pole and for zero, derivatives are zero, infinite or NaN, and values are plain") {
  for (const double y : {-1.0, 0.0, 1.0}) {
    const Vec3<Dual<double>> p{{0, 1, 0}, {y, 0, 0}, {0, 0, 1}};
    const Uv<Dual<double>> uv = uv_rtiow(p);
    const Uv<double> plain = uv_rtiow(Vec3<double>{0, y, 0});
    CHECK(uv.u.value == plain.u);
    CHECK(uv.v.value == plain.v);
  }
}

TEST_CASE_TEMPLATE("each lane of a pack of duals is the dual of that lane", T, float, double) {
  using Many = Pack<T>;
  Dice dice(9);
  for (int i = 0; i < 200; ++i) {
    const auto slopes = []<class Real>(const Vec3<Real>& p, const Vec3<Real>& step) {
      const Dual<Real> x{p.x, step.x, step.y}, y{p.y, step.y, step.z}, z{p.z, step.z, step.x};
      const Dual<Real> length_of = sqrt(x * x + y * y + z * z) / max(x, y);
      return Vec3<Real>{length_of.value, length_of.dx, select(x < y, length_of, z).dy};
    };
    check_each_lane<Many>(slopes, any_vectors<Many>(dice, -2, 2), any_vectors<Many>(dice, -1, 1));
  }
}

TEST_CASE("a texture's bytes are constants: they do not change from pixel to pixel") {
  const ImageTexture texture{Image(2, 2, {51, 102, 255})};
  const Uv<Dual<double>> uv{{0.3, 1, 0}, {0.6, 0, 1}};
  const Color<Dual<double>> color = texture(uv);
  const Color<double> plain = texture(Uv<double>{0.3, 0.6});
  CHECK(color.r.value == plain.r);
  CHECK(color.b.value == plain.b);
  CHECK(color.g.dx == 0);
  CHECK(color.g.dy == 0);
}

TEST_CASE("a dual of intervals encloses the slope") {
  const Dual<Interval> x{Interval(2.0, 2.5), Interval(1), Interval(0)};
  const Dual<Interval> root = sqrt(x);
  CHECK(root.dx.low() <= 0.5 / std::sqrt(2.5));
  CHECK(root.dx.high() >= 0.5 / std::sqrt(2.0));
  CHECK(root.dx.high() < 0.36);
}
