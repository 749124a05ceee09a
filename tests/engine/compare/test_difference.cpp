// The figures of two pictures: exact where they can be computed by hand; SSIM and FLIP against a
// second, naive version of their papers.
#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/compare/flip.hpp"
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
std::vector<double> flip_of(const Image& a, const Image& b,
                            double pixels_per_degree = usual_pixels_per_degree) {
  return values_of(a, [&](const auto& take) { flip_rows(a, b, pixels_per_degree, take); });
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
  CHECK(f.width == 37);
  CHECK(f.height == 80);
  CHECK(f.pixels_compared == 37 * 80);
  CHECK(f.pixels_different == 0);
  CHECK(f.share_different == 0);
  CHECK(f.box == Box{});
  CHECK(f.worst.levels == 0);
  CHECK(f.mean_absolute_error == 0);
  CHECK(f.root_mean_square_error == 0);
  CHECK(f.peak_signal_to_noise == infinity);
  CHECK(f.structural_similarity == 1);
  CHECK(f.flip == 0);
  CHECK(f.mean_a == f.mean_b);
  // measure() does not ask for these two then, so they are asked here.
  for (const double value : ssim_of(a, a)) CHECK(value == 1);
  for (const double value : flip_of(a, a)) CHECK(value == 0);
}

TEST_CASE("one channel of one pixel of a hundred, off by one level") {
  const Image a = plain(20, 5, {10, 20, 30});
  const Figures f = measure(a, with(a, 7, 3, {10, 21, 30}));
  CHECK(f.pixels_compared == 100);
  CHECK(f.pixels_different == 1);
  CHECK(f.share_different == 0.01);
  CHECK(f.box == Box{7, 3, 1, 1});
  CHECK(f.worst.column == 7);
  CHECK(f.worst.row == 3);
  CHECK(f.worst.levels == 1);
  CHECK(f.worst.a == Rgb8{10, 20, 30});
  CHECK(f.worst.b == Rgb8{10, 21, 30});
  CHECK(f.mean_absolute_error == 1.0 / 300);
  CHECK(f.root_mean_square_error == std::sqrt(1.0 / 300));
  CHECK(near(f.peak_signal_to_noise, 72.9020161558757, 1e-12));  // 20 log10 255 + 10 log10 300
  CHECK(f.mean_a == 20);
  CHECK(near(f.mean_b, 20 + 1.0 / 300, 1e-14));
}

TEST_CASE("all pixels off by k: errors of k levels, and 6 dB less for twice as much") {
  // 20 log10(255 / k)
  const std::array<std::pair<int, double>, 5> table = {{{1, 48.1308036086791},
                                                        {2, 42.1102036953995},
                                                        {10, 28.1308036086791},
                                                        {51, 13.9794000867204},
                                                        {255, 0.0}}};
  for (const auto& [off, decibels] : table) {
    const int k = off;
    CAPTURE(k);
    const auto level = static_cast<std::uint8_t>(k);
    const Figures f = measure(plain(13, 7, {0, 0, 0}), plain(13, 7, {level, level, level}));
    CHECK(f.pixels_different == 91);
    CHECK(f.share_different == 1);
    CHECK(f.box == Box{0, 0, 13, 7});
    CHECK(f.worst.levels == k);
    CHECK(f.mean_absolute_error == k);
    CHECK(f.root_mean_square_error == k);
    CHECK(near(f.peak_signal_to_noise, decibels, 1e-12));
    CHECK(f.mean_a == 0);
    CHECK(f.mean_b == k);
  }
}

TEST_CASE("the errors are means over pixels and channels, of either sign") {
  // |3| + |-4| over 2 pixels of 3 channels, and 9 + 16.
  const Image a = with(plain(2, 1, {100, 100, 100}), 0, 0, {103, 100, 100});
  const Image b = with(plain(2, 1, {100, 100, 100}), 1, 0, {100, 100, 104});
  const Figures f = measure(a, b);
  CHECK(f.mean_absolute_error == 7.0 / 6);
  CHECK(f.root_mean_square_error == std::sqrt(25.0 / 6));
  CHECK(f.worst.column == 1);
  CHECK(f.worst.levels == 4);
}

