// Draws the crate from back to front: planks with the stencil, brace, frame, nails.
#include "make_crate.hpp"

#include <algorithm>
#include <cmath>

#include "block_letters.hpp"
#include "noise.hpp"
#include "paint.hpp"

namespace texmap {
namespace {

constexpr int side = 512;
constexpr int frame = 62;       // width of the frame's boards
constexpr int planks = 6;       // upright, between the frame's boards
constexpr double brace = 29.0;  // half the width of the brace

constexpr Paint pale_wood{206, 164, 108};
constexpr Paint dark_wood{150, 104, 58};
constexpr Paint shadow{52, 32, 16};
constexpr Paint stencil_ink{44, 34, 30};

/// The color of a board.
///
/// @param along, across  place on the board in pixels, with and against the grain
/// @param board          a different number for each board; selects its grain and tone
Paint wood(double along, double across, int board) {
  const double tone = lattice_value(board, 3, 7);
  // Year rings: lines along the grain, bent by noise of low frequency and by a knot.
  const double bend = 9 * layered_noise(along / 170, across / 60, board * 5.0, 2);
  const double knot_along = 60 + 380 * lattice_value(board, 1, 1),
               knot_across = 10 + 40 * lattice_value(board, 2, 2);
  const double da = (along - knot_along) / 2.6, dc = across - knot_across;
  const double knot = 1 / (1 + (da * da + dc * dc) / 60);
  const double rings = (across + bend + 26 * knot * (dc < 0 ? -1 : 1)) / 6.5;
  const double ring = rings - std::floor(rings);
  const double grain = ring < 0.75 ? ring / 0.75 : (1 - ring) / 0.25;
  const double fibre = layered_noise(along / 34, across / 1.6, board * 9.0, 2);
  const double shade = 0.30 * grain + 0.22 * fibre + 0.35 * tone + 0.55 * knot * knot;
  return mix(pale_wood, dark_wood, std::clamp(shade, 0.0, 1.2));
}

/// Shades the edges of a board: bright at the upper left, dark at the lower right.
///
/// @param from_low, from_high  pixels to the edge towards the light and to the edge away from it
Paint bevelled(Paint p, double from_low, double from_high) {
  if (from_low < 3) p = scaled(p, 1.2 - 0.05 * from_low);
  if (from_high < 4) p = scaled(p, 0.7 + 0.06 * from_high);
  return p;
}

/// The shadow that a raised board casts at a distance in pixels from its edge.
Paint shaded(Paint p, double distance) {
  return distance < 0 ? p : mix(p, shadow, 0.6 * (1 - smooth_step(distance / 14)));
}

/// Distance from the brace's center line (lower left to upper right), positive below it.
double from_brace(double x, double y) { return (x + y - side) / std::sqrt(2.0); }

/// How much of the stencil's ink covers each pixel, 0 to 255: drawn, blurred and sharpened again,
/// which rounds the corners of the letters.
Image stencil() {
  Image hard(side, side);
  constexpr Rgb8 full{255, 255, 255};
  const int left = frame + 24, top = frame + 24;
  draw_blocks(hard, left, top, "THIS", full, 7);
  draw_blocks(hard, left, top + 60, "SIDE", full, 7);
  draw_blocks(hard, left, top + 120, "UP", full, 7);
  const int tip_column = 374, tip_row = 254;
  for (int y = 0; y < 166; ++y) {
    const int half = y < 66 ? y * 50 / 66 : 19;
    for (int x = -half; x < half; ++x) hard.at(tip_column + x, tip_row + y) = full;
  }
  for (int x = -50; x < 50; ++x)
    for (int y = 0; y < 13; ++y) hard.at(tip_column + x, tip_row + 178 + y) = full;

  constexpr int reach = 3;
  Image smooth(side, side);
  for (int y = reach; y < side - reach; ++y) {
    for (int x = reach; x < side - reach; ++x) {
      int covered = 0;
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
          covered += hard.at(x + dx, y + dy).r == 255 ? 1 : 0;
        }
      }
      const double share = covered / ((2.0 * reach + 1) * (2.0 * reach + 1));
      smooth.at(x, y) = rounded(scaled({255, 255, 255}, smooth_step((share - 0.3) / 0.28)));
    }
  }
  return smooth;
}

