// Tests of common/engine/kernels/power_kernel.hpp: Phong's power against more digits.
#include "engine/kernels/power_kernel.hpp"

#include <doctest.h>

#include "engine/kernels/worst_error.hpp"

namespace texmap::test {
namespace {

constexpr double exponents[] = {0,    0.01, 0.5, 1,   1.5,   2,   5,   8,
                                15.9, 16,   50,  100, 500.5, 1e4, 1e6, 1e30};

/// The worst error in levels, over angles with a power between 1 and 2^-20 and over all others.
template <class Real, int Terms>
double worst_levels(double exponent) {
  using T = Scalar<Real>;
  const PowerKernel<Terms> kernel(exponent);
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    double versine = -std::expm1(-dice.between(0, 14) / std::max(exponent, 1e-3));
    if (i % 4 == 0) versine = dice.between(0, 1.2);
    if (i % 16 == 1) versine = abs(dice.any_size(-12, 0));
    const T w = static_cast<T>(versine);
    const Reference exact = w < 1 ? exp(Reference(exponent) * log1p(Reference(-w))) : Reference(0);
    const double off = static_cast<double>(255 * abs(Reference(lane(kernel(Real(w)), 0)) - exact));
    if (!(off <= 255)) return 1e30;
    worst = std::max(worst, off);
  }
  return worst;
}

template <class Real, int Terms>
void check_terms() {
  double worst = 0;
  for (const double n : exponents) worst = std::max(worst, worst_levels<Real, Terms>(n));
  const double stated = PowerKernel<Terms>::template worst_levels<Scalar<Real>>;
  CAPTURE(Terms);
  MESSAGE(Terms << " terms, " << sizeof(Scalar<Real>) << " bytes: " << worst << " of " << stated
                << " levels");
  CHECK(worst <= stated);
  CHECK(stated <= 2 * worst);
}

TEST_CASE_TEMPLATE("the worst level is the stated one, for exponents from 0 to 1e30", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  check_terms<Real, 3>();
  check_terms<Real, 4>();
  check_terms<Real, 6>();
  check_terms<Real, 8>();
}

TEST_CASE_TEMPLATE(
    "the middle of a highlight is exactly 1, a right angle and beyond exactly 0, and so is what is "
    "too dark to see",
    Real, TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  for (const double n : exponents) {
    CAPTURE(n);
    const PowerKernel<8> kernel(n);
    CHECK(lane(kernel(Real(0)), 0) == T(1));
    for (int i = 0; i <= 1000; ++i) {
      const T power = lane(kernel(Real(i / 1000.)), 0);
      const bool dark = power == 0;
      REQUIRE((dark || power >= T(1.5e-5)));  // never a denormal number
      REQUIRE(power <= T(1));
    }
    CHECK(lane(kernel(Real(1)), 0) == T(0));
    CHECK(lane(kernel(Real(2)), 0) == T(0));
  }
}

}  // namespace
}  // namespace texmap::test
