// Tests of common/kernels/reciprocal_root.hpp.
#include "reciprocal_root.hpp"

#include <doctest.h>

#include "worst_error.hpp"

namespace texmap {
namespace {

template <class T>
double relative_error(T got, T x) {
  const Reference exact = 1 / sqrt(Reference(x));
  return static_cast<double>(abs((Reference(got) - exact) / exact));
}

TEST_CASE_TEMPLATE("one over the root is within 3/4 epsilon at every size", Real, TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const T x = static_cast<T>(abs(dice.any_size(-37, 37)));
    worst = std::max(worst, relative_error(lane(reciprocal_root(Real(x)), 0), x));
  }
  const double stated = 0.75 * static_cast<double>(std::numeric_limits<T>::epsilon());
  CHECK(worst <= stated);
  // Of long double the dice only throw the upper 53 bits.
  if (sizeof(T) <= 8) CHECK(stated <= 2 * worst);
}

TEST_CASE_TEMPLATE("a step of Newton's turns an error e into 3/2 e^2", Real, TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  Dice dice;
  const double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  double ratio = 0;
  for (const double e : {1e-3, -1e-3, 1e-2, -1e-2, 3e-5}) {
    for (int i = 0; i < 500; ++i) {
      const T x = static_cast<T>(abs(dice.any_size(-9, 9)));
      const T guess = static_cast<T>(static_cast<Reference>(1 + e) / sqrt(Reference(x)));
      const double off = relative_error(lane(refine_reciprocal_root(Real(x), Real(guess)), 0), x);
      ratio = std::max(ratio, off / (1.5 * e * e + abs(e * e * e) + 2 * epsilon));
    }
  }
  CHECK(ratio <= 1);
  CHECK(ratio >= 0.5);
}

}  // namespace
}  // namespace texmap
