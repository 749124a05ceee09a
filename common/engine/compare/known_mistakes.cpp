// Which known mistake drew a picture.
#include "engine/compare/known_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <sstream>
#include <system_error>
#include <utility>

#include "engine/compare/difference.hpp"
#include "engine/draw/threads.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "math/srgb.hpp"

namespace texmap {
namespace {

constexpr double times_nearer_than_the_right = 16;
constexpr double times_nearer_than_another = 2;
constexpr std::uint64_t max_file_of_words = 1U << 20;

constexpr bool same_size(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height;
}

constexpr double far_away = std::numeric_limits<double>::infinity();

/// The sum of the differences of all channels, each less one level, which rounding can make.
/// Pictures of different sizes, and those with a sum above `limit`, are far away.
double distance_between(const Image& a, const Image& b, double limit = far_away) {
  if (!same_size(a, b)) return far_away;
  double sum = 0;
  for (int row = 0; row < a.height; ++row) {
    int of_row = 0;
    for (int column = 0; column < a.width; ++column) {
      const Rgb8 p = a.at(column, row), q = b.at(column, row);
      const auto above_one = [](int apart) { return std::max(std::abs(apart) - 1, 0); };
      of_row += above_one(p.r - q.r) + above_one(p.g - q.g) + above_one(p.b - q.b);
    }
    sum += of_row;
    if (sum > limit) return far_away;
  }
  return sum;
}

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
constexpr auto bgr = with_channels<&Rgb8::b, &Rgb8::g, &Rgb8::r>;
constexpr auto gbr = with_channels<&Rgb8::g, &Rgb8::b, &Rgb8::r>;
constexpr auto brg = with_channels<&Rgb8::b, &Rgb8::r, &Rgb8::g>;

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

/// The share of pixels that differ by more than so many levels.
double share_off(const Image& a, const Image& b, int levels) {
  std::size_t off = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    off += channel_difference(a.pixels[i], b.pixels[i]) > levels ? 1U : 0U;
  return static_cast<double>(off) / static_cast<double>(a.pixels.size());
}

/// Each pixel the mean of `2 * reach + 1` around it, along columns or along rows.
Image averaged(const Image& image, int reach, bool along_rows) {
  return image_of(image.width, image.height, [&](int x, int y) {
    std::array<int, 3> sum{};
    for (int i = -reach; i <= reach; ++i) {
      const Rgb8 p = image.at(std::clamp(along_rows ? x + i : x, 0, image.width - 1),
                              std::clamp(along_rows ? y : y + i, 0, image.height - 1));
      sum = {sum[0] + p.r, sum[1] + p.g, sum[2] + p.b};
    }
    const auto mean = [&](int of) { return static_cast<std::uint8_t>(of / (2 * reach + 1)); };
    return Rgb8{mean(sum[0]), mean(sum[1]), mean(sum[2])};
  });
}

/// The sum of all steps from a pixel to the next.
double roughness(const Image& image) {
  const Image next = placed(image, [&](int x, int y) { return Place(std::max(x - 1, 0), y); });
  const Image below = placed(image, [&](int x, int y) { return Place(x, std::max(y - 1, 0)); });
  return distance_between(image, next) + distance_between(image, below);
}

/// Words for a picture that has the right one's shapes, but softer or rougher; else none.
std::string name_roughness(const Image& drawn, const Image& right) {
  if (share_off(drawn, right, 1) < 0.01) return "";  // a few pixels are something else
  const double apart = apart_when_soft(drawn, right);
  const double rough = roughness(drawn) / roughness(right);
  if ((rough < 0.97 && apart < nearly_the_same) || (rough < 0.8 && apart < 0.03))
    return "softer than it should be: scaled, blurred, or drawn with more samples or a filter";
  if (rough > 1.03 && apart < nearly_the_same)
    return "rougher than it should be: noise, a file with losses (JPEG, GIF), or enlarged pixels";
  return "";
}

/// Words for a picture whose levels, from 0 to 255, are a function of the right ones; else none.
std::string name_curve(const Image& drawn, const Image& right) {
  std::array<double, 256> sum{}, count{};
  const auto for_each_channel = [&](const auto& see) {
    for (std::size_t i = 0; i < right.pixels.size(); ++i) {
      const Rgb8 is = drawn.pixels[i], should = right.pixels[i];
      see(should.r, is.r), see(should.g, is.g), see(should.b, is.b);
    }
  };
  for_each_channel([&](std::uint8_t should, int is) {
    sum[should] += is;
    count[should] += 1;
  });
  std::array<int, 256> became{};
  for (std::size_t i = 0; i < 256; ++i)
    became[i] = static_cast<int>(std::lround(sum[i] / std::max(count[i], 1.0)));
  std::size_t off = 0, unexplained = 0;
  for_each_channel([&](std::uint8_t should, int is) {
    off += std::abs(is - should) > 1 ? 1U : 0U;
    unexplained += std::abs(is - became[should]) > 1 ? 1U : 0U;
  });
  if (unexplained * 50 > off) return "";
  int added = 0;  // to the most frequent level that is not cut off
  double often = 0, product = 0, squares = 0;
  for (std::size_t i = 0; i < 256; ++i) {
    if (became[i] <= 0 || became[i] >= 255) continue;
    if (count[i] > often) added = became[i] - static_cast<int>(i);
    often = std::max(often, count[i]);
    product += count[i] * static_cast<double>(i) * became[i];
    squares += count[i] * static_cast<double>(i) * static_cast<double>(i);
  }
  const double times = product / std::max(squares, 1.0);
  int levels = 0, before = 0;
  bool rises = true, all_up = true, all_down = true, is_sum = true, is_product = true;
  for (int level = 0; level < 256; ++level) {
    const auto i = static_cast<std::size_t>(level);
    if (count[i] == 0) continue;
    levels += became[i] > before || levels == 0 ? 1 : 0;
    rises = rises && became[i] >= before;
    before = became[i];
    all_up = all_up && before >= level - 1;
    all_down = all_down && before <= level + 1;
    is_sum = is_sum && std::abs(std::clamp(level + added, 0, 255) - before) <= 1;
    is_product = is_product && std::abs(std::min(level * times, 255.0) - before) <= 2;
  }
  if (!rises || levels < 16) return "";  // a picture of few levels says too little
  const std::string way = all_up ? "brighter" : all_down ? "darker" : "of another contrast";
  if (is_sum) return way + text(": every channel is %d levels off", std::abs(added));
  if (is_product) return way + text(": every channel is %.2f times what it should be", times);
  return way + ": the levels went through another curve";
}

constexpr Weights equal_weights{1 / 3.0, 1 / 3.0, 1 / 3.0};
constexpr Weights weights_of_1982{0.299, 0.587, 0.114};     // ITU-R BT.601
constexpr Weights weights_of_1990{0.2126, 0.7152, 0.0722};  // ITU-R BT.709

}  // namespace

Image shrunk(const Image& image, int columns, int rows) {
  const auto begin = [](int part, int all, int count) { return part * all / count; };
  return image_of(columns, rows, [&](int column, int row) {
    int r = 0, g = 0, b = 0, pixels = 0;
    const int right = begin(column + 1, image.width, columns);
    const int bottom = begin(row + 1, image.height, rows);
    for (int y = begin(row, image.height, rows); y < bottom; ++y) {
      for (int x = begin(column, image.width, columns); x < right; ++x, ++pixels) {
        const Rgb8 p = image.at(x, y);
        r += p.r;
        g += p.g;
        b += p.b;
      }
    }
    const auto mean = [=](int sum) { return static_cast<std::uint8_t>(sum / std::max(pixels, 1)); };
    return Rgb8{mean(r), mean(g), mean(b)};
  });
}

bool is_same_picture(const Image& a, const Image& b) {
  return same_size(a, b) && (a.pixels.empty() || share_off(a, b, 1) <= 1.0 / 5000);
}

double apart_when_soft(const Image& a, const Image& b) {
  const auto soft = [](const Image& image) { return averaged(averaged(image, 8, true), 8, false); };
  return same_size(a, b) ? share_off(soft(a), soft(b), 6) : 1;
}

std::string name_mistake(const Image& drawn, const Image& right,
                         std::span<const WrongPicture> wrong) {
  if (!same_size(drawn, right) || is_same_picture(drawn, right)) return "";
  const double from_right = distance_between(drawn, right);
  // A picture farther than this is not named, and keeps no other from being named.
  const double limit = from_right * times_nearer_than_another / times_nearer_than_the_right;
  std::vector<double> distances(wrong.size(), far_away);
  for_each_row(static_cast<int>(wrong.size()), 0, {}, [&](int i) {
    const Image& picture = wrong[static_cast<std::size_t>(i)].picture;
    // A mistake that does not change this picture must not keep another one from being named.
    if (!same_size(picture, right) || is_same_picture(picture, right)) return;
    distances[static_cast<std::size_t>(i)] = distance_between(drawn, picture, limit);
  });
  const auto least_of_all = std::min_element(distances.begin(), distances.end());
  const auto by_figures = [&] {
    const std::string words = name_curve(drawn, right);
    return words.empty() ? name_roughness(drawn, right) : words;
  };
  if (least_of_all == distances.end() || *least_of_all == far_away) return by_figures();
  const double least = *least_of_all;
  const WrongPicture& nearest = wrong[static_cast<std::size_t>(least_of_all - distances.begin())];
  if (times_nearer_than_the_right * least > from_right ||
      times_nearer_than_the_right * least > distance_between(right, nearest.picture)) {
    return by_figures();
  }
  std::string words = nearest.words;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    if (distances[i] > times_nearer_than_another * least) continue;
    if (!is_same_picture(wrong[i].picture, nearest.picture)) return "";
    if (words.find(wrong[i].words) == std::string::npos) words += "; or " + wrong[i].words;
  }
  return words;
}

