// Tests of common/kernels/turns.hpp: (u, v) by polynomials, against 50 digits.
#include "turns.hpp"

#include <doctest.h>

#include <functional>
#include <string>

#include "hard_vectors.hpp"
#include "worst_error.hpp"

namespace texmap {
namespace {

/// The larger of two numbers of a reference; std::max of both names would be ambiguous.
template <class Number>
void raise(Number& worst, const Number& other) {
  if (other > worst) worst = other;
}

/// What a mapping gets wrong at worst, in turns and half turns. u is judged where the vector has a direction around the axis.
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

/// The worst of a mapping over some points; a function, so that the judge is compiled once for all mappings.
template <class Exact, class Real>
Measured measure(const std::function<Uv<Real>(const Vec3<Real>&)>& mapping, const std::vector<Vec3<Scalar<Real>>>& points) {
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
      if (!(off_u <= 1 && off_v <= 1) || !(lane(uv.u, i) >= 0 && lane(uv.u, i) < 1)) return {1e30, 1e30};
      raise(worst.u, static_cast<double>(off_u));
      raise(worst.v, static_cast<double>(off_v));
    }
  }
  return worst;
}

/// Holds a measured worst case against the stated one: met, and not idle.
template <class Real, class Mapping>
void check_stated(const std::string& name, int degree, const Mapping& mapping, const std::vector<Vec3<Scalar<Real>>>& dense,
                  const std::vector<Vec3<Scalar<Real>>>& few) {
  using T = Scalar<Real>;
  Measured worst = measure<Reference, Real>(mapping, few);
  if constexpr (!std::is_same_v<T, long double>) {
    const Measured more = measure<long double, Real>(mapping, dense);
    worst = {std::max(worst.u, more.u), std::max(worst.v, more.v)};
  }
  const UvError stated = Mapping::template worst<T>;
  CAPTURE(name);
  CAPTURE(degree);
  CAPTURE(worst.u);
  CAPTURE(worst.v);
  CAPTURE(stated.u);
  CAPTURE(stated.v);
  MESSAGE(std::string(name) << " " << degree << ", " << sizeof(T) << " bytes: u " << worst.u << " of " << stated.u << ", v "
                            << worst.v << " of " << stated.v);
  CHECK(worst.u <= stated.u);
  CHECK(worst.v <= stated.v);
  CHECK(stated.u <= 2 * worst.u);
  CHECK(stated.v <= 2 * worst.v);
}

template <class Real, int... Degree>
void check_all_degrees() {
  using T = Scalar<Real>;
  const std::vector<Vec3<T>> dense = unit_vectors<T>(10000);
  const std::vector<Vec3<T>> few = unit_vectors<T>(60);
  (check_stated<Real>("FastMapping", Degree, FastMapping<Degree>{}, dense, few), ...);
  (check_stated<Real>("FastUnitMapping", Degree, FastUnitMapping<Degree>{}, dense, few), ...);
}

TEST_CASE_TEMPLATE("the worst error is the stated one, and not less than half of it", Real, TEXMAP_KERNEL_NUMBERS) {
  if constexpr (std::is_same_v<Scalar<Real>, float>) {
    check_all_degrees<Real, 5, 7, 9, 11, 13, 15, 17>();
  } else {
    check_all_degrees<Real, 5, 9, 13, 17, 23, 29, 35>();
  }
}

TEST_CASE_TEMPLATE("the axes, the poles and the zero vector are exactly uv_rtiow's", Real, TEXMAP_KERNEL_NUMBERS) {
  const double zeros[] = {0.0, -0.0};
  const auto check = [](double x, double y, double z) {
    const Vec3<Real> p{Real(x), Real(y), Real(z)};
    const Uv<Real> exact = uv_rtiow(p);
    const Uv<Real> fast = FastMapping<13>{}(p);
    CAPTURE(x);
    CAPTURE(y);
    CAPTURE(z);
    CHECK(lane(fast.u, 0) == lane(exact.u, 0));
    CHECK(lane(fast.v, 0) == lane(exact.v, 0));
    CHECK(lane(FastUnitMapping<13>{}(p).u, 0) == lane(exact.u, 0));
  };
  for (const double a : zeros) {
    for (const double b : zeros) {
      for (const double length : {1.0, 1e-9, 3e14}) {
        check(length, a, b);
        check(-length, a, b);
        check(a, length, b);
        check(a, -length, b);
        check(a, b, length);
        check(a, b, -length);
      }
      check(a, b, 0.0);
      check(a, b, -0.0);
    }
  }
}

TEST_CASE_TEMPLATE("only the direction matters, from 1e-12 to 1e15", Real, TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  std::vector<Vec3<T>> points = unit_vectors<T>(4000);
  Dice dice;
  for (Vec3<T>& p : points) p = p * static_cast<T>(std::pow(10.0, dice.between(-12, 15)));
  const Measured worst = measure<long double, Real>(FastMapping<13>{}, points);
  CHECK(worst.u <= FastMapping<13>::worst<T>.u);
  CHECK(worst.v <= FastMapping<13>::worst<T>.v);
}

TEST_CASE_TEMPLATE("finite vectors of any size give u in [0, 1) and v in [0, 1], and no NaN", Real, float, double,
                   long double) {
  test::check_every_place(FastMapping<13>{}, test::hard_finite_numbers<Real>());
}

TEST_CASE("degree 13 of float is within a thousandth of a texel of 8192x4096, at the poles too") {
  CHECK(FastUnitMapping<13>::worst<float>.u * 8192 <= 0.001);
  CHECK(FastUnitMapping<13>::worst<float>.v * 4096 <= 0.001);
  CHECK(FastMapping<13>::worst<float>.u * 8192 <= 0.001);
  CHECK(FastMapping<13>::worst<float>.v * 4096 <= 0.001);
}

#ifdef TEXMAP_HAVE_PACKS
TEST_CASE_TEMPLATE("a pack gives what its lanes give, to the last bit", T, float, double) {
  int different = 0;
  for (const Vec3<T>& p : unit_vectors<T>(2000)) {
    const Uv<T> one = FastMapping<15>{}(p);
    const Uv<Pack<T>> many = FastMapping<15>{}(Vec3<Pack<T>>{Pack<T>(p.x), Pack<T>(p.y), Pack<T>(p.z)});
    if (lane(many.u, 0) != one.u || lane(many.v, 0) != one.v) ++different;
  }
  CHECK(different == 0);
}
#endif

}  // namespace
}  // namespace texmap
