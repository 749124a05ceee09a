// What known mistakes draw, made of a right picture or of its map.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/compare/known_mistakes.hpp"
#include "math/srgb.hpp"

namespace texmap {
namespace {

using Place = std::pair<int, int>;  // column and row

/// An image whose pixel in a column and a row is that of `image` at the place that `from` says;
/// black where that is outside.
template <class From>
Image placed(const Image& image, const From& from, int width, int height) {
  return image_of(width, height, [&](int column, int row) {
    const auto [x, y] = from(column, row);
    return x >= 0 && x < image.width && y >= 0 && y < image.height ? image.at(x, y) : Rgb8{};
  });
}
template <class From>
Image placed(const Image& image, const From& from) {
  return placed(image, from, image.width, image.height);
}

template <class Change>
Image changed_pixels(Image image, const Change& change) {
  for (Rgb8& pixel : image.pixels) pixel = change(pixel);
  return image;
}

Image flipped(const Image& image, bool columns, bool rows) {
  return placed(image, [&](int x, int y) {
    return Place(columns ? image.width - 1 - x : x, rows ? image.height - 1 - y : y);
  });
}
/// Red, green and blue taken from other channels.
template <auto red, auto green, auto blue>
Image with_channels(const Image& image) {
  return changed_pixels(image, [](Rgb8 p) { return Rgb8{p.*red, p.*green, p.*blue}; });
}
const auto bgr = with_channels<&Rgb8::b, &Rgb8::g, &Rgb8::r>;
const auto gbr = with_channels<&Rgb8::g, &Rgb8::b, &Rgb8::r>;
const auto brg = with_channels<&Rgb8::b, &Rgb8::r, &Rgb8::g>;

/// The picture moved to the right and down; columns come in again at the other side, rows do not.
///
/// @param right, down  in pixels, at most the width or the height
/// @param parts        of a pixel, such as 2 for halves: it is drawn as so many along each move
Image moved_by(const Image& image, int right, int down, int parts = 1) {
  const int across = right == 0 ? 1 : parts, along = down == 0 ? 1 : parts;
  const int columns = across * image.width;
  const auto from = [=, last = image.height - 1](int x, int y) {
    return Place((x - right + columns) % columns / across, std::clamp((y - down) / along, 0, last));
  };
  return placed(image, from, columns, along * image.height);
}

/// Weights of red, green and blue whose sum is 1.
using Weights = std::array<double, 3>;

Image grayed(const Image& image, const Weights& weights) {
  return changed_pixels(image, [&](Rgb8 p) {
    const auto level = static_cast<std::uint8_t>(
        std::lround(weights[0] * p.r + weights[1] * p.g + weights[2] * p.b));
    return Rgb8{level, level, level};
  });
}

Image through_curve(const Image& image, double (*curve)(double)) {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t byte = 0; byte < table.size(); ++byte) {
    table[byte] =
        static_cast<std::uint8_t>(std::lround(255 * curve(static_cast<double>(byte) / 255)));
  }
  return changed_pixels(image, [&](Rgb8 p) { return Rgb8{table[p.r], table[p.g], table[p.b]}; });
}
/// u and v exchanged: the map's column is taken by v, its row by u.
Image transposed(const Image& map) {
  const auto from = [&](int x, int y) { return Place(map.width - 1 - y, map.height - 1 - x); };
  return placed(map, from, map.height, map.width);
}

/// v by the height (y + 1) / 2 in place of the angle: in finer rows, where rows of the map do not
/// begin at whole ones.
Image by_height(const Image& map) {
  const int finer = std::clamp(8192 / map.height, 1, 8);
  std::vector<int> rows;
  for (int row = 0; row < map.height * finer; ++row) {
    const double v = (row + 0.5) / (map.height * finer);
    const double from_top = (1 - cos(std::numbers::pi * v)) / 2;
    rows.push_back(std::clamp(static_cast<int>(from_top * map.height), 0, map.height - 1));
  }
  const auto from = [&](int x, int y) { return Place(x, rows[static_cast<std::size_t>(y)]); };
  return placed(map, from, map.width, map.height * finer);
}

constexpr Weights equal_weights{1 / 3.0, 1 / 3.0, 1 / 3.0};
constexpr Weights weights_of_1982{0.299, 0.587, 0.114};     // ITU-R BT.601
constexpr Weights weights_of_1990{0.2126, 0.7152, 0.0722};  // ITU-R BT.709

}  // namespace

