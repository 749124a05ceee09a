// How two pictures differ, in figures.
#pragma once
#include <array>
#include <cstddef>
#include <stdexcept>

#include "image.hpp"

namespace texmap {

/// Two pictures that cannot be compared, such as pictures of different sizes; what() is a whole sentence.
class DifferenceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A rectangle of pixels.
struct Box {
  int left = 0, top = 0, width = 0, height = 0;
  friend bool operator==(const Box&, const Box&) = default;
};

/// The pixel that differs most; the first one of them from the top, and in a row from the left.
struct WorstPixel {
  int column = 0, row = 0;
  int levels = 0;  ///< of the channel that differs most, 0 to 255
  Rgb8 a, b;       ///< the two values
};

/// How two pictures differ. All means are over the compared pixels; levels are those of a channel, 0 to 255.
struct Figures {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels

  std::size_t pixels_compared = 0;
  std::size_t pixels_different = 0;  ///< in any channel, by any amount
  double share_different = 0;        ///< of the compared pixels, 0 to 1
  Box box;                           ///< the smallest that holds all pixels that differ; of no size if there are none
  WorstPixel worst;                  ///< levels 0 if no pixel differs

  double mean_absolute_error = 0;     ///< levels, mean of |a - b| over pixels and channels
  double root_mean_square_error = 0;  ///< levels, the root of the mean of (a - b)^2 over pixels and channels
  double peak_signal_to_noise = 0;    ///< dB, 20 log10(255 / root_mean_square_error); infinity if the pictures are equal
  double structural_similarity = 1;   ///< mean of ssim_rows over windows inside the picture, -1 to 1; 1 if equal
  double flip = 0;                    ///< mean of flip_rows at usual_pixels_per_degree, 0 to 1; 0 if equal
  double mean_a = 0, mean_b = 0;      ///< levels, mean over pixels and channels of each picture

  /// How many of the compared pixels differ by 0, 1, ... 255 levels in the channel that differs most.
  std::array<std::size_t, 256> pixels_by_levels{};
};

/// The difference of the channel that differs most, in levels, 0 to 255.
[[nodiscard]] int channel_difference(Rgb8 p, Rgb8 q);

/// True unless the mask is black at this pixel. An empty mask leaves nothing out.
[[nodiscard]] bool is_compared(const Image& mask, int column, int row);

/// Refuses pictures and masks that do not fit each other.
/// Errors: DifferenceError naming the sizes.
void check_sizes(const Image& a, const Image& b, const Image& mask = {});

/// Compares two pictures.
///
/// SSIM is, as in its paper, the mean over the compared pixels whose window lies inside the picture, those at least 5 pixels
/// from its edges: the figure of scikit-image's structural_similarity with gaussian_weights, sigma 1.5 and without sample
/// covariance. If there are no such pixels, as in a picture of 10 by 10, it is the mean over all compared pixels.
///
/// What is left out by the mask is equal by every figure: for SSIM and FLIP, whose values depend on the pixels around, the left
/// out pixels of `b` are taken from `a`, and their own values are not in the mean.
///
/// @param a, b  pictures of one size, at least one pixel
/// @param mask  a picture of the same size whose black pixels are left out; empty for none
/// Errors: DifferenceError if the sizes differ, the pictures are empty, or the mask leaves out every pixel; std::bad_alloc.
/// Source: ssim.hpp and flip.hpp for these two; peak and mean square error as in Wang and others, 2004, section I.
[[nodiscard]] Figures measure(const Image& a, const Image& b, const Image& mask = {});

/// How many of the compared pixels have a channel that differs by more than so many levels.
///
/// @param levels  0 to 255
[[nodiscard]] std::size_t pixels_off_by_more_than(const Figures& figures, int levels);

}  // namespace texmap
