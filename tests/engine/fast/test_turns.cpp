// Tests of common/engine/fast/turns.hpp: (u, v) by polynomials where they must be exact. How far
// they are off elsewhere is held by test_kernel_plan, tests/exhaustive and tests/proofs. And of
// root_texture.hpp, texels in one word: the error of the roots of light in levels; they are the
// picture's texels.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/fast/root_texture.hpp"
#include "engine/fast/turns.hpp"
#include "math/srgb.hpp"
#include "number/kinds/pack.hpp"
#include "support/dice.hpp"

#define TEXMAP_KERNEL_NUMBERS float, double, long double, Pack<float>, Pack<double>

namespace texmap::test {
namespace {

/// Zeros, ones, the smallest and the largest numbers, with either sign, and a few between.
template <class Real>
std::vector<Real> hard_finite_numbers() {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> all = {Limits::epsilon(), Real(1e-30), Real(-1e30)};
  for (const Real size : {Real(0), Real(1), Limits::denorm_min(), Limits::min(), Limits::max()}) {
    all.push_back(size);
    all.push_back(-size);
  }
  return all;
}

TEST_CASE_TEMPLATE("on the axes u is exactly uv_rtiow's, and at the poles v is, too", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  const auto check = [](double x, double y, double z) {
    const Vec3<Real> p{Real(x), Real(y), Real(z)};
    const Uv<Real> exact = uv_rtiow(p);
    const Uv<Real> fast = FastUnitMapping<17>{}(p);
    CAPTURE(x);
    CAPTURE(y);
    CAPTURE(z);
    CHECK(lane(fast.u, 0) == lane(exact.u, 0));
    if (y != 0) CHECK(lane(fast.v, 0) == lane(exact.v, 0));
  };
  for (const double a : {0.0, -0.0}) {
    for (const double b : {0.0, -0.0}) {
      for (const double one : {1.0, -1.0}) {
        check(one, a, b);
        check(a, one, b);
        check(a, b, one);
      }
    }
  }
}

TEST_CASE_TEMPLATE("a turn is in [0, 1) for any finite vector, and only its direction matters",
                   Real, TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  const auto turn = [](T x, T y) {
    return lane(turn_of_parts<17>(Real(y), abs(Real(x)), Real(x) > Real(0)), lanes<Real> - 1);
  };
  for (const T x : hard_finite_numbers<T>()) {
    for (const T y : hard_finite_numbers<T>()) {
      CAPTURE(x);
      CAPTURE(y);
      REQUIRE(turn(x, y) >= T(0));
      REQUIRE(turn(x, y) < T(1));
    }
  }
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const T x = static_cast<T>(dice.between(-1, 1)), y = static_cast<T>(dice.between(-1, 1));
    const T size = std::ldexp(T(1), dice.within(-40, 50));
    REQUIRE(turn(x * size, y * size) == turn(x, y));
  }
}

/// A texture of all bytes, one texel for each: red, green and blue differ.
LightTexture all_bytes(TexelLight light) {
  Image image(32, 8);
  std::uint8_t byte = 0;
  for (Rgb8& pixel : image.pixels) {
    pixel = {byte, static_cast<std::uint8_t>(255 - byte), static_cast<std::uint8_t>(byte ^ 0x55)};
    ++byte;
  }
  return {{image}, light};
}

double levels_apart(double a, double b) { return 255 * std::abs(srgb_encode(a) - srgb_encode(b)); }

TEST_CASE(
    "texels are those of the picture, on both axes and by both roundings; none is off by more "
    "levels than stated, and some by most of it") {
  double worst = 0;
  Dice dice;
  for (const TexelLight light : {TexelLight::linear, TexelLight::encoded, TexelLight::stb}) {
    for (const VAxis axis : {VAxis::up, VAxis::down}) {
      for (const TexelRounding rounding : {TexelRounding::floor, TexelRounding::lecture}) {
        LightTexture exact = all_bytes(light);
        exact.v_axis = axis;
        exact.rounding = rounding;
        const RootTexture roots(exact);
        for (int i = 0; i < 8000; ++i) {
          const Uv<double> uv{dice.between(-0.1, 1.1), dice.between(-0.1, 1.1)};
          const Rgb is = roots(uv), should = exact(uv);
          worst = std::max({worst, levels_apart(is.r, should.r), levels_apart(is.g, should.g),
                            levels_apart(is.b, should.b)});
        }
      }
    }
  }
  CHECK(worst <= RootTexture::worst_levels);
  CHECK(worst > 0.8 * RootTexture::worst_levels);
}

}  // namespace
}  // namespace texmap::test
