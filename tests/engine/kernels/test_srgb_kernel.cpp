// Tests of common/engine/kernels/srgb_kernel.hpp: bytes without a power, compared with the
// standard's curve in more digits.
#include "engine/kernels/srgb_kernel.hpp"

#include <doctest.h>

#include "engine/kernels/worst_error.hpp"
#include "texture/image_texture.hpp"

namespace texmap::test {
namespace {

/// The curve's level, 0 to 255, of a number.
template <class T>
Reference exact_level(T light) {
  using std::pow;
  const Reference x = Reference(light);
  // The standard's numbers are decimal: 0.055 is not the double nearest to it.
  const auto decimal = [](int thousandths) { return Reference(thousandths) / 1000; };
  if (x <= Reference(31308) / 10000000) return 255 * x * decimal(12920);
  return 255 * (decimal(1055) * pow(x, Reference(5) / 12) - decimal(55));
}

/// Light from 0 to 1: even, of all sizes, around each threshold and where the two curves meet.
template <class T>
std::vector<T> lights() {
  std::vector<T> all = {T(0), T(1), T(0.0031308L), std::nextafter(T(0.0031308L), T(1)),
                        std::numeric_limits<T>::denorm_min()};
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    all.push_back(static_cast<T>(dice.between(0, 1)));
    all.push_back(static_cast<T>(abs(dice.any_size(-8, 0))));
    all.push_back(static_cast<T>(dice.between(0.003, 0.02)));
  }
  for (std::size_t byte = 1; byte < 256; ++byte) {
    const T edge = static_cast<T>(srgb_decode((static_cast<long double>(byte) - 0.5L) / 255));
    for (const T x : {edge, std::nextafter(edge, T(0)), std::nextafter(edge, T(1))})
      all.push_back(x);
  }
  return all;
}

template <class Real, int Terms>
void check_terms() {
  using T = Scalar<Real>;
  double worst = 0;
  double bytes_off = 0;
  for (const T x : lights<T>()) {
    const Reference exact = exact_level(x);
    worst = std::max(
        worst, static_cast<double>(abs(Reference(lane(srgb_level<Terms>(Real(x)), 0)) - exact)));
    const double byte = static_cast<double>(lane(srgb_byte<Terms>(Real(x)), 0));
    bytes_off = std::max(bytes_off, abs(byte - static_cast<double>(floor(exact + Reference(0.5)))));
  }
  const double stated = fits::SrgbCurve<Terms>::worst;
  CAPTURE(Terms);
  CHECK(worst <= stated);
  CHECK(stated <= 2 * worst);
  CHECK(bytes_off == (Terms == 3 ? 2 : 1));
}

TEST_CASE_TEMPLATE(
    "the worst level is the stated one, and bytes are off by two with 3 terms and by one with more",
    Real, TEXMAP_KERNEL_NUMBERS) {
  check_terms<Real, 3>();
  check_terms<Real, 4>();
  check_terms<Real, 6>();
}

TEST_CASE_TEMPLATE("the exact byte is the curve's, next to every threshold too", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  using T = Scalar<Real>;
  // Thresholds are rounded in a number without fewer digits than long double: numbers next to them
  // are left out.
  using Limits = std::numeric_limits<T>;
  const bool rounded = Limits::digits == std::numeric_limits<long double>::digits;
  const T margin = rounded ? 8 * Limits::epsilon() : 0;
  int wrong = 0;
  for (const T x : lights<T>()) {
    if (margin > 0 && srgb_byte_exact(x * (1 - margin)) != srgb_byte_exact(x * (1 + margin)))
      continue;
    if (static_cast<int>(lane(srgb_byte_exact(Real(x)), 0)) !=
        static_cast<int>(floor(exact_level(x) + Reference(0.5))))
      ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("no light, too much light and no number are bytes too", Real,
                   TEXMAP_KERNEL_NUMBERS) {
  using Limits = std::numeric_limits<Scalar<Real>>;
  for (const auto& [light, byte] : {std::pair{Scalar<Real>(-1), 0},
                                    {-Limits::infinity(), 0},
                                    {Limits::quiet_NaN(), 0},
                                    {2, 255},
                                    {Limits::infinity(), 255}}) {
    CHECK(lane(srgb_byte<4>(Real(light)), 0) == byte);
    CHECK(lane(srgb_byte_exact(Real(light)), 0) == byte);
  }
}

}  // namespace
}  // namespace texmap::test
