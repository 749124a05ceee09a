// The program compare: how two pictures differ, in figures, as a picture, and as an exit status.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/app/run_guarded.hpp"
#include "engine/compare/difference.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/compare/figures_json.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/render/threads.hpp"
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

Image load(const std::string& typed) {
  const std::filesystem::path path = path_of(typed);
  return with_name("cannot load", path,
                   [&] { return decode_image(read_file(path, max_file_bytes)); });
}

/// The pictures, decoded at the same time; an empty one where there is no name.
/// Errors: those of the first that cannot be loaded.
std::array<Image, 3> load_all(const std::array<std::string, 3>& typed) {
  std::array<Image, 3> images;
  std::array<std::exception_ptr, 3> failures;
  for_each_row(3, 3, {}, [&](int row) {
    const auto i = static_cast<std::size_t>(row);
    try {
      if (!typed[i].empty()) images[i] = load(typed[i]);
    } catch (...) {
      failures[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return images;
}

void save_json(const std::string& json, const std::string& typed) {
  const std::filesystem::path path = path_of(typed);
  with_name("cannot write", path, [&] { write_text_atomically(path, json); });
}

std::string text_of(Rgb8 color) { return text("(%d, %d, %d)", color.r, color.g, color.b); }

std::string table(const Figures& f) {
  std::string lines;
  const auto line = [&lines](const char* name, const std::string& value) {
    lines += text("%-21s%s\n", name, value.c_str());
  };
  line("size", text("%d x %d pixels, %zu compared", f.width, f.height, f.pixels_compared));
  line("different", text("%zu pixels (%g %%)", f.pixels_different, 100 * f.share_different));
  if (f.pixels_different > 0) {
    line("within", text("columns %d to %d, rows %d to %d", f.box.left, f.box.left + f.box.width - 1,
                        f.box.top, f.box.top + f.box.height - 1));
    line("largest difference",
         text("%d levels at column %d, row %d: %s and %s", f.worst.levels, f.worst.column,
              f.worst.row, text_of(f.worst.a).c_str(), text_of(f.worst.b).c_str()));
  }
  line("mean absolute error", text("%g levels", f.mean_absolute_error));
  line("RMSE", text("%g levels", f.root_mean_square_error));
  const double psnr = f.peak_signal_to_noise;
  line("PSNR", std::isinf(psnr) ? "infinite dB" : text("%g dB", psnr));
  if (!std::isnan(f.structural_similarity))
    line("SSIM", text("%.10g (1: equal)", f.structural_similarity));
  line("mean value", text("%g and %g levels", f.mean_a, f.mean_b));
  return lines;
}

/// The last line: the rule, what it found, and the verdict.
std::string verdict(const Request& request, std::size_t off, bool same) {
  return text("off by more than %d: %zu pixels, %s of all allowed: %s\n", request.levels, off,
              request.at_most.c_str(), same ? "the same" : "they differ");
}

/// Does all that was asked for. Returns whether the pictures are the same by the chosen rule.
bool compare(const Request& request) {
  const Share at_most = parse_share(request.at_most);
  if (!request.map.empty()) check_output(path_of(request.map));
  if (!request.json.empty()) check_output(path_of(request.json));

  const auto [a, b, mask] = load_all({request.a, request.b, request.mask});
  const Detail detail = request.all || !request.json.empty() ? Detail::similarity : Detail::pixels;
  const Figures figures = measure(a, b, mask, detail);
  const std::size_t off = pixels_off_by_more_than(figures, request.levels);
  const bool same = at_most.holds(off, figures.pixels_compared);

  if (!request.map.empty()) save_png(difference_map(a, b, mask), path_of(request.map));
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
