// From coordinates to texels, for every texel of many sizes. The references are whole numbers: the
// product of two floats is exact in double, and k / n is below u exactly if k is below u n.
#include <doctest.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include "every_float.hpp"
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

/// How many k from 0 to n - 1 have is_wrong(k), a mask of lanes.
template <class Real, class IsWrong>
std::int64_t count_texels(int n, const IsWrong& is_wrong) {
  std::int64_t wrong = 0;
  for (int k = 0; k < n; k += static_cast<int>(lanes<Real>)) {
    const auto whole = from_lanes<Real>([&](std::size_t i) {
      return static_cast<Scalar<Real>>(std::min(k + static_cast<int>(i), n - 1));
    });
    if (any(is_wrong(whole))) ++wrong;
  }
  return wrong;
}

TEST_CASE_TEMPLATE("the middle of every texel lies in it, for every size to 16384", T, float,
                   double) {
  using Real = Pack<T>;
  const auto wrong = over_sizes(16384, [](int n) {
    return count_texels<Real>(n, [n](const Real& k) {
      const Real found = texel_number((k + Real(0.5)) / Real(n), n, by_floor);
      return !(found == k);
    });
  });
  MESSAGE("" << 16384LL * 16385 / 2 / one_row_of << " texels");
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE(
    "the lower edge of every texel, rounded, lies in it or in the one before, and in it for sizes "
    "that are powers of two",
    T, float, double) {
  using Real = Pack<T>;
  std::atomic<std::int64_t> before = 0;
  const auto wrong = over_sizes(16384, [&before](int n) {
    const bool exact = (n & (n - 1)) == 0;
    std::int64_t below = 0;
    const std::int64_t wrong_here = count_texels<Real>(n, [&](const Real& k) {
      const Real found = texel_number(k / Real(n), n, by_floor);
      for (const T step : all_lanes(k - found)) below += step == 1 ? 1 : 0;
      return exact ? !(found == k) : !(found == k) && !(found == k - Real(1));
    });
    before += below;
    return wrong_here;
  });
  MESSAGE("" << 16384LL * 16385 / 2 / one_row_of << " edges, " << before.load()
             << " in the texel before");
  CHECK(wrong == 0);
  CHECK(before > 0);
}

TEST_CASE_TEMPLATE(
    "u = 0 is in the first texel; 1, and the number below 1, in the last, for every "
    "size to 2^24",
    T, float, double) {
  constexpr int last = 1 << 24;
  const auto wrong = over_sizes(last / 4096, [](int row) {
    std::int64_t wrong_here = 0;
    for (int n = 4096 * (row - 1) + 1; n <= 4096 * row; ++n) {
      const bool right = texel_number(T(0), n, by_floor) == 0 &&
                         texel_number(T(1), n, by_floor) == n - 1 &&
                         texel_number(below_one<T>(), n, by_floor) == n - 1;
      if (!right) ++wrong_here;
    }
    return wrong_here;
  });
  MESSAGE("" << last / one_row_of << " sizes");
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE(
    "the lecture's rounding gives the last texel to u = 1 alone, for every size to "
    "2^24",
    T, float, double) {
  constexpr int last = 1 << 24;
  const auto wrong = over_sizes(last / 4096, [](int row) {
    std::int64_t wrong_here = 0;
    for (int n = std::max(2, 4096 * (row - 1) + 1); n <= 4096 * row; ++n) {
      // Smaller u give smaller products: none is in the last texel if the number below 1 is not.
      const bool right = texel_number(T(1), n, TexelRounding::lecture) == n - 1 &&
                         texel_number(below_one<T>(), n, TexelRounding::lecture) == n - 2;
      if (!right) ++wrong_here;
    }
    return wrong_here;
  });
  MESSAGE("" << last / one_row_of << " sizes");
  CHECK(wrong == 0);
}

TEST_CASE("the texel of every float from 2^-25 to 1 holds it within 1 unit roundoff of 1") {
  // In double the product is exact; the texel may be the next one if u is within the bound of it.
  std::vector<Candidate> sizes;
  for (const int n : {1, 3, 1000, 8192, (1 << 24) - 1}) {
    const auto texel =
        by_packs([n](const Pack<float>& u) { return Pack<float>(texel_number(u, n, by_floor)); });
    sizes.push_back({.name = "texel of " + std::to_string(n),
                     .run =
                         [n, texel](const Block& block, float* to) {
                           texel(block, to);
                           for (std::size_t i = 0; i < Block::size; ++i) {
                             const double u = static_cast<double>(block.x[i]) * n;
                             const double low = static_cast<double>(to[i]);
                             // How far u n is from its texel, with 0 where it is inside.
                             const double off = std::max({low - u, u - (low + 1), 0.0});
                             const bool last = low == n - 1 && u >= n;
                             to[i] = static_cast<float>(last ? 0 : off / n);
                           }
                         },
                     .bound = 0x1p-24,
                     .step_back = 0x1p-24,
                     .highest = 0x1p-24F});
  }
  check_all(
      every_float(0x1p-25F, 1), [](Block& block) { block.exact.fill(0); }, sizes);
}

TEST_CASE("clamp puts every float there is between 0 and 1, and what is no number at 0") {
  using Real = Pack<float>;
  constexpr std::uint64_t row_size = 1U << 20;
  std::atomic<std::int64_t> wrong = 0;
  for_each_row((1 << 12) / one_row_of, 0, {}, [&](int row) {
    const std::uint64_t start = static_cast<std::uint64_t>(row) * one_row_of * row_size;
    alignas(64) std::array<float, lanes<Real>> x;
    for (std::uint64_t at = start; at < start + row_size; at += x.size()) {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = std::bit_cast<float>(static_cast<std::uint32_t>(at + i));
      const Real given(Real::Batch::load_aligned(x.data()));
      const Real is = clamp(given, Real(0), Real(1));
      const auto inside = given >= Real(0) && given <= Real(1);
      const Real should = select(inside, given, select(given > Real(1), Real(1), Real(0)));
      if (any(!(is == should))) ++wrong;
    }
  });
  MESSAGE("" << (std::uint64_t{1} << 32) / one_row_of << " floats");
  CHECK(wrong == 0);
}

/// Columns 0 and 255 in turns in red; the column's number in green and blue.
Image numbered(int width) {
  Image image(width, 1);
  for (int column = 0; column < width; ++column) {
    image.at(column, 0) = {static_cast<std::uint8_t>(column % 2 == 0 ? 0 : 255),
                           static_cast<std::uint8_t>(column % 256),
                           static_cast<std::uint8_t>(column / 256)};
  }
  return image;
}

TEST_CASE_TEMPLATE(
    "at the middle of every texel the filter gives that texel, at every edge the "
    "mean of two, for every width to 2048",
    T, float, double) {
  const T roundoff = unit_roundoff<T>();
  const auto wrong = over_sizes(2048, [roundoff](int n) {
    const BilinearTexture texture{numbered(n)};
    // The place is within 2 roundoffs of 1, so many of n in texels; exact for powers of two.
    const bool exact = (n & (n - 1)) == 0;
    const T most = exact ? T(0) : T(2) * roundoff * static_cast<T>(n) + T(4) * roundoff;
    std::int64_t wrong_here = 0;
    for (int k = 0; k < n; ++k) {
      const auto red = [&](double place) {
        return texture(Uv<T>{static_cast<T>(place) / static_cast<T>(n), T(0.5)}).r;
      };
      const T middle = static_cast<T>(k % 2);
      // In an odd number of columns the first and the last are both black.
      const T edge = k == 0 && n % 2 == 1 ? T(0) : T(0.5);
      if (!(std::abs(red(k + 0.5) - middle) <= most) || !(std::abs(red(k) - edge) <= most))
        ++wrong_here;
    }
    return wrong_here;
  });
  MESSAGE("" << 2048LL * 2049 / one_row_of << " places");
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE(
    "u wraps: the middle of texel k of n is texel k modulo n, for every k from -3 n "
    "to 3 n and every n to 1024",
    T, float, double) {
  const auto wrong = over_sizes(1024, [](int n) {
    const BilinearTexture texture{numbered(n)};
    std::int64_t wrong_here = 0;
    for (int k = -3 * n; k <= 3 * n; ++k) {
      const T u = (static_cast<T>(k) + T(0.5)) / static_cast<T>(n);
      const Color<T> color = texture(Uv<T>{u, T(0.5)});
      const int found = static_cast<int>(std::lround(color.g * 255)) +
                        256 * static_cast<int>(std::lround(color.b * 255));
      if (found != (k % n + n) % n) ++wrong_here;
    }
    return wrong_here;
  });
  MESSAGE("" << 6LL * 1024 * 1025 / 2 / one_row_of << " places");
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace texmap::test