/// The upright planks at the back, with the stencil.
Paint plank_color(int x, int y, const Image& ink) {
  const int room = side - 2 * frame;
  const int plank = (x - frame) * planks / room;
  const int left = frame + (plank * room + planks - 1) / planks,
            right = frame + ((plank + 1) * room + planks - 1) / planks;
  Paint color = wood(y, x - left, plank + 10);
  color = scaled(color, 0.9);
  const double worn = 0.84 + 0.3 * layered_noise(x / 14.0, y / 14.0, 77, 4);
  color = mix(color, stencil_ink, std::clamp(worn, 0.0, 0.92) * ink.at(x, y).r / 255.0);
  color = bevelled(color, x - left, right - 1 - x);
  return x - left < 2 ? mix(color, shadow, 0.85) : color;  // the gap between two planks
}

/// One of the four boards of the frame; the upright ones run from top to bottom.
Paint frame_color(int x, int y) {
  if (x < frame) return bevelled(wood(y, x, 1), x, frame - 1 - x);
  if (x >= side - frame)
    return bevelled(wood(y, x - (side - frame), 2), x - (side - frame), side - 1 - x);
  if (y < frame) return bevelled(wood(x, y, 3), y, frame - 1 - y);
  return bevelled(wood(x, y - (side - frame), 4), y - (side - frame), side - 1 - y);
}

void drive_nail(Image& image, int column, int row) {
  constexpr int radius = 5;
  for (int y = -radius - 2; y <= radius + 2; ++y) {
    for (int x = -radius - 2; x <= radius + 2; ++x) {
      Rgb8& pixel = image.at(column + x, row + y);
      const double out = std::sqrt(static_cast<double>(x * x + y * y));
      if (out > radius + 1.5) continue;
      const double light = std::clamp(0.62 - (x + y) / 16.0, 0.2, 1.0);
      const Paint head = mix({46, 44, 46}, {196, 194, 190}, light);
      const Paint rim = mix(paint_of(pixel), shadow, 0.75);
      pixel = rounded(mix(head, rim, smooth_step((out - radius + 1) / 1.4)));
    }
  }
}

}  // namespace

Image make_crate() {
  Image image(side, side);
  const Image ink = stencil();
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool in_frame = x < frame || x >= side - frame || y < frame || y >= side - frame;
      const double off = from_brace(x + 0.5, y + 0.5);
      Paint color;
      if (in_frame) {
        color = frame_color(x, y);
        // The joints: a dark line where the level boards meet the upright ones.
        const bool level = y < frame || y >= side - frame;
        if (level && (x == frame || x == side - frame - 1)) color = mix(color, shadow, 0.7);
      } else {
        if (std::abs(off) <= brace) {
          color = bevelled(wood((x - y + side) / std::sqrt(2.0), off + brace, 5), off + brace,
                           brace - off);
        } else {
          color = shaded(plank_color(x, y, ink), off - brace);
        }
        // The frame lies on top; its shadow falls to the right and down.
        color = shaded(shaded(color, x - frame), y - frame);
      }
      image.at(x, y) = rounded(color);
    }
  }

  const int near = frame / 2, far = side - frame / 2;
  for (const int at : {near, side * 3 / 10, side / 2, side * 7 / 10, far}) {
    drive_nail(image, at, near);
    drive_nail(image, at, far);
    if (at != near && at != far) {
      drive_nail(image, near, at);
      drive_nail(image, far, at);
    }
  }
  for (const int at : {frame + 34, side / 2, side - frame - 34}) {
    drive_nail(image, at - 9, side - at - 9);
    drive_nail(image, at + 9, side - at + 9);
  }
  return image;
}

}  // namespace texmap