TEST_CASE("the box holds all that differs and nothing else") {
  const Image a = plain(30, 20, {50, 60, 70});
  Image b = with(a, 4, 17, {50, 60, 71});
  CHECK(measure(a, b).box == Box{4, 17, 1, 1});
  b = with(b, 25, 2, {0, 60, 70});
  CHECK(measure(a, b).box == Box{4, 2, 22, 16});
  b = with(b, 0, 0, {51, 60, 70});
  CHECK(measure(a, b).box == Box{0, 0, 26, 18});
  b = with(b, 29, 19, {51, 60, 70});
  CHECK(measure(a, b).box == Box{0, 0, 30, 20});
}

TEST_CASE("the worst pixel is the first of the worst, whichever channel it is") {
  const Image a = plain(9, 9, {100, 100, 100});
  struct Row {
    Rgb8 color;
    int levels;
  };
  for (const auto& [color, levels] : {Row{{190, 100, 100}, 90}, Row{{100, 10, 100}, 90},
                                      Row{{99, 101, 188}, 88}, Row{{0, 255, 100}, 155}}) {
    const Image b = with(with(with(a, 2, 1, {120, 100, 100}), 5, 4, color), 1, 6, color);
    const Figures f = measure(a, b);
    CHECK(f.worst.levels == levels);
    CHECK(f.worst.column == 5);
    CHECK(f.worst.row == 4);
    CHECK(f.worst.b == color);
    CHECK(f.worst.a == Rgb8{100, 100, 100});
  }
}

TEST_CASE("off by more than L counts the pixels beyond L and not those at it") {
  const Image a = plain(10, 1, {100, 100, 100});
  Image b = a;
  for (int i = 0; i < 10; ++i) b.at(i, 0).g = static_cast<std::uint8_t>(100 + i);
  const Figures f = measure(a, b);
  for (int levels = 0; levels < 10; ++levels)
    CHECK(pixels_off_by_more_than(f, levels) == static_cast<std::size_t>(9 - levels));
  CHECK(pixels_off_by_more_than(f, 254) == 0);
  CHECK(pixels_off_by_more_than(f, 255) == 0);
  const Figures most = measure(plain(2, 2, {0, 0, 0}), plain(2, 2, {0, 255, 0}));
  CHECK(pixels_off_by_more_than(most, 254) == 4);
  CHECK(pixels_off_by_more_than(most, 255) == 0);
}

TEST_CASE("where the mask is black, nothing is compared, by any figure") {
  const Image a = noise(40, 30, 2);
  Image b = a;
  for (int row = 10; row < 15; ++row) {
    for (int column = 20; column < 28; ++column) b.at(column, row) = {255, 0, 255};
  }
  Image mask(40, 30, {255, 255, 255});
  for (int row = 10; row < 15; ++row) {
    for (int column = 20; column < 28; ++column) mask.at(column, row) = {};
  }
  CHECK(measure(a, b).structural_similarity < 0.99);
  CHECK(measure(a, b).flip > 0.001);

  // Everything that differs is left out.
  const Figures f = measure(a, b, mask);
  CHECK(f.pixels_compared == 40 * 30 - 40);
  CHECK(f.pixels_different == 0);
  CHECK(f.peak_signal_to_noise == infinity);
  CHECK(f.structural_similarity == 1);
  CHECK(f.flip == 0);

  // One pixel far from there differs, too: its figures do not depend on what the mask leaves out.
  b.at(2, 3) = {static_cast<std::uint8_t>(a.at(2, 3).r ^ 0x80u), a.at(2, 3).g, a.at(2, 3).b};
  const Figures one = measure(a, b, mask);
  const Figures alone = measure(a, with(a, 2, 3, b.at(2, 3)), mask);
  CHECK(one.pixels_different == 1);
  CHECK(one.box == Box{2, 3, 1, 1});
  CHECK(one.mean_absolute_error == 128.0 / (3 * 1160));
  CHECK(one.structural_similarity == alone.structural_similarity);
  CHECK(one.structural_similarity < 1);
  CHECK(one.flip == alone.flip);
  CHECK(one.flip > 0);
  CHECK(one.share_different == 1.0 / 1160);
  CHECK(one.mean_a != measure(a, b).mean_a);
}