std::string short_words(const std::string& words) {
  const std::size_t second = words.find("; or ");
  if (second != std::string::npos)
    return short_words(words.substr(0, second)) + " or " + short_words(words.substr(second + 5));
  return words.substr(0, std::min(words.find(": "), words.find("; ")));
}

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

std::vector<WrongPicture> mistaken_maps(const Image& map) {
  const std::string quarter =
      "a quarter turn off: u begins at another place, or the globe is turned";
  const std::string gray = "gray: the texture's colors are lost";
  const int half = map.width / 2, fourth = map.width / 4;
  return {
      {"mirrored", "mirrored: u runs the other way", flipped(map, true, false)},
      {"upside_down", "upside down: v runs the other way", flipped(map, false, true)},
      {"half_turn", "turned by half: u and v run the other way", flipped(map, true, true)},
      {"quarter_east", quarter, moved_by(map, fourth, 0)},
      {"quarter_west", quarter, moved_by(map, -fourth, 0)},
      {"opposite", "half a turn off: u begins on the other side, or the globe is turned",
       moved_by(map, half, 0)},
      {"stripes", "striped: u is negative on one half and was limited to 0; the 1/2 is missing",
       placed(map, [&](int x, int y) { return Place(std::max(x - half, 0), y); })},
      {"exchanged", "u and v are exchanged", transposed(map)},
      {"by_height", "squeezed at the poles: v was taken from the height, without the angle",
       by_height(map)},
      {"half_texel_left", "half a texel to the left: u n was rounded and not cut off",
       moved_by(map, -1, 0, 2)},
      {"half_texel_right", "half a texel to the right", moved_by(map, 1, 0, 2)},
      {"half_texel_up", "half a texel up", moved_by(map, 0, -1, 2)},
      {"half_texel_down", "half a texel down", moved_by(map, 0, 1, 2)},
      {"texel_left", "one texel to the left: columns were counted from 1", moved_by(map, -1, 0)},
      {"texel_right", "one texel to the right", moved_by(map, 1, 0)},
      {"texel_up", "one texel up: rows were counted from 1", moved_by(map, 0, -1)},
      {"texel_down", "one texel down", moved_by(map, 0, 1)},
      {"bgr", "red and blue are exchanged in the texture", bgr(map)},
      {"gray", gray, grayed(map, equal_weights)},
      {"gray_601", gray, grayed(map, weights_of_1982)},
      {"gray_709", gray, grayed(map, weights_of_1990)},
      {"decoded", "the texture is too dark: its bytes were decoded and never encoded again",
       through_curve(map, srgb_decode<double>)},
      {"encoded", "the texture is too pale: its bytes were encoded twice",
       through_curve(map, srgb_encode<double>)},
      {"black", "black texture: the file was not loaded, and the program did not check",
       Image(map.width, map.height)},
  };
}

