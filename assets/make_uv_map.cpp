// Draws the labelled map: quadrants, graticule, labels, compass letters, arrows, rulers.
#include "make_uv_map.hpp"

#include <cstdlib>
#include <string>
#include <string_view>

#include "block_letters.hpp"

namespace texmap {
namespace {

constexpr int width = 1024;
constexpr int height = 512;
constexpr Rgb8 ink{24, 24, 32};
constexpr Rgb8 paper{255, 255, 255};

/// Two shades each for the north-west, north-east, south-west and south-east. Color-blind readers
/// can tell them apart: the lightness differs, too.
constexpr Rgb8 quadrants[2][2][2] = {
    {{{126, 196, 238}, {104, 180, 226}}, {{250, 214, 110}, {240, 198, 84}}},
    {{{88, 184, 150}, {70, 168, 134}}, {{226, 156, 192}, {212, 138, 177}}},
};

constexpr int column_of(int longitude) { return (longitude + 180) * width / 360; }
constexpr int row_of(int latitude) { return (90 - latitude) * height / 180; }

/// Fills columns left to right - 1 and rows top to bottom - 1, as far as they are in the picture.
void fill(Image& image, int left, int top, int right, int bottom, Rgb8 color) {
  for (int y = top < 0 ? 0 : top; y < bottom && y < image.height; ++y)
    for (int x = left < 0 ? 0 : left; x < right && x < image.width; ++x) image.at(x, y) = color;
}

void fill_disc(Image& image, int column, int row, int radius, Rgb8 color) {
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      if (x * x + y * y > radius * radius) continue;
      fill(image, column + x, row + y, column + x + 1, row + y + 1, color);
    }
  }
}

/// Four quadrants, checkered every 15 degrees to show stretching.
void draw_quadrants(Image& image) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int shade = (x * 24 / width + y * 12 / height) % 2;
      image.at(x, y) = quadrants[y >= height / 2][x >= width / 2][shade];
    }
  }
}

/// A line every 30 degrees; the equator and the prime meridian are thick.
void draw_graticule(Image& image) {
  for (int longitude = -180; longitude <= 180; longitude += 30) {
    const int half = longitude == 0 ? 2 : 1;
    fill(image, column_of(longitude) - half, 0, column_of(longitude) + half, height, ink);
  }
  for (int latitude = -90; latitude <= 90; latitude += 30) {
    const int half = latitude == 0 ? 2 : 1;
    fill(image, 0, row_of(latitude) - half, width, row_of(latitude) + half, ink);
  }
}

void draw_outlined(Image& image, int column, int row, std::string_view text, int scale) {
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) draw_blocks(image, column + dx, row + dy, text, paper, scale);
  draw_blocks(image, column, row, text, ink, scale);
}

void draw_centered(Image& image, int column, int row, std::string_view text, int scale) {
  draw_blocks(image, column - block_width(text, scale) / 2, row, text, ink, scale);
}

/// An arrow from (u, v) = (0.5, 0.5) to the right or up, with a white outline.
void draw_arrow(Image& image, bool up) {
  const auto part = [&](int from, int to, int half_from, int half_to, Rgb8 color) {
    for (int along = from; along < to; ++along) {
      const int half = half_from + (half_to - half_from) * (along - from) / (to - from);
      if (up) {
        fill(image, width / 2 - half, height / 2 - along, width / 2 + half, height / 2 - along + 1,
             color);
      } else {
        fill(image, width / 2 + along, height / 2 - half, width / 2 + along + 1, height / 2 + half,
             color);
      }
    }
  };
  part(-7, 57, 7, 7, paper);
  part(47, 84, 20, 0, paper);
  part(-4, 57, 4, 4, ink);
  part(52, 78, 14, 0, ink);
}

/// A large letter in a disc, with the coordinates of its center below.
void draw_compass_letter(Image& image, int longitude, int latitude, std::string_view letter,
                         std::string_view place) {
  const int column = column_of(longitude), row = row_of(latitude);
  fill_disc(image, column, row, 40, ink);
  fill_disc(image, column, row, 37, paper);
  draw_centered(image, column, row - 27, letter, 6);
  draw_centered(image, column, row + 20, place, 1);
}

/// A longitude or latitude; 0 and 180 degrees have no direction.
std::string angle_label(int angle, const char* negative, const char* positive) {
  const std::string degrees = std::to_string(std::abs(angle)) + "°";
  return angle % 180 == 0 ? degrees : degrees + (angle < 0 ? negative : positive);
}

std::string longitude_label(int longitude) { return angle_label(longitude, "W", "E"); }
std::string latitude_label(int latitude) { return angle_label(latitude, "S", "N"); }

/// Longitude and latitude next to each crossing, on its side toward the equator.
void draw_labels(Image& image) {
  for (int longitude = -180; longitude < 180; longitude += 30) {
    for (int latitude = -60; latitude <= 60; latitude += 30) {
      if (latitude == 0 && std::abs(longitude) == 90) continue;     // a compass letter is there
      const int aside = longitude == 0 && latitude == 30 ? 15 : 0;  // out of the way of the arrow
      const int column = column_of(longitude) + 7 + aside;
      const int row = row_of(latitude) + (latitude < 0 ? -40 : 8);
      draw_blocks(image, column, row, longitude_label(longitude), ink, 2);
      draw_blocks(image, column, row + 17, latitude_label(latitude), ink, 2);
    }
  }
}

/// A tag for a value of u or v; dark, to differ from the labels of the graticule.
void draw_tag(Image& image, int column, int row, std::string_view text) {
  fill(image, column, row, column + block_width(text, 2) + 8, row + 20, ink);
  draw_blocks(image, column + 4, row + 3, text, paper, 2);
}

void draw_rulers(Image& image) {
  const std::string_view quarters[] = {"0", ".25", ".5", ".75", "1"};
  for (int i = 0; i <= 4; ++i) {
    const std::string u = "u=" + std::string(quarters[i]), v = "v=" + std::string(quarters[i]);
    const int tag = block_width(u, 2) + 8;
    const int column = i * width / 4, row = height - i * height / 4;

    // Along the bottom: centered on its value, but inside the picture at both ends.
    draw_tag(image, i == 0 ? 0 : i == 4 ? width - tag : column - tag / 2, height - 20, u);
    fill(image, column - 2, height - 32, column + 2, height - 20, ink);

    // Along the left: above its value; below it near the top, and above u's tag at the bottom.
    draw_tag(image, 0, i == 0 ? row - 44 : i >= 3 ? row + 2 : row - 28, v);
    fill(image, 0, row - 2, 14, row + 2, ink);
  }
}

}  // namespace

Image make_uv_map() {
  Image image(width, height);
  draw_quadrants(image);
  draw_graticule(image);
  draw_labels(image);
  for (const int longitude : {-135, -45, 45, 135}) {
    draw_compass_letter(image, longitude, 75, "N", longitude_label(longitude));
    draw_compass_letter(image, longitude, -75, "S", longitude_label(longitude));
  }
  draw_compass_letter(image, -75, 0, "W", "75°W 0°");
  draw_compass_letter(image, 105, 0, "E", "105°E 0°");
  draw_arrow(image, false);
  draw_arrow(image, true);
  draw_outlined(image, width / 2 + 42, height / 2 - 44, "+u", 3);
  draw_outlined(image, width / 2 - 46, height / 2 - 42, "+v", 3);
  draw_rulers(image);
  return image;
}

}  // namespace texmap
