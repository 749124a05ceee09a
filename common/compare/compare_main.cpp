// The program compare: how two pictures differ, in figures, as a picture, and as an exit status.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "decode_image.hpp"
#include "difference.hpp"
#include "difference_map.hpp"
#include "figures_json.hpp"
#include "image_error.hpp"
#include "read_file.hpp"
#include "run_chapter.hpp"
#include "save_png.hpp"
#include "standard_streams.hpp"
#include "write_file.hpp"

namespace {

using namespace texmap;

/// A share as typed: "0.02%" is 0.02 of 100, "0.0002" is 0.0002 of 1. Kept apart, so that a share of exactly so many pixels is
/// not moved by a rounding.
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
  bool quiet = false;

  void declare(CommandLine& line) {
    line.positional("A.png", a, "a picture, PNG or JPEG");
    line.positional("B.png", b, "a picture of the same size to hold against it");
    line.whole("--pixels-off-by-more-than", levels, 0, 255, "levels a channel may differ by before its pixel counts");
    line.text("--at-most", "SHARE", at_most, "share of such pixels that still is the same: 0 to 1, or with a % sign");
    line.text("--map", "FILE", map, "where to put a picture of the differences, a PNG");
    line.text("--json", "FILE", json, "where to put the figures, as JSON");
    line.text("--mask", "FILE", mask, "a picture of the same size; where it is black, nothing is compared");
    line.flag("--quiet", quiet, "print nothing");
    line.statuses("0 the same; 1 they differ; 2 trouble, such as a file that cannot be read");
  }
};

Image load(const std::string& path) {
  try {
    return decode_image(read_file(path));
  } catch (const Refusal& refusal) {
    throw ImageError("cannot load '" + path + "': " + refusal.what());
  }
}

void check_json(const std::string& path) {
  try {
    check_writable(path);
  } catch (const Refusal& refusal) {
    throw ImageError("cannot write '" + path + "': " + refusal.what());
  }
}

void save_json(const std::string& json, const std::string& path) {
  try {
    write_file_atomically(path, std::vector<std::uint8_t>(json.begin(), json.end()));
  } catch (const Refusal& refusal) {
    throw ImageError("cannot write '" + path + "': " + refusal.what());
  }
}

std::string text_of(Rgb8 color) {
  std::ostringstream out;
  out << '(' << int{color.r} << ", " << int{color.g} << ", " << int{color.b} << ')';
  return out.str();
}

/// Some digits, with a point.
std::string text_of(double value, int digits = 6) {
  if (std::isinf(value)) return "infinite";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(digits);
  out << value;
  return out.str();
}

std::string table(const Figures& f) {
  const auto count = [](auto whole) { return std::to_string(whole); };
  std::string text;
  const auto line = [&text](std::string name, const std::string& value) {
    name.resize(21, ' ');
    text += name + value + "\n";
  };
  line("size", count(f.width) + " x " + count(f.height) + " pixels, " + count(f.pixels_compared) + " compared");
  line("different", count(f.pixels_different) + " pixels (" + text_of(100 * f.share_different) + " %)");
  if (f.pixels_different > 0) {
    line("within", "columns " + count(f.box.left) + " to " + count(f.box.left + f.box.width - 1) + ", rows " +
                       count(f.box.top) + " to " + count(f.box.top + f.box.height - 1));
    line("largest difference", count(f.worst.levels) + " levels at column " + count(f.worst.column) + ", row " +
                                   count(f.worst.row) + ": " + text_of(f.worst.a) + " and " + text_of(f.worst.b));
  }
  line("mean absolute error", text_of(f.mean_absolute_error) + " levels");
  line("RMSE", text_of(f.root_mean_square_error) + " levels");
  line("PSNR", text_of(f.peak_signal_to_noise) + " dB");
  line("SSIM", text_of(f.structural_similarity, 10) + " (1: equal)");
  line("FLIP", text_of(f.flip) + " (0: equal, 1: most)");
  line("mean value", text_of(f.mean_a) + " and " + text_of(f.mean_b) + " levels");
  return text;
}

/// The last line: the rule, what it found, and the verdict.
std::string verdict(const Request& request, std::size_t off, bool same) {
  const std::string rule = "off by more than " + std::to_string(request.levels) + ": " + std::to_string(off) + " pixels, " +
                           request.at_most + " of all allowed: ";
  return rule + (same ? "the same\n" : "they differ\n");
}

/// Does all that was asked for. Returns whether the pictures are the same by the chosen rule.
bool compare(const Request& request) {
  const Share at_most = parse_share(request.at_most);
  if (!request.map.empty()) check_output(request.map);
  if (!request.json.empty()) check_json(request.json);

  const Image a = load(request.a);
  const Image b = load(request.b);
  const Image mask = request.mask.empty() ? Image() : load(request.mask);
  const Figures figures = measure(a, b, mask);
  const std::size_t off = pixels_off_by_more_than(figures, request.levels);
  const bool same = at_most.holds(off, figures.pixels_compared);

  if (!request.map.empty()) save_png(difference_map(a, b, mask), request.map);
  if (!request.json.empty()) save_json(figures_json(figures), request.json);
  if (!request.quiet) print(table(figures) + verdict(request, off, same));
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
