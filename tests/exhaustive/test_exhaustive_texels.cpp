// From coordinates to texels, for every texel of many sizes; the references are whole numbers. And
// ten million rays at the edges and corners of meshes, in each number: none slips through.
#include <doctest.h>

#include <atomic>
#include <cmath>
#include <cstdint>

#include "engine/draw/threads.hpp"
#include "every_float.hpp"
#include "number/kinds/pack2.hpp"
#include "support/mesh_rays.hpp"
#include "texture/bilinear.hpp"
#include "texture/texel.hpp"

namespace texmap::test {
namespace {

constexpr TexelRounding by_floor = TexelRounding::floor;

/// Sums wrong(n) over n from 1 to `last`, on all cores; one in `one_row_of` where that is slow.
template <class Wrong>
std::int64_t over_sizes(int last, const Wrong& wrong) {
  std::atomic<std::int64_t> sum = 0;
  for_each_row(last / one_row_of, 0, {}, [&](int row) { sum += wrong((row + 1) * one_row_of); });
  return sum;
}

TEST_CASE_TEMPLATE(
    "the middle of every texel lies in it, its lower edge, rounded, in it or in the one before, "
    "and in it for sizes that are powers of two, for every size to 16384",
    T, float, double) {
  using Real = Pack<T>;
  std::atomic<std::int64_t> before = 0;
  const auto wrong = over_sizes(16384, [&before](int n) {
    const bool exact = (n & (n - 1)) == 0;
    std::int64_t below = 0;
    std::int64_t wrong_here = 0;
    for (int first = 0; first < n; first += static_cast<int>(lanes<Real>)) {
      const auto k = from_lanes<Real>([&](std::size_t i) {
        return static_cast<T>(std::min(first + static_cast<int>(i), n - 1));
      });
      const Real middle = texel_number((k + Real(0.5)) / Real(n), n, by_floor);
      const Real edge = texel_number(k / Real(n), n, by_floor);
      for (const T step : all_lanes(k - edge)) below += step == 1 ? 1 : 0;
      const auto in_or_before = exact ? edge == k : edge == k || edge == k - Real(1);
      if (any(!(middle == k && in_or_before))) ++wrong_here;
    }
    before += below;
    return wrong_here;
  });
  CHECK(wrong == 0);
  CHECK(before > 0);
}

TEST_CASE_TEMPLATE(
    "u = 0 is in the first texel; 1, and the number below 1, in the last; by the lecture's "
    "rounding 1 alone, for every size to 2^24",
    T, float, double) {
  constexpr TexelRounding lecture = TexelRounding::lecture;
  const auto wrong = over_sizes((1 << 24) / 4096, [](int row) {
    std::int64_t wrong_here = 0;
    for (int n = 4096 * (row - 1) + 1; n <= 4096 * row; ++n) {
      // Smaller u give smaller products: none is in the last texel if the number below 1 is not.
      const bool right = texel_number(T(0), n, by_floor) == 0 &&
                         texel_number(T(1), n, by_floor) == n - 1 &&
                         texel_number(below_one<T>(), n, by_floor) == n - 1 &&
                         (n == 1 || (texel_number(T(1), n, lecture) == n - 1 &&
                                     texel_number(below_one<T>(), n, lecture) == n - 2));
      if (!right) ++wrong_here;
    }
    return wrong_here;
  });
  CHECK(wrong == 0);
}

/// Columns 0 and 255 in turns in red; the column's number in green and blue.
Image numbered(int width) {
  return image_of(width, 1, [](int column, int) {
    return Rgb8{static_cast<std::uint8_t>(column % 2 == 0 ? 0 : 255),
                static_cast<std::uint8_t>(column % 256), static_cast<std::uint8_t>(column / 256)};
  });
}

TEST_CASE_TEMPLATE(
    "the filter gives at the middle of every texel that texel, at every edge the mean of two, for "
    "every width to 2048, and wraps for every k from -3 n to 3 n and every n to 1024",
    T, float, double) {
  const auto wrong = over_sizes(2048, [](int n) {
    const BilinearTexture texture{numbered(n)};
    const auto color = [&](double place) {
      return texture(Uv<T>{static_cast<T>(place) / static_cast<T>(n), T(0.5)});
    };
    // The place is within 2 roundoffs of 1, so many of n in texels; exact for powers of two.
    const T roundoff = unit_roundoff<T>();
    const bool exact = (n & (n - 1)) == 0;
    const T most = exact ? T(0) : T(2) * roundoff * static_cast<T>(n) + T(4) * roundoff;
    std::int64_t wrong_here = 0;
    for (int k = 0; k < n; ++k) {
      const T middle = static_cast<T>(k % 2);
      // In an odd number of columns the first and the last are both black.
      const T edge = k == 0 && n % 2 == 1 ? T(0) : T(0.5);
      if (!(std::abs(color(k + 0.5).r - middle) <= most) || !(std::abs(color(k).r - edge) <= most))
        ++wrong_here;
    }
    for (int k = -3 * n; n <= 1024 && k <= 3 * n; ++k) {
      const Color<T> found = color(k + 0.5);
      if (std::lround(found.g * 255) + 256 * std::lround(found.b * 255) != (k % n + n) % n)
        ++wrong_here;
    }
    return wrong_here;
  });
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("no crack and no double hit for ten million rays at edges and corners", Real,
                   float, double, long double, Pack2<Pack<float>>, Pack2<Pack<double>>) {
  constexpr long rays = 10'000'000 / one_row_of;
  constexpr int parts = 100;
  std::atomic<long> cracks = 0, doubles = 0, unequal = 0, done = 0;
  for_each_row(parts, 0, {}, [&](int part) {
    const Leaks leaks =
        count_leaks<Real>(rays / parts + 1, 1000 + static_cast<std::uint64_t>(part));
    cracks += leaks.cracks;
    doubles += leaks.doubles;
    unequal += leaks.unequal;
    done += leaks.rays;
  });
  CHECK(done >= rays);
  CHECK(cracks == 0);
  CHECK(doubles == 0);
  CHECK(unequal == 0);
}

}  // namespace
}  // namespace texmap::test
