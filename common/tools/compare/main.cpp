// The program compare: how two pictures differ, in figures, as a picture, and as an exit status; or
// the mean color of a part of one picture.
#include <algorithm>

#include "engine/compare/difference.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/file_error.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"

namespace {

using namespace texmap;

/// A share as typed: "0.02%" is 0.02 of 100, "0.0002" is 0.0002 of 1. Dividing 0.02 by 100
/// would round, and a share of exactly so many pixels could then exceed the limit.
struct Share {
  double number = 0;
  double whole = 1;

  [[nodiscard]] bool holds(std::size_t part, std::size_t all) const {
    return whole * static_cast<double>(part) / static_cast<double>(all) <= number;
  }
};

Share parse_share(const std::string& text) {
  if (!text.ends_with('%')) return {parse_decimal("--at-most", text, 0, 1), 1};
  return {parse_decimal("--at-most", text.substr(0, text.size() - 1), 0, 100), 100};
}

struct Request {
  std::string a, b;
  int levels = 0;
  std::string at_most = "0";
  std::string map, json, mask, mean;
  bool all = false;
  bool quiet = false;

  void declare(CommandLine& line) {
    line.positional("A.png", a, "a picture, PNG or JPEG");
    line.positional("B.png", b, "the picture to compare it with, of the same size", "--mean");
    line.whole("--pixels-off-by-more-than", levels, 0, 255,
               "a pixel counts if one of its channels differs by more than N levels");
    line.text("--at-most", "SHARE", at_most,
              "the pictures count as the same if at most this share of the pixels counts: 0 to 1, "
              "or with a % sign");
    line.text("--map", "FILE", map, "write a picture of the differences to this file, a PNG");
    line.text("--json", "FILE", json, "write all figures to this file, as JSON");
    line.flag("--all", all, "also print SSIM, which takes ten times as long as all else");
    line.text("--mask", "FILE", mask,
              "a picture of the same size; pixels where it is black are not compared");
    line.text("--mean", "X,Y,W,H", mean,
              "of A.png alone, without B.png: mean, least and largest of each channel in the W x H "
              "pixels from column X and row Y on");
    line.flag("--quiet", quiet, "print nothing");
    line.statuses(
        "0 the pictures are the same, or the means are printed; 1 they differ; 2 an error, such as "
        "a file that cannot be read");
  }
};

/// The picture in a file; an empty one where there is no name.
Image load(const std::string& typed) {
  if (typed.empty()) return {};
  const std::filesystem::path path = path_of(typed);
  return with_name("cannot load", path,
                   [&] { return decode_image(read_file(path, max_file_bytes)); });
}

std::string table(const Figures& figures) {
  std::string lines;
  for (const std::vector<std::string>& row : figure_rows(figures))
    lines += text("%-21s%s\n", row[0].c_str(), row[1].c_str());
  return lines;
}

PixelBox parse_box(std::string_view typed) {
  PixelBox box;
  std::size_t begin = 0;
  for (int* number : {&box.left, &box.top, &box.width, &box.height}) {
    const std::size_t end = number == &box.height ? typed.size() : typed.find(',', begin);
    if (end == std::string_view::npos) {
      throw UsageError("--mean takes X,Y,W,H such as 350,250,100,100, not '" + std::string(typed) +
                       "'");
    }
    const bool is_size = number == &box.width || number == &box.height;
    *number = parse_whole("--mean", typed.substr(begin, end - begin), is_size ? 1 : 0,
                          int{max_image_side});
    begin = end + 1;
  }
  return box;
}

/// Mean, least and largest of each channel in a rectangle, in words.
std::string mean_table(const Image& image, const PixelBox& box) {
  if (box.left + box.width > image.width || box.top + box.height > image.height) {
    throw DifferenceError(
        text("the rectangle ends at column %d, row %d; the picture has %d x %d pixels",
             box.left + box.width - 1, box.top + box.height - 1, image.width, image.height));
  }
  std::string lines =
      text("columns %d to %d, rows %d to %d: %d x %d pixels\n", box.left, box.left + box.width - 1,
           box.top, box.top + box.height - 1, box.width, box.height);
  for (const auto& [name, channel] :
       {std::pair{"red", &Rgb8::r}, {"green", &Rgb8::g}, {"blue", &Rgb8::b}}) {
    std::int64_t sum = 0;
    int least = 255, largest = 0;
    for (int row = box.top; row < box.top + box.height; ++row) {
      for (int column = box.left; column < box.left + box.width; ++column) {
        const int byte = image.at(column, row).*channel;
        sum += byte;
        least = std::min(least, byte);
        largest = std::max(largest, byte);
      }
    }
    lines += text("%-6s mean %.2f, least %d, largest %d\n", name,
                  static_cast<double>(sum) / box.width / box.height, least, largest);
  }
  return lines;
}

/// Does all that was asked for. Returns whether the pictures are the same by the chosen rule.
bool compare(const Request& request) {
  const Share at_most = parse_share(request.at_most);
  if (!request.map.empty()) check_output(path_of(request.map));
  if (!request.json.empty()) check_output(path_of(request.json));

  const Image a = load(request.a), b = load(request.b), mask = load(request.mask);
  const Detail detail = request.all || !request.json.empty() ? Detail::similarity : Detail::pixels;
  const Figures figures = measure(a, b, mask, detail);
  const std::size_t off = pixels_off_by_more_than(figures, request.levels);
  const bool same = at_most.holds(off, figures.pixels_compared);

  if (!request.map.empty()) save_png(difference_map(a, b, mask), path_of(request.map));
  if (!request.json.empty()) {
    const std::filesystem::path path = path_of(request.json);
    const std::string json = json_of(figures).text + "\n";
    with_name("cannot write", path, [&] { write_text_atomically(path, json); });
  }
  if (!request.quiet) {
    print(table(figures) + text("off by more than %d: %zu pixels, %s of all allowed: %s\n",
                                request.levels, off, request.at_most.c_str(),
                                same ? "the same" : "they differ"));
  }
  return same;
}

}  // namespace

int main(int argc, char** argv) {
  texmap::CommandLine line("compare", "how two pictures differ, or the mean color of one");
  Request request;
  request.declare(line);
  bool same = true;
  const int status = texmap::run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (request.mean.empty()) {
      same = compare(request);
      return;
    }
    for (const char* other : {"B.png", "--pixels-off-by-more-than", "--at-most", "--map", "--json",
                              "--all", "--mask", "--quiet"}) {
      if (line.was_given(other))
        throw texmap::UsageError(std::string(other) + " and --mean do not go together");
    }
    const PixelBox box = parse_box(request.mean);
    texmap::print(mean_table(load(request.a), box));
  });
  if (status != 0) return 2;
  return same ? 0 : 1;
}
