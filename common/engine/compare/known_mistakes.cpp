// Which known mistake drew a picture.
#include "engine/compare/known_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <system_error>
#include <utility>

#include "engine/compare/difference.hpp"
#include "engine/draw/threads.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

constexpr double times_nearer_than_the_right = 16;
constexpr double times_nearer_than_another = 2;

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
  const auto moved = [&](int right, int down) {
    return image_of(image.width, image.height, [&](int x, int y) {
      return image.at(std::max(x - right, 0), std::max(y - down, 0));
    });
  };
  return distance_between(image, moved(1, 0)) + distance_between(image, moved(0, 1));
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
  /// True if it is of all levels that the right picture has, and of what they became.
  const auto holds = [&](const auto& of) {
    for (int level = 0; level < 256; ++level) {
      const auto i = static_cast<std::size_t>(level);
      if (count[i] > 0 && !of(level, became[i])) return false;
    }
    return true;
  };
  int levels = 0, before = -1;
  const bool rises = holds([&](int, int is) {
    levels += is > before ? 1 : 0;
    return is >= std::exchange(before, is);
  });
  if (!rises || levels < 16) return "";  // a picture of few levels says too little
  const bool all_up = holds([](int level, int is) { return is >= level - 1; });
  const bool all_down = holds([](int level, int is) { return is <= level + 1; });
  const std::string way = all_up ? "brighter" : all_down ? "darker" : "of another contrast";
  if (holds(
          [&](int level, int is) { return std::abs(std::clamp(level + added, 0, 255) - is) <= 1; }))
    return way + text(": every channel is %d levels off", std::abs(added));
  if (holds([&](int level, int is) { return std::abs(std::min(level * times, 255.0) - is) <= 2; }))
    return way + text(": every channel is %.2f times what it should be", times);
  return way + ": the levels went through another curve";
}

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
  for (const std::string join : {" or ", " and "}) {
    const std::size_t second = words.find(";" + join);
    if (second == std::string::npos) continue;
    return short_words(words.substr(0, second)) + join +
           short_words(words.substr(second + 1 + join.size()));
  }
  return words.substr(0, std::min(words.find(": "), words.find("; ")));
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

}  // namespace texmap