std::vector<WrongPicture> load_wrong_pictures(const std::filesystem::path& folder) {
  const std::filesystem::path table = folder / "mistakes.txt";
  const std::vector<std::uint8_t> bytes =
      with_name("cannot read", table, [&] { return read_file(table, max_file_of_words); });
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::vector<WrongPicture> wrong;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos)
      throw FileError("cannot read '" + name_of(table) + "': a line without a tab: " + line);
    const std::filesystem::path file = path_of(line.substr(0, tab));
    wrong.push_back(
        {name_of(file.stem()), line.substr(tab + 1), load_image(folder / file.filename())});
  }
  return wrong;
}

bool has_drawn_mistakes(const std::filesystem::path& folder, const Image& right) {
  if (!exists(folder / "mistakes.txt")) return false;
  const std::filesystem::path drawn = folder / "right.png";
  return !exists(drawn) || is_same_picture(load_image(drawn), right);
}

std::vector<WrongPicture> known_mistakes(const std::filesystem::path& folder, const Image& right) {
  std::vector<WrongPicture> known;
  if (has_drawn_mistakes(folder, right)) known = load_wrong_pictures(folder);
  for (WrongPicture& one : mistakes_of_the_whole(right)) {
    if (std::none_of(known.begin(), known.end(),
                     [&](const auto& drawn) { return drawn.name == one.name; }))
      known.push_back(std::move(one));
  }
  return known;
}

std::vector<WrongPicture> right_pictures(const std::filesystem::path& folder) {
  std::vector<WrongPicture> right;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::string name = name_of(entry.path().stem());
    if (entry.path().extension() != ".png") continue;
    try {
      right.push_back(
          {name, "a picture of chapter " + name.substr(0, 2), load_image(entry.path())});
    } catch (const FileError&) {  // less is known
    }
  }
  std::sort(right.begin(), right.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return right;
}

void save_wrong_pictures(std::span<const WrongPicture> wrong, const std::filesystem::path& folder) {
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);  // if it fails, writing says so
  std::string table;
  for (const WrongPicture& one : wrong) {
    save_png(one.picture, folder / (one.name + ".png"));
    table.append(one.name).append(".png\t").append(one.words).append("\n");
  }
  const std::filesystem::path file = folder / "mistakes.txt";
  with_name("cannot write", file, [&] { write_text_atomically(file, table); });
}

}  // namespace texmap
