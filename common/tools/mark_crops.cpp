// Puts crops of pictures next to each other, each with a number and with rings around what to see.
// usage: mark_crops OUT.png (FILE COLUMN,ROW,SCALE NUMBER[:RING]...)...
//   COLUMN,ROW  the upper left corner of the crop in the picture
//   SCALE       each of its pixels becomes so many rows and columns, 1, 2, 5 or 10
//   NUMBER      what the crop, 200 x 150 pixels large, shows in its lower left corner
//   RING        COLUMN,ROW,WIDE,HIGH: an ellipse's middle in the crop, and its half axes; colons
//               join several, and a crop may have none
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/picture/bitmap_font.hpp"
#include "engine/picture/blit.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/file_error.hpp"
#include "engine/system/system.hpp"

namespace {

using namespace texmap;

constexpr int crop_width = 200, crop_height = 150, gap = 6;
constexpr Rgb8 dark{20, 20, 20}, light{255, 225, 0}, paper{255, 255, 255};

std::vector<std::string> split(const std::string& text, char between) {
  std::vector<std::string> parts;
  std::istringstream rest(text);
  for (std::string part; std::getline(rest, part, between);) parts.push_back(part);
  return parts;
}

/// `count` whole numbers with commas between them.
std::vector<int> numbers(const std::string& typed, std::size_t count) {
  std::vector<int> values;
  values.reserve(count);
  for (const std::string& part : split(typed, ','))
    values.push_back(parse_whole("a crop", part, 0, 16384));
  if (values.size() != count)
    throw UsageError("'" + typed + "' is not " + std::to_string(count) + " numbers");
  return values;
}

Image cut(const Image& picture, int column, int row, int scale) {
  if (scale < 1 || crop_width % scale != 0 || crop_height % scale != 0)
    throw UsageError("the scale of a crop is 1, 2, 5 or 10");
  if (column + crop_width / scale > picture.width || row + crop_height / scale > picture.height)
    throw UsageError("a crop reaches beyond its picture");
  Image crop(crop_width, crop_height);
  for (int y = 0; y < crop_height; ++y) {
    for (int x = 0; x < crop_width; ++x)
      crop.at(x, y) = picture.at(column + x / scale, row + y / scale);
  }
  return crop;
}

/// A light ellipse between two dark ones: it shows on every ground.
void draw_ring(Image& crop, int column, int row, int wide, int high) {
  const auto inside = [&](int x, int y, int grown) {
    const double a = static_cast<double>(x - column) / (wide + grown);
    const double b = static_cast<double>(y - row) / (high + grown);
    return a * a + b * b <= 1;
  };
  for (int y = 0; y < crop.height; ++y) {
    for (int x = 0; x < crop.width; ++x) {
      if (!inside(x, y, 4) || inside(x, y, 0)) continue;
      crop.at(x, y) = inside(x, y, 3) && !inside(x, y, 1) ? light : dark;
    }
  }
}

void draw_number(Image& crop, std::string_view number) {
  constexpr int scale = 2;
  constexpr int high = 20, row = crop_height - high;
  blit(crop, Image(text_width(number, scale) + 8, high, dark), 0, row);
  draw_text(crop, 4, row + 3, number, light, scale);
}

Image marked(const std::string& file, const std::string& corner, const std::string& marks) {
  const std::vector<int> place = numbers(corner, 3);
  Image crop = cut(load_image(path_of(file)), place[0], place[1], place[2]);
  const std::vector<std::string> parts = split(marks, ':');
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::vector<int> ring = numbers(parts[i], 4);
    draw_ring(crop, ring[0], ring[1], ring[2], ring[3]);
  }
  draw_number(crop, parts[0]);
  return crop;
}

/// A color and how many pixels have it.
struct Counted {
  std::array<int, 3> color{};
  int count = 0;
};

long pixels_of(const std::vector<Counted>& box) {
  long pixels = 0;
  for (const Counted& c : box) pixels += c.count;
  return pixels;
}

/// Leaves at most 256 colors, so that a file with a palette holds the picture: Heckbert's median
/// cut, "Color Image Quantization for Frame Buffer Display", 1982.
void reduce_colors(Image& image) {
  const auto key = [](Rgb8 c) { return std::array<int, 3>{c.r, c.g, c.b}; };
  std::map<std::array<int, 3>, int> counts;
  for (const Rgb8 pixel : image.pixels) ++counts[key(pixel)];
  std::vector<std::vector<Counted>> boxes(1);
  boxes[0].reserve(counts.size());
  for (const auto& [color, count] : counts) boxes[0].push_back({color, count});

  while (boxes.size() < 256) {
    // The box with the most pixels times the square of its longest side is cut across that side.
    std::size_t widest = 0, axis = 0;
    long most = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] =
            std::ranges::minmax(boxes[i], {}, [k](const Counted& c) { return c.color[k]; });
        const long length = high.color[k] - low.color[k];
        const long spread = length * length * pixels_of(boxes[i]);
        if (spread > most) {
          most = spread;
          widest = i;
          axis = k;
        }
      }
    }
    if (most == 0) break;
    std::vector<Counted>& box = boxes[widest];
    std::ranges::sort(box, {}, [axis](const Counted& c) { return c.color[axis]; });
    const long pixels = pixels_of(box);
    std::size_t half = 0;
    for (long seen = 0; half + 1 < box.size() && 2 * seen < pixels; ++half) seen += box[half].count;
    const auto middle = box.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(half, 1));
    std::vector<Counted> rest(middle, box.end());
    box.erase(middle, box.end());
    boxes.push_back(std::move(rest));
  }

  std::map<std::array<int, 3>, Rgb8> mean_of;
  for (const std::vector<Counted>& box : boxes) {
    std::array<long, 3> sum{};
    for (const Counted& c : box) {
      for (std::size_t k = 0; k < 3; ++k) sum[k] += static_cast<long>(c.color[k]) * c.count;
    }
    const long pixels = std::max(pixels_of(box), 1L);  // never 0: a box has a color
    const auto mean = [&](std::size_t k) {
      return static_cast<std::uint8_t>((2 * sum[k] + pixels) / (2 * pixels));
    };
    for (const Counted& c : box) mean_of[c.color] = {mean(0), mean(1), mean(2)};
  }
  for (Rgb8& pixel : image.pixels) pixel = mean_of[key(pixel)];
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words = typed_words(argc, argv);
  if (words.size() < 4 || words.size() % 3 != 1) {
    std::cerr << "usage: mark_crops OUT.png (FILE COLUMN,ROW,SCALE NUMBER:RING...)...\n";
    return 2;
  }
  try {
    const int crops = static_cast<int>(words.size() / 3);
    const int columns = crops <= 4 ? crops : 3;
    const int rows = (crops + columns - 1) / columns;
    Image strip(columns * (crop_width + gap) - gap, rows * (crop_height + gap) - gap, paper);
    for (int i = 0; i < crops; ++i) {
      const auto at = static_cast<std::size_t>(3) * static_cast<std::size_t>(i);
      blit(strip, marked(words[at + 1], words[at + 2], words[at + 3]),
           i % columns * (crop_width + gap), i / columns * (crop_height + gap));
    }
    reduce_colors(strip);
    save_png(strip, path_of(words[0]));
  } catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << '\n';
    return 1;
  }
  return 0;
}