TEST_CASE("the means of SSIM and FLIP are over the compared pixels alone") {
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
  const std::vector<double> ssim = ssim_of(a, half_b);
  const std::vector<double> flip = flip_of(a, half_b);
  std::vector<double> ssim_inside, flip_kept;
  for (int row = 0; row < 16; ++row) {
    for (int column = 15; column < 30; ++column) {
      const auto place = static_cast<std::size_t>(row * 30 + column);
      flip_kept.push_back(flip[place]);
      if (row >= 5 && row < 11 && column < 25) ssim_inside.push_back(ssim[place]);
    }
  }
  const Figures f = measure(a, b, mask);
  CHECK(near(f.structural_similarity, mean(ssim_inside), 1e-14));
  CHECK(near(f.flip, mean(flip_kept), 1e-14));
}

TEST_CASE("only black leaves out: the darkest blue is compared") {
  const Image a = plain(2, 1, {0, 0, 0});
  const Image b = plain(2, 1, {9, 9, 9});
  CHECK(measure(a, b, with(plain(2, 1, {0, 0, 0}), 1, 0, {0, 0, 1})).pixels_compared == 1);
  CHECK(measure(a, b, with(plain(2, 1, {0, 0, 0}), 1, 0, {1, 0, 0})).pixels_compared == 1);
  CHECK(complaint(a, b, plain(2, 1, {0, 0, 0})) == "the mask leaves out every pixel");
}

TEST_CASE("pictures of different sizes are refused with both sizes") {
  CHECK(complaint(plain(4, 3, {}), plain(3, 4, {})) ==
        "the pictures differ in size: 4 x 3 and 3 x 4 pixels");
  CHECK(complaint(plain(4, 3, {}), plain(4, 4, {})) ==
        "the pictures differ in size: 4 x 3 and 4 x 4 pixels");
  CHECK(complaint(plain(4, 3, {}), plain(5, 3, {})) ==
        "the pictures differ in size: 4 x 3 and 5 x 3 pixels");
  CHECK(complaint(plain(4, 3, {}), plain(4, 3, {}), plain(4, 2, {1, 1, 1})) ==
        "the mask differs from the pictures in size: 4 x 2 and 4 x 3 pixels");
  CHECK(complaint(plain(4, 3, {}), plain(4, 3, {}), plain(3, 3, {1, 1, 1})) ==
        "the mask differs from the pictures in size: 3 x 3 and 4 x 3 pixels");
  CHECK(complaint(Image(), Image()) == "the pictures are empty");
}

TEST_CASE("the SSIM of plain pictures is the term of their brightness") {
  const double c1 = 6.5025;
  for (const auto& pair : {std::pair{0, 255}, {0, 1}, {100, 110}, {200, 50}, {254, 255}}) {
    const int p = pair.first, q = pair.second;
    CAPTURE(p);
    CAPTURE(q);
    const double expected = (2.0 * p * q + c1) / (1.0 * p * p + 1.0 * q * q + c1);
    const auto lp = static_cast<std::uint8_t>(p), lq = static_cast<std::uint8_t>(q);
    CHECK(near(
        measure(plain(30, 20, {lp, lp, lp}), plain(30, 20, {lq, lq, lq})).structural_similarity,
        expected, 1e-10));
    // In one channel of three: the mean of the channels.
    CHECK(near(measure(plain(30, 20, {7, lp, 7}), plain(30, 20, {7, lq, 7})).structural_similarity,
               (2 + expected) / 3, 1e-10));
  }
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
}

