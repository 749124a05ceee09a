// The program compare: how two pictures differ, in figures, as a picture, and as an exit status.
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/app/run_guarded.hpp"
#include "engine/compare/difference.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/compare/show_figures.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/file_error.hpp"
#include "engine/system/system.hpp"

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
  std::string map, json, mask;
  bool all = false;
  bool quiet = false;

  void declare(CommandLine& line) {
    line.positional("A.png", a, "a picture, PNG or JPEG");
    line.positional("B.png", b, "the picture to compare it with, of the same size");
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
    line.flag("--quiet", quiet, "print nothing");
    line.statuses(
        "0 the pictures are the same; 1 they differ; 2 an error, such as a file that cannot be "
        "read");
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
  texmap::CommandLine line("compare", "how two pictures differ");
  Request request;
  request.declare(line);
  bool same = true;
  const int status = texmap::run_guarded(line, [&] {
    if (line.parse(argc, argv)) same = compare(request);
  });
  if (status != 0) return 2;
  return same ? 0 : 1;
}
