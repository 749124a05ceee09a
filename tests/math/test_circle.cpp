// Points of the unit circle in turns, and directions of texture coordinates.
#include <doctest.h>

#include <cmath>

#include "math/circle.hpp"
#include "support/exact.hpp"
#include "support/lanes.hpp"
#include "texture/uv_inverse.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE_TEMPLATE("cosine and sine of turns are the library's, and exact at quarters", T, float,
                   double, long double) {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const OnCircle<T> at = on_circle(static_cast<T>(quarter) / 4);
    const int wrapped = ((quarter % 4) + 4) % 4;
    CAPTURE(quarter);
    CHECK(at.cosine == (wrapped == 0 ? 1 : wrapped == 2 ? -1 : 0));
    CHECK(at.sine == (wrapped == 1 ? 1 : wrapped == 3 ? -1 : 0));
  }
  // As far as 1 / (8 unit roundoffs), and a quarter turn beyond each whole number.
  for (T turns = 1; turns < 1 / (8 * unit_roundoff<T>()); turns *= 2) {
    CAPTURE(turns);
    CHECK(on_circle(turns + T(0.25)).sine == 1);
    CHECK(on_circle(turns + T(0.25)).cosine == 0);
    CHECK(on_circle(-turns - T(0.25)).sine == -1);
  }
}

TEST_CASE_TEMPLATE("the direction of (u, v) has that (u, v), poles and seam included", T, float,
                   double, long double) {
  const Exact turn = 4 * widened(std::numeric_limits<T>::epsilon());
  Dice dice(5);
  for (int i = 0; i < 5000; ++i) {
    const Uv<T> uv{static_cast<T>(dice.uniform(0, 1)), static_cast<T>(dice.uniform(0, 1))};
    const Vec3<T> p = direction_rtiow(uv);
    const Uv<T> back = uv_rtiow(p);
    const Exact apart = std::abs(widened(back.u) - widened(uv.u));
    const Exact ring = std::sin(widened(uv.v) * pi<Exact>());
    CAPTURE(uv.u);
    CAPTURE(uv.v);
    CHECK(std::min(apart, 1 - apart) * ring <= turn);
    CHECK(std::abs(widened(back.v) - widened(uv.v)) <= turn);
    CHECK(std::abs(widened(length(p)) - 1) <= turn);
  }
  CHECK(alike(direction_rtiow(Uv<T>{T(0.25), T(0)}).y, T(-1)));
  CHECK(direction_rtiow(Uv<T>{T(0.25), T(1)}).y == 1);
  CHECK(direction_rtiow(Uv<T>{T(0.25), T(1)}).x == 0);
  CHECK(direction_rtiow(Uv<T>{T(0), T(0.5)}).x == -1);
  CHECK(direction_rtiow(Uv<T>{T(0.25), T(0.5)}).z == 1);
  CHECK(direction_rtiow(Uv<T>{T(0.5), T(0.5)}).x == 1);
}