TEST_CASE("the mean SSIM is over windows inside the picture, or over all where there are none") {
  const Image a = noise(17, 14, 7), b = noise(17, 14, 8);
  const std::vector<double> values = ssim_of(a, b);
  std::vector<double> inside;
  for (int row = 5; row < 9; ++row) {
    for (int column = 5; column < 12; ++column)
      inside.push_back(values[static_cast<std::size_t>(row * 17 + column)]);
  }
  CHECK(near(measure(a, b).structural_similarity, mean(inside), 1e-14));
  CHECK_FALSE(near(mean(inside), mean(values), 1e-4));

  const Image small_a = noise(40, 10, 9), small_b = noise(40, 10, 10);
  CHECK(near(measure(small_a, small_b).structural_similarity, mean(ssim_of(small_a, small_b)),
             1e-14));
}

TEST_CASE("the FLIP of plain pictures is that of their colors") {
  // Black against white: L* differs by 100, a* and b* are 0, so HyAB is 100. The largest distance
  // is 203.2..., of green and blue. To the power of 0.7 these are 25.1189 and 41.2761:
  // 0.95 + 0.05 (25.1189 - 16.5104) / (41.2761 - 16.5104).
  CHECK(near(measure(plain(25, 25, {0, 0, 0}), plain(25, 25, {255, 255, 255})).flip,
             0.95 + 0.05 * (25.118864 - 16.510438) / 24.765658, 2e-8));
  CHECK(near(measure(plain(25, 25, {0, 255, 0}), plain(25, 25, {0, 0, 255})).flip, 1, 1e-7));

  const std::array<Rgb8, 8> colors = {{{0, 0, 0},
                                       {255, 255, 255},
                                       {255, 0, 0},
                                       {200, 10, 90},
                                       {128, 128, 128},
                                       {129, 128, 128},
                                       {0, 60, 255},
                                       {250, 255, 0}}};
  for (const Rgb8 p : colors) {
    for (const Rgb8 q : colors) {
      if (p == q) continue;
      const auto light = [](Rgb8 c) {
        return naive::Three{naive::decoded(c.r), naive::decoded(c.g), naive::decoded(c.b)};
      };
      const double expected = naive::color_difference(light(p), light(q));
      // The blur changes the last bits of a plain color, and small distances magnify that.
      CHECK(near(measure(plain(6, 5, p), plain(6, 5, q)).flip, expected, 1e-7));
    }
  }
}

TEST_CASE(
    "FLIP agrees with direct sums in two dimensions, at every pixel, across bands of rows, near "
    "and far") {
  struct Pair {
    Image a, b;
    double pixels_per_degree;
  };
  for (const Pair& pair :
       {Pair{noise(4, 67, 11), noise(4, 67, 12), 30}, Pair{ramps(22, 12), ramps(22, 12, 1), 67},
        Pair{ramps(20, 9), noise(20, 9, 13), 12.5}}) {
    const auto& [a, b, pixels] = pair;
    const double pixels_per_degree = pixels;
    CAPTURE(pixels_per_degree);
    const std::vector<double> values = flip_of(a, b, pixels_per_degree);
    REQUIRE(values.size() == a.pixels.size());
    double worst = 0;
    for (int row = 0; row < a.height; ++row) {
      for (int column = 0; column < a.width; ++column) {
        const double expected = naive::flip(a, b, column, row, pixels_per_degree);
        worst = std::max(
            worst, std::abs(values[static_cast<std::size_t>(row * a.width + column)] - expected));
      }
    }
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("FLIP is the same whichever picture comes first, and stays within 0 and 1") {
  std::vector<std::pair<Image, Image>> pairs = {{noise(31, 70, 14), noise(31, 70, 15)},
                                                {ramps(31, 70), ramps(31, 70, 3)}};
  for (unsigned corner = 0; corner < 64; ++corner) {
    const auto channel = [corner](unsigned bit) {
      return static_cast<std::uint8_t>((corner >> bit & 1u) * 255);
    };
    pairs.push_back({plain(2, 2, {channel(0), channel(1), channel(2)}),
                     plain(2, 2, {channel(3), channel(4), channel(5)})});
  }
  for (const auto& [a, b] : pairs) {
    const std::vector<double> values = flip_of(a, b);
    CHECK(values == flip_of(b, a));
    for (const double value : values) {
      CHECK(value >= 0);
      CHECK(value <= 1);
    }
  }
}

TEST_CASE("FLIP is less from afar: a fine pattern blurs") {
  Image a(40, 40), b(40, 40);
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) {
      const bool even = (row + column) % 2 == 0;
      a.at(column, row) = even ? Rgb8{255, 255, 255} : Rgb8{};
      b.at(column, row) = even ? Rgb8{} : Rgb8{255, 255, 255};
    }
  }
  CHECK(mean(flip_of(a, b, 67)) < 0.5 * mean(flip_of(a, b, 15)));
}

