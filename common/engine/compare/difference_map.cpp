// Where two pictures differ, as a picture.
#include "engine/compare/difference.hpp"

#include <algorithm>
#include <cmath>

#include "engine/files/image_limits.hpp"
#include "engine/files/stroke_font.hpp"
#include "math/srgb.hpp"

namespace texmap {
namespace {

constexpr int doublings = 8;  // of levels + 1, from 1 to 256

// L*, a*, b* at both ends: a blue near black and a yellow near white. All colors between them are
// inside sRGB.
constexpr std::array<double, 3> dark_end = {14, 9, -31};
constexpr std::array<double, 3> bright_end = {93, -10, 66};

constexpr Rgb8 paper{24, 24, 24};
constexpr Rgb8 ink{230, 230, 230};
constexpr Rgb8 hatch_dark{70, 70, 70};
constexpr Rgb8 hatch_light{130, 130, 130};

// The legend, in pixels. A wider map has a larger one: it is as wide as the map, and a page that
// shrinks the map leaves letters that can be read.
constexpr int edge = 8;
constexpr int bar_width = 32 * doublings;
constexpr int bar_height = 16;
constexpr int tick = 4;
constexpr int line_height = 12;
constexpr int number_room = 24;  // for half a number at both ends of the bar
constexpr int legend_width = bar_width + 2 * number_room;
constexpr int legend_height = edge + line_height + bar_height + tick + 2 + 2 * line_height + edge;

Rgb8 srgb_of_lab(const std::array<double, 3>& lab) {
  const auto cubed = [](double f) {
    return f > 6.0 / 29 ? f * f * f : (f - 4.0 / 29) * 3 * (6.0 / 29) * (6.0 / 29);
  };
  const double f = (lab[0] + 16) / 116;
  const double x = 0.95047 * cubed(f + lab[1] / 500);
  const double y = cubed(f);
  const double z = 1.08883 * cubed(f - lab[2] / 200);
  // IEC 61966-2-1:1999, section 5.3.
  const auto byte = [](double linear) {
    return static_cast<std::uint8_t>(std::lround(255 * srgb_encode(std::clamp(linear, 0.0, 1.0))));
  };
  return {byte(3.2406 * x - 1.5372 * y - 0.4986 * z), byte(-0.9689 * x + 1.8758 * y + 0.0415 * z),
          byte(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

/// @param t  position on the scale, 0 to 1
Rgb8 scale_color(double t) {
  std::array<double, 3> lab{};
  for (std::size_t i = 0; i < lab.size(); ++i)
    lab[i] = dark_end[i] + t * (bright_end[i] - dark_end[i]);
  return srgb_of_lab(lab);
}

Rgb8 hatching(int column, int row) { return (column + row) % 6 < 2 ? hatch_light : hatch_dark; }

/// A length of the legend on a map of this width.
int scaled(int length, int width) { return length * width / legend_width; }

void draw_legend(Image& map, int top, bool with_mask) {
  const auto at = [&map](int length) { return scaled(length, map.width); };
  const int size = at(11), left = at(number_room), wide = at(bar_width);
  int row = top + at(edge);
  draw_text(map, at(edge), row, "largest difference of a channel, in levels", ink, size);
  row += at(line_height);
  for (int x = 0; x < wide; ++x) {
    const Rgb8 color = scale_color(static_cast<double>(x) / (wide - 1));
    for (int y = 0; y < at(bar_height); ++y) map.at(left + x, row + y) = color;
  }
  row += at(bar_height);
  for (int i = 0; i <= doublings; ++i) {
    const int middle = left + i * (wide - 1) / doublings;
    for (int y = 0; y < at(tick); ++y) map.at(middle, row + y) = ink;
    const std::string number = std::to_string((1 << i) - 1);
    draw_text(map, middle - text_width(number, size) / 2, row + at(tick + 2), number, ink, size);
  }
  row += at(tick + 2 + line_height);
  draw_text(map, at(edge), row, with_mask ? "black: equal, hatched: left out" : "black: equal", ink,
            size);
}

}  // namespace

Rgb8 difference_color(int levels) {
  if (levels <= 0) return {};
  return scale_color(log1p(static_cast<double>(levels)) / log1p(1.0) / doublings);
}

Image difference_map(const Image& a, const Image& b, const Image& mask) {
  check_sizes(a, b, mask);
  std::array<Rgb8, 256> colors{};
  for (int levels = 0; Rgb8 & color : colors) color = difference_color(levels++);

  const int width = std::max(a.width, legend_width);
  const int height = a.height + scaled(legend_height, width);
  const bool fits =
      static_cast<std::uint32_t>(std::max(width, height)) <= max_image_side &&
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) <= max_image_area;
  Image map = fits ? Image(width, height, paper) : Image(a.width, a.height);
  for (int row = 0; row < a.height; ++row) {
    for (int column = 0; column < a.width; ++column) {
      const auto levels =
          static_cast<std::size_t>(channel_difference(a.at(column, row), b.at(column, row)));
      map.at(column, row) = is_compared(mask, column, row) ? colors[levels] : hatching(column, row);
    }
  }
  if (fits) draw_legend(map, a.height, !mask.pixels.empty());
  return map;
}

}  // namespace texmap
