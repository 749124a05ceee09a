// Tests of common/engine/kernels/turns.hpp: (u, v) by polynomials, against 50 digits.
#include "engine/kernels/turns.hpp"

#include <doctest.h>

#include <functional>
#include <string>

#include "engine/kernels/worst_error.hpp"
#include "support/hard_vectors.hpp"
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

/// The larger of two numbers of a reference; std::max of both names would be ambiguous.
template <class Number>
void keep_worst(Number& worst, const Number& other) {
  if (other > worst) worst = other;
}

/// A mapping's worst errors, in turns and half turns. u is compared only where the vector has a
/// direction around the axis.
struct Measured {
  double u = 0;
  double v = 0;
};

/// (u, v) of a vector by other formulas than the kernel's, in `Exact` numbers.
template <class Exact, class T>
Uv<Exact> judged(const Vec3<T>& p) {
  using std::acos;  // the C library's own would be that of double
  static const Exact half_circle = acos(Exact(-1));
  const Exact x = Exact(p.x);
  const Exact y = Exact(p.y);
  const Exact z = Exact(p.z);
  Exact u = Exact(0.5) - atan2(z, x) / (2 * half_circle);
  if (std::signbit(p.z) && p.z == 0) u = p.x < 0 ? Exact(0) : Exact(0.5);
  // The length's root may be rounded in long double: atan2 minds less than acos.
  const Exact around = sqrt(x * x + z * z);
  return {u, atan2(around, -y) / half_circle};
}

/// A mapping's worst error over some points; a function, so that the reference is compiled once.
template <class Exact, class Real>
Measured measure(const std::function<Uv<Real>(const Vec3<Real>&)>& mapping,
                 const std::vector<Vec3<Scalar<Real>>>& points) {
  Measured worst;
  constexpr std::size_t n = lanes<Real>;
  for (std::size_t first = 0; first + n <= points.size(); first += n) {
    const auto gather = [&](Scalar<Real> Vec3<Scalar<Real>>::*which) {
      return from_lanes<Real>([&](std::size_t i) { return points[first + i].*which; });
    };
    using V = Vec3<Scalar<Real>>;
    const Uv<Real> uv = mapping(Vec3<Real>{gather(&V::x), gather(&V::y), gather(&V::z)});
    for (std::size_t i = 0; i < n; ++i) {
      const Uv<Exact> exact = judged<Exact>(points[first + i]);
      const Exact off_u = abs(Exact(lane(uv.u, i)) - exact.u);
      const Exact off_v = abs(Exact(lane(uv.v, i)) - exact.v);
      // A NaN must not look like no error at all.
      if (!(off_u <= 1 && off_v <= 1) || !(lane(uv.u, i) >= 0 && lane(uv.u, i) < 1))
        return {1e30, 1e30};
      keep_worst(worst.u, static_cast<double>(off_u));
      keep_worst(worst.v, static_cast<double>(off_v));
    }
  }
  return worst;
}

/// Holds a measured worst case against the stated one: met, and not idle.
template <class Real, class Mapping>
void check_stated(int degree, const Mapping& mapping, const std::vector<Vec3<Scalar<Real>>>& dense,
                  const std::vector<Vec3<Scalar<Real>>>& few) {
  using T = Scalar<Real>;
  Measured worst = measure<Reference, Real>(mapping, few);
  if constexpr (!std::is_same_v<T, long double>) {
    const Measured more = measure<long double, Real>(mapping, dense);
    worst = {std::max(worst.u, more.u), std::max(worst.v, more.v)};
  }
  const UvError stated = Mapping::template worst<T>;
  CAPTURE(degree);
  CAPTURE(worst.u);
  CAPTURE(worst.v);
  CAPTURE(stated.u);
  CAPTURE(stated.v);
  MESSAGE("degree " << degree << ", " << sizeof(T) << " bytes: u " << worst.u << " of " << stated.u
                    << ", v " << worst.v << " of " << stated.v);
  CHECK(worst.u <= stated.u);
  CHECK(worst.v <= stated.v);
  CHECK(stated.u <= 2.5 * worst.u);  // in double a sum of proofs, which never all come together
  CHECK(stated.v <= 2.5 * worst.v);
}

template <class Real, int... Degree>
void check_all_degrees() {
  using T = Scalar<Real>;
  const std::vector<Vec3<T>> dense = unit_vectors<T>(10000);
  const std::vector<Vec3<T>> few = unit_vectors<T>(60);
  (check_stated<Real>(Degree, FastUnitMapping<Degree>{}, dense, few), ...);
}

TEST_CASE_TEMPLATE("the worst error is the stated one, and not less than two fifths of it", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  if constexpr (std::is_same_v<Scalar<Real>, float>) {
    check_all_degrees<Real, 5, 7, 9, 11, 13, 15, 17>();
  } else {
    check_all_degrees<Real, 5, 9, 13, 17, 23, 29, 35>();
  }
}

TEST_CASE_TEMPLATE("on the axes u is exactly uv_rtiow's, and at the poles v is, too", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  const auto check = [](double x, double y, double z) {
    const Vec3<Real> p{Real(x), Real(y), Real(z)};
    const Uv<Real> exact = uv_rtiow(p);
    const Uv<Real> fast = FastUnitMapping<13>{}(p);
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
    return lane(turn_of_parts<13>(Real(y), abs(Real(x)), Real(x) > Real(0)), lanes<Real> - 1);
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

TEST_CASE_TEMPLATE("a pack gives what its lanes give, to the last bit", T, float, double) {
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    check_each_lane<Pack<T>>([](const auto& p) { return FastUnitMapping<15>{}(normalize(p)); },
                             any_vectors<Pack<T>>(dice, -1, 1));
  }
}

}  // namespace
}  // namespace texmap::test
