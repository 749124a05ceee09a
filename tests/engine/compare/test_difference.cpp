// The figures of two pictures: exact where they can be computed by hand; SSIM against a
// second, naive version of its paper.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/compare/naive_figures.hpp"
#include "engine/compare/ssim.hpp"
#include "support/made_pictures.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

Image plain(int width, int height, Rgb8 color) { return Image(width, height, color); }

Image with(Image image, int column, int row, Rgb8 color) {
  image.at(column, row) = color;
  return image;
}

/// The values of all pixels, from rows that come once each, in any order.
template <class Rows>
std::vector<double> values_of(const Image& image, const Rows& rows) {
  std::vector<double> all(image.pixels.size());
  std::vector<int> times(static_cast<std::size_t>(image.height));
  rows([&](int row, std::span<const double> values) {
    ++times[static_cast<std::size_t>(row)];
    std::copy(values.begin(), values.end(), all.begin() + row * image.width);
  });
  CHECK(times == std::vector<int>(times.size(), 1));
  return all;
}
std::vector<double> ssim_of(const Image& a, const Image& b) {
  return values_of(a, [&](const auto& take) { ssim_rows(a, b, take); });
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

std::string complaint(const Image& a, const Image& b, const Image& mask = {}) {
  try {
    (void)measure(a, b, mask);
  } catch (const DifferenceError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("equal pictures are equal by every figure") {
  const Image a = noise(37, 80, 1);
  const Figures f = measure(a, a);
  CHECK((f.width == 37 && f.height == 80));
  CHECK(f.pixels_compared == 37 * 80);
  CHECK(f.pixels_different == 0);
  CHECK(f.box == Box{});
  CHECK(f.worst.levels == 0);
  CHECK(f.root_mean_square_error == 0);
  CHECK(f.peak_signal_to_noise == infinity);
  CHECK(f.structural_similarity == 1);
  // measure() does not compute SSIM for equal pictures, so this calls it.
  for (const double value : ssim_of(a, a)) CHECK(value == 1);
}

TEST_CASE("the errors are means over pixels and channels, of either sign") {
  // |3| + |-4| over 2 pixels of 3 channels, and 9 + 16.
  const Image a = with(plain(2, 1, {100, 100, 100}), 0, 0, {103, 100, 100});
  const Image b = with(plain(2, 1, {100, 100, 100}), 1, 0, {100, 100, 104});
  const Figures f = measure(a, b);
  CHECK(f.mean_absolute_error == 7.0 / 6);
  CHECK(f.root_mean_square_error == std::sqrt(25.0 / 6));
  CHECK((f.mean_a == 100.5 && near(f.mean_b, 100 + 4.0 / 6, 1e-12)));
  // 20 log10(255 / k).
  const Figures off = measure(plain(13, 7, {}), plain(13, 7, {2, 2, 2}));
  CHECK(near(off.peak_signal_to_noise, 42.1102036953995, 1e-12));
  CHECK(off.share_different == 1);
}

TEST_CASE(
    "the box holds all that differs and nothing else, and the worst pixel is the first of the "
    "worst, whichever channel it is") {
  const Image a = plain(30, 70, {100, 100, 100});
  for (const auto& [color, levels] :
       {std::pair{Rgb8{190, 100, 100}, 90}, {{100, 10, 100}, 90}, {{99, 101, 188}, 88}}) {
    const Image b = with(with(with(a, 25, 2, {120, 100, 100}), 5, 4, color), 4, 66, color);
    const Figures f = measure(a, b);
    CHECK(f.box == Box{4, 2, 22, 65});
    CHECK((f.worst.levels == levels && f.worst.column == 5 && f.worst.row == 4));
    CHECK((f.worst.a == Rgb8{100, 100, 100} && f.worst.b == color));
  }
  CHECK(measure(a, with(with(a, 0, 0, {}), 29, 69, {})).box == Box{0, 0, 30, 70});
}

TEST_CASE("off by more than L counts the pixels beyond L and not those at it") {
  const Image a = plain(10, 1, {100, 100, 100});
  Image b = a;
  for (int i = 0; i < 10; ++i) b.at(i, 0).g = static_cast<std::uint8_t>(100 + i);
  const Figures f = measure(a, b);
  for (int levels = 0; levels < 10; ++levels)
    CHECK(pixels_off_by_more_than(f, levels) == static_cast<std::size_t>(9 - levels));
  const Figures most = measure(plain(2, 2, {0, 0, 0}), plain(2, 2, {0, 255, 0}));
  CHECK(pixels_off_by_more_than(most, 254) == 4);
  CHECK(pixels_off_by_more_than(most, 255) == 0);
}

TEST_CASE(
    "where the mask is black nothing is compared, and SSIM is over windows inside the picture") {
  const Image a = noise(30, 16, 18);
  const Image b = noise(30, 16, 19);
  Image half_b = b;
  Image mask(30, 16, {255, 255, 255});
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 15; ++column) {
      mask.at(column, row) = {};
      half_b.at(column, row) = a.at(column, row);
    }
  }
  const auto mean_inside = [](const std::vector<double>& ssim, int first_column) {
    std::vector<double> inside;
    for (int row = 5; row < 11; ++row) {
      for (int column = first_column; column < 25; ++column)
        inside.push_back(ssim[static_cast<std::size_t>(row * 30 + column)]);
    }
    return mean(inside);
  };
  CHECK(near(measure(a, b).structural_similarity, mean_inside(ssim_of(a, b), 5), 1e-14));
  const Figures f = measure(a, b, mask);
  const Figures half = measure(a, half_b);
  CHECK(near(f.structural_similarity, mean_inside(ssim_of(a, half_b), 15), 1e-14));
  CHECK(f.pixels_compared == 15 * 16);
  CHECK(f.pixels_different == half.pixels_different);
  CHECK(f.box == half.box);
  CHECK(f.mean_absolute_error == doctest::Approx(2 * half.mean_absolute_error));
  CHECK(f.mean_a != half.mean_a);
  // Only black leaves out, and not everything may be left out.
  CHECK(measure(a, b, with(plain(30, 16, {}), 0, 0, {0, 0, 1})).pixels_compared == 1);
  CHECK(complaint(a, b, plain(30, 16, {})) == "the mask leaves out every pixel");
  CHECK(complaint(Image(), Image()) == "the pictures are empty");
  // No window lies inside a picture of ten rows: then all count.
  const Image small_a = noise(40, 10, 9), small_b = noise(40, 10, 10);
  CHECK(near(measure(small_a, small_b).structural_similarity, mean(ssim_of(small_a, small_b)),
             1e-14));
}

TEST_CASE(
    "SSIM agrees with a direct sum over each window, at every pixel and across bands of rows") {
  for (const auto& [a, b] :
       {std::pair{noise(23, 70, 3), noise(23, 70, 4)}, std::pair{ramps(30, 68), ramps(30, 68, 1)},
        std::pair{noise(3, 2, 5), noise(3, 2, 6)}}) {
    const std::vector<double> values = ssim_of(a, b);
    const std::vector<double> exchanged = ssim_of(b, a);
    REQUIRE(values.size() == a.pixels.size());
    double worst = 0;
    for (int row = 0; row < a.height; ++row) {
      for (int column = 0; column < a.width; ++column) {
        const auto place = static_cast<std::size_t>(row * a.width + column);
        worst = std::max(worst, std::abs(values[place] - naive::ssim(a, b, column, row)));
        CHECK(near(values[place], exchanged[place], 1e-12));
      }
    }
    CHECK(worst < 1e-11);
  }
  // The mean that scikit-image 0.19 has for these, see docs/numerics.md.
  CHECK(near(measure(noise(97, 61, 16), noise(97, 61, 17)).structural_similarity,
             0.007323859550020152, 1e-12));
  CHECK(near(measure(ramps(120, 90), ramps(120, 90, 1)).structural_similarity, 0.5693023480677195,
             1e-12));
}

TEST_CASE("without SSIM all other figures are the same, and it has the same bits in every run") {
  const Image a = noise(70, 200, 4), b = noise(70, 200, 5);
  const Figures all = measure(a, b);
  const Figures pixels = measure(a, b, {}, Detail::pixels);
  CHECK(std::isnan(pixels.structural_similarity));
  CHECK(pixels.pixels_by_levels == all.pixels_by_levels);
  CHECK(measure(a, a, {}, Detail::pixels).structural_similarity == 1);
  for (int repeat = 0; repeat < 5; ++repeat)
    CHECK(measure(a, b).structural_similarity == all.structural_similarity);
}