TEST_CASE("FLIP's mean is that of the authors' program") {
  // Their C++ header of September 2025, at 67 pixels per degree, on these pictures. It computes in
  // float: seven digits, or a little less where the square root magnifies a feature that is only
  // rounding.
  CHECK(near(measure(noise(97, 61, 16), noise(97, 61, 17)).flip, 0.439991746, 1e-6));
  CHECK(near(measure(ramps(120, 90), ramps(120, 90, 1)).flip, 0.246250619, 1e-6));
}

TEST_CASE("SSIM's mean is that of scikit-image") {
  // structural_similarity of version 0.19 on these pictures with gaussian_weights=True, sigma=1.5,
  // use_sample_covariance=False.
  CHECK(near(measure(noise(97, 61, 16), noise(97, 61, 17)).structural_similarity,
             0.007323859550020152, 1e-12));
  CHECK(near(measure(ramps(120, 90), ramps(120, 90, 1)).structural_similarity, 0.5693023480677195,
             1e-12));
}

TEST_CASE("SSIM and FLIP are sums of rows in their order: the same bits on any number of threads") {
  const Image a = noise(90, 150, 3);
  const Image b = with(noise(90, 150, 3), 40, 70, {1, 2, 3});
  const auto mean_of_rows = [](const std::vector<double>& values, int first, int end, int from,
                               int to) {
    double sum = 0;
    for (int row = from; row < to; ++row) {
      double of_row = 0;
      for (int x = first; x < end; ++x) of_row += values[static_cast<std::size_t>(row * 90 + x)];
      sum += of_row;
    }
    return sum / ((end - first) * (to - from));
  };
  for (int repeat = 0; repeat < 5; ++repeat) {
    const Figures f = measure(a, b);
    CHECK(f.structural_similarity == mean_of_rows(ssim_of(a, b), 5, 85, 5, 145));
    CHECK(f.flip == mean_of_rows(flip_of(a, b), 0, 90, 0, 150));
  }
}

TEST_CASE(
    "without SSIM and FLIP all other figures are the same, whatever the part of the picture") {
  Image a = noise(70, 200, 4);
  Image b = a;
  for (const auto& [column, row] : {std::pair{60, 63}, {3, 64}, {69, 64}, {20, 130}}) {
    b.at(column, row).g ^= 16;
  }
  const Figures all = measure(a, b);
  Figures pixels = measure(a, b, {}, Detail::pixels);
  CHECK(std::isnan(pixels.structural_similarity));
  CHECK(std::isnan(pixels.flip));
  CHECK(pixels.box == Box{3, 63, 67, 68});
  CHECK(pixels.box == all.box);
  CHECK(pixels.worst.column == 60);  // the first of four
  CHECK(pixels.worst.row == 63);
  CHECK(pixels.pixels_by_levels == all.pixels_by_levels);
  CHECK(pixels.root_mean_square_error == all.root_mean_square_error);
  CHECK(pixels.mean_b == all.mean_b);
  CHECK(measure(a, a, {}, Detail::pixels).structural_similarity == 1);
  const Figures similarity = measure(a, b, {}, Detail::similarity);
  CHECK(similarity.structural_similarity == all.structural_similarity);
  CHECK(std::isnan(similarity.flip));
}
