// How two pictures differ, in figures, for readers and for other programs.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/files/json.hpp"
#include "texture/image.hpp"

namespace texmap {

/// Pictures that cannot be compared, such as pictures of different sizes; what() is a sentence.
class DifferenceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A rectangle of pixels.
struct PixelBox {
  int left = 0, top = 0, width = 0, height = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The pixel that differs most; of several, the first from the top, then from the left.
struct WorstPixel {
  int column = 0, row = 0;
  int levels = 0;  ///< channel_difference(a, b)
  Rgb8 a, b;       ///< the two values
};

/// How two pictures differ. Means are over the compared pixels; levels are those of a channel.
struct Figures {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels

  std::size_t pixels_compared = 0;
  std::size_t pixels_different = 0;  ///< in any channel, by any amount
  double share_different = 0;        ///< of the compared pixels, 0 to 1
  PixelBox box;      ///< the smallest around all pixels that differ; size 0 by 0 if there are none
  WorstPixel worst;  ///< levels 0 if no pixel differs

  double mean_absolute_error = 0;     ///< levels, mean of |a - b| over pixels and channels
  double root_mean_square_error = 0;  ///< levels, over pixels and channels
  double peak_signal_to_noise = 0;    ///< dB; infinity if the pictures are equal
  double structural_similarity = 1;   ///< mean_ssim, -1 to 1; 1 if equal
  double mean_a = 0, mean_b = 0;      ///< levels, mean over pixels and channels of each picture

  /// How many of the compared pixels have a channel_difference of 0, 1, ... 255 levels.
  std::array<std::size_t, 256> pixels_by_levels{};
};

/// The largest difference of a channel, in levels, 0 to 255.
[[nodiscard]] inline int channel_difference(Rgb8 p, Rgb8 q) {
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

/// True unless the mask is black at this pixel. With an empty mask, all pixels are compared.
[[nodiscard]] bool is_compared(const Image& mask, int column, int row);

/// Checks that the pictures and the mask have one size and the pictures have pixels.
/// Errors: DifferenceError with the sizes.
void check_sizes(const Image& a, const Image& b, const Image& mask = {});

/// What to compute: SSIM looks around each pixel and takes ten times as long as all else. Left out,
/// it is NaN, unless the pictures are equal.
enum class Detail {
  pixels,     ///< all but SSIM
  similarity  ///< all
};

/// Compares two pictures; SSIM on all cores.
/// How the mask and the edges enter SSIM: docs/numerics.md.
///
/// @param a, b  pictures of one size, at least one pixel
/// @param mask  a picture of the same size; its black pixels are left out; empty for no mask
/// Errors: DifferenceError if the sizes differ, the pictures are empty, or no pixel is compared.
[[nodiscard]] Figures measure(const Image& a, const Image& b, const Image& mask = {},
                              Detail detail = Detail::similarity);

/// How many of the compared pixels have a channel_difference above so many levels.
///
/// @param levels  0 to 255
[[nodiscard]] std::size_t pixels_off_by_more_than(const Figures& figures, int levels);

/// How many pixels differ, by the rule of golden pictures: such as "2907 of 480000 pixels by more
/// than one level (0.61 %), 1037 by one".
[[nodiscard]] std::string differing_pixels(const Figures& figures);

/// The figures in words: for each its name and its value; SSIM if it was computed.
[[nodiscard]] std::vector<std::vector<std::string>> figure_rows(const Figures& figures);

/// The figures as a JSON object of several lines.
///
/// If the pictures are equal, `box` and `largest_difference` are null. JSON has no infinity: `psnr`
/// is then "infinite" instead of "finite", and `psnr_db` is null.
[[nodiscard]] Json json_of(const Figures& figures);

/// The color of a difference, on one scale from dark blue through grey and sand to bright yellow.
///
/// Each doubling of `levels` + 1 is one eighth of the scale. Reasons for it: docs/numerics.md.
/// @param levels  channel_difference, 0 to 255; 0 gives black, which is not on the scale
[[nodiscard]] Rgb8 difference_color(int levels);

/// The map: each pixel in the color of its difference, hatched where the mask is black, and below
/// it a legend with the scale, unless the picture would then be too large for a file.
///
/// @param a, b, mask  as for measure()
/// Errors: DifferenceError if the sizes differ.
[[nodiscard]] Image difference_map(const Image& a, const Image& b, const Image& mask = {});

}  // namespace texmap