std::vector<WrongPicture> mistakes_of_the_whole(const Image& right) {
  const std::string gray = "gray: the picture's three channels are equal";
  const std::string dark = "too dark: light was written without the curve of image files";
  const std::string pale = "too pale: the curve of image files was applied once too often";
  const std::string order = "the channels of the whole picture are in the wrong order";
  std::vector<WrongPicture> wrong{
      {"picture_mirrored", "the whole picture is mirrored: columns run the other way",
       flipped(right, true, false)},
      {"picture_upside_down", "the whole picture is upside down: rows run the other way",
       flipped(right, false, true)},
      {"picture_half_turn",
       "the whole picture is turned by half: columns and rows run the other way",
       flipped(right, true, true)},
      {"picture_bgr", "red and blue are exchanged in the whole picture", bgr(right)},
      {"picture_gray", gray, grayed(right, equal_weights)},
      {"picture_gray_601", gray, grayed(right, weights_of_1982)},
      {"picture_gray_709", gray, grayed(right, weights_of_1990)},
      {"picture_dark", dark, through_curve(right, srgb_decode<double>)},
      {"picture_dark_squared", dark, through_curve(right, [](double x) { return x * x; })},
      {"picture_pale", pale, through_curve(right, srgb_encode<double>)},
      {"picture_pale_root", pale, through_curve(right, [](double x) { return std::sqrt(x); })},
      {"picture_gbr", order + ": green, blue, red", gbr(right)},
      {"picture_brg", order + ": blue, red, green", brg(right)},
      {"picture_mirrored_bgr", "the whole picture is mirrored, and red and blue are exchanged",
       bgr(flipped(right, true, false))},
      {"picture_upside_down_bgr",
       "the whole picture is upside down, and red and blue are exchanged",
       bgr(flipped(right, false, true))},
      {"picture_inverted", "inverted: each channel is 255 minus what it should be",
       through_curve(right, [](double x) { return 1 - x; })},
      {"picture_black", "black: nothing was drawn", Image(right.width, right.height)},
      {"picture_white", "white: every channel of every pixel is 255",
       Image(right.width, right.height, {255, 255, 255})},
  };
  // A pixel off, whatever fills the edge.
  const char* const both = "off, in columns and in rows";
  const struct {
    const char *name, *words;
    int columns, rows;
  } shifts[] = {
      {"left", "too far to the left", -1, 0},
      {"right", "too far to the right", 1, 0},
      {"up", "too high", 0, -1},
      {"down", "too low", 0, 1},
      {"up_left", both, -1, -1},
      {"down_left", both, -1, 1},
      {"up_right", both, 1, -1},
      {"down_right", both, 1, 1},
  };
  for (const auto& by : shifts) {
    const std::string name = std::string("picture_") + by.name;
    const std::string words = std::string("the whole picture is one pixel ") + by.words;
    const auto black = [&](int x, int y) { return Place(x - by.columns, y - by.rows); };
    const auto around = [&](int x, int y) {
      return Place((x - by.columns + right.width) % right.width,
                   (y - by.rows + right.height) % right.height);
    };
    wrong.push_back({name, words, moved_by(right, by.columns, by.rows)});
    wrong.push_back({name + "_black", words, placed(right, black)});
    if (by.rows != 0) wrong.push_back({name + "_rolled", words, placed(right, around)});
  }
  return wrong;
}

std::vector<WrongPicture> mistaken_maps(const Image& map, std::string_view names) {
  const std::string quarter =
      "a quarter turn off: u begins at another place, or the globe is turned";
  const std::string gray = "gray: the texture's colors are lost";
  const int half = map.width / 2, fourth = map.width / 4;
  struct Row {
    const char* name;
    std::string words;
    std::function<Image()> draw;
  };
  const Row rows[] = {
      {"mirrored", "mirrored: u runs the other way", [&] { return flipped(map, true, false); }},
      {"upside_down", "upside down: v runs the other way",
       [&] { return flipped(map, false, true); }},
      {"half_turn", "turned by half: u and v run the other way",
       [&] { return flipped(map, true, true); }},
      {"quarter_east", quarter, [&] { return moved_by(map, fourth, 0); }},
      {"quarter_west", quarter, [&] { return moved_by(map, -fourth, 0); }},
      {"opposite", "half a turn off: u begins on the other side, or the globe is turned",
       [&] { return moved_by(map, half, 0); }},
      {"stripes", "striped: u is negative on one half and was limited to 0; the 1/2 is missing",
       [&] { return placed(map, [&](int x, int y) { return Place(std::max(x - half, 0), y); }); }},
      {"exchanged", "u and v are exchanged", [&] { return transposed(map); }},
      {"by_height", "squeezed at the poles: v was taken from the height, without the angle",
       [&] { return by_height(map); }},
      {"half_texel_left", "half a texel to the left: u n was rounded and not cut off",
       [&] { return moved_by(map, -1, 0, 2); }},
      {"half_texel_right", "half a texel to the right", [&] { return moved_by(map, 1, 0, 2); }},
      {"half_texel_up", "half a texel up", [&] { return moved_by(map, 0, -1, 2); }},
      {"half_texel_down", "half a texel down", [&] { return moved_by(map, 0, 1, 2); }},
      {"texel_left", "one texel to the left: columns were counted from 1",
       [&] { return moved_by(map, -1, 0); }},
      {"texel_right", "one texel to the right", [&] { return moved_by(map, 1, 0); }},
      {"texel_up", "one texel up: rows were counted from 1", [&] { return moved_by(map, 0, -1); }},
      {"texel_down", "one texel down", [&] { return moved_by(map, 0, 1); }},
      {"bgr", "red and blue are exchanged in the texture", [&] { return bgr(map); }},
      {"gray", gray, [&] { return grayed(map, equal_weights); }},
      {"gray_601", gray, [&] { return grayed(map, weights_of_1982); }},
      {"gray_709", gray, [&] { return grayed(map, weights_of_1990); }},
      {"decoded", "the texture is too dark: its bytes were decoded and never encoded again",
       [&] { return through_curve(map, srgb_decode<double>); }},
      {"encoded", "the texture is too pale: its bytes were encoded twice",
       [&] { return through_curve(map, srgb_encode<double>); }},
      {"black", "black texture: the file was not loaded, and the program did not check",
       [&] { return Image(map.width, map.height); }},
  };
  const auto in_blanks = [](std::string_view word) {
    return std::string(" ").append(word).append(" ");
  };
  const std::string listed = in_blanks(names);
  std::vector<WrongPicture> maps;
  for (const Row& row : rows) {
    if (names.empty() || listed.find(in_blanks(row.name)) != listed.npos)
      maps.push_back({row.name, row.words, row.draw()});
  }
  return maps;
}

}  // namespace texmap
