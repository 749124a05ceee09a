// Puts crops of pictures next to each other, each with a number and with rings around what to see.
// usage: mark_crops OUT.png (FILE COLUMN,ROW,SCALE NUMBER[:RING]...)...
//   COLUMN,ROW  the upper left corner of the crop in the picture
//   SCALE       each of its pixels becomes so many rows and columns, 1, 2, 5 or 10
//   NUMBER      what the crop, 200 x 150 pixels large, shows in its lower left corner
//   RING        COLUMN,ROW,WIDE,HIGH: an ellipse's middle in the crop, and its half axes; colons
//               join several, and a crop may have none
#include <cstddef>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/blit.hpp"
#include "engine/files/file_error.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/stroke_font.hpp"
#include "engine/files/system.hpp"
#include "engine/run/command_line.hpp"

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
  return image_of(crop_width, crop_height,
                  [&](int x, int y) { return picture.at(column + x / scale, row + y / scale); });
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
  constexpr int size = 20, row = crop_height - size;
  blit(crop, Image(text_width(number, size) + 8, size, dark), 0, row);
  draw_text(crop, 4, row + 3, number, light, size);
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
    save_png(strip, path_of(words[0]));
  } catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << '\n';
    return 1;
  }
  return 0;
}
