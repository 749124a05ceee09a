// Whether a student's picture is right, and if not, what is wrong with it in words.
#include "picture_verdict.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/compare/difference_map.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/blit.hpp"
#include "engine/picture/codecs/png_chunks.hpp"
#include "engine/picture/codecs/read_png.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/system/system.hpp"
#include "safe_text.hpp"

namespace texmap::grade {
namespace {

/// Pixels across a picture on a page.
constexpr int shown_width = 256;

/// Verdicts that are kept for each golden picture; one takes a megabyte.
constexpr std::size_t most_verdicts = 20;

template <class Whole>
std::string size_of(Whole width, Whole height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

void add_note(Row& row, const std::string& note) {
  if (!row.note.empty()) row.note += "; ";
  row.note += note;
}

/// Each pixel becomes what `merge` makes of a square of `step` pixels a side.
template <class Merge>
Image in_blocks(int width, int height, int step, const Merge& merge) {
  Image small((width + step - 1) / step, (height + step - 1) / step);
  for (int row = 0; row < small.height; ++row) {
    for (int column = 0; column < small.width; ++column) {
      small.at(column, row) = merge(column * step, row * step, std::min((column + 1) * step, width),
                                    std::min((row + 1) * step, height));
    }
  }
  return small;
}

Image smaller(const Image& image, int step) {
  return in_blocks(image.width, image.height, step, [&](int left, int top, int right, int bottom) {
    int r = 0, g = 0, b = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Rgb8 p = image.at(x, y);
        r += p.r;
        g += p.g;
        b += p.b;
      }
    }
    const int pixels = (right - left) * (bottom - top);
    const auto mean = [pixels](int sum) { return static_cast<std::uint8_t>(sum / pixels); };
    return Rgb8{mean(r), mean(g), mean(b)};
  });
}

/// The largest difference in each block, so that a single pixel stays visible.
Image small_map(const Image& a, const Image& b, int step) {
  return in_blocks(a.width, a.height, step, [&](int left, int top, int right, int bottom) {
    int levels = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x)
        levels = std::max(levels, channel_difference(a.at(x, y), b.at(x, y)));
    }
    return difference_color(levels);
  });
}

/// The part of a picture around a box, at least as large as a page shows it in full size.
Box around(const Box& box, const Image& image) {
  const int width = std::min(image.width, std::max(box.width, shown_width));
  const int height = std::min(image.height, std::max(box.height, shown_width * 3 / 4));
  const auto begin = [](int from, int size, int new_size, int all) {
    return std::clamp(from + (size - new_size) / 2, 0, all - new_size);
  };
  return {begin(box.left, box.width, width, image.width),
          begin(box.top, box.height, height, image.height), width, height};
}

Image part_of(const Image& image, const Box& part) {
  Image result(part.width, part.height);
  blit(result, image, -part.left, -part.top);
  return result;
}

std::string percent(double share) {
  const double p = 100 * share;
  return text(p >= 10 ? "%.0f %%" : p >= 1 ? "%.1f %%" : "%.2g %%", p);
}

bool has_alpha(const PngHeader& header) { return header.color_type == 4 || header.color_type == 6; }

void compare(const std::vector<std::uint8_t>& file, const Golden& golden, Row& row,
             const NameMistake& name) {
  const Image& should = golden.picture;
  const auto has_wrong_size = [&](auto width, auto height) {
    if (std::cmp_equal(width, should.width) && std::cmp_equal(height, should.height)) return false;
    row.word = "wrong size";
    add_note(row, "the picture has " + size_of(width, height) + " pixels and should have " +
                      size_of(should.width, should.height));
    return true;
  };
  if (looks_like_png(file)) {  // a small file can unpack to a gigabyte
    const PngHeader header = read_png_chunks(file).header;
    if (has_wrong_size(header.size.width, header.size.height)) return;
    if (has_alpha(header)) add_note(row, "the file has an alpha channel, which is not looked at");
  }
  const Image is = decode_image(file);
  if (has_wrong_size(is.width, is.height)) return;
  const Figures figures = measure(should, is, {}, Detail::similarity);
  const std::size_t off = pixels_off_by_more_than(figures, 1);
  row.figures = {off, static_cast<double>(off) / static_cast<double>(figures.pixels_compared),
                 figures.root_mean_square_error, figures.structural_similarity};
  row.picture_ok = is_right(figures);
  const std::string off_words =
      counted(off, "pixel") + (off == 1 ? " is" : " are") + " off by more than one level";
  if (row.picture_ok) {
    if (off > 0) add_note(row, "as few as the rule allows: " + off_words);
    return;
  }
  row.word = "differs " + percent(row.figures->share_off);
  const std::string mistake = name ? name(is) : "";
  if (!mistake.empty()) {
    row.word = first_word(mistake);
    add_note(row, mistake);
  }
  add_note(row, off_words);
  const Box part = around(figures.box, is);
  const Image is_there = part_of(is, part);
  const Image should_there = part_of(should, part);
  const int step = (part.width + shown_width - 1) / shown_width;
  row.shown = {smaller(is_there, step), smaller(should_there, step),
               small_map(should_there, is_there, step),
               text("columns %d to %d, rows %d to %d", part.left, part.left + part.width - 1,
                    part.top, part.top + part.height - 1)};
}

}  // namespace

Golden read_golden(const std::filesystem::path& path) {
  return with_name("cannot load the golden picture", path, [&] {
    Golden golden{read_file(path, max_file_bytes), {}, {}};
    golden.picture = decode_image(golden.file);
    return golden;
  });
}

bool is_right(const Figures& figures) {
  // 0.02 % without a rounded quotient.
  return 5000 * pixels_off_by_more_than(figures, 1) <= figures.pixels_compared;
}

void compare_with_golden(const std::filesystem::path& path, Golden& golden, Row& row,
                         const NameMistake& name) {
  try {
    const std::vector<std::uint8_t> file = read_file(path, max_file_bytes);
    if (file == golden.file) {
      row.figures = PictureFigures{};
      row.picture_ok = true;
      return;
    }
    std::vector<Golden::Verdict>& all = golden.verdicts;
    auto known = std::find_if(all.begin(), all.end(),
                              [&](const Golden::Verdict& one) { return one.file == file; });
    if (known == all.end()) {
      Row verdict;
      compare(file, golden, verdict, name);
      if (all.size() == most_verdicts) all.clear();
      known = all.insert(all.end(), {file, std::move(verdict)});
    }
    const Row& verdict = known->row;
    row.word = verdict.word;
    row.figures = verdict.figures;
    row.picture_ok = verdict.picture_ok;
    row.shown = verdict.shown;
    if (!verdict.note.empty()) add_note(row, verdict.note);
  } catch (const std::exception& error) {
    row.word = "unreadable";
    add_note(row, std::string("the picture cannot be read: ") + error.what());
  }
}

void compare_hidden(const std::filesystem::path& path, const std::filesystem::path& expected,
                    Row& row) {
  Row second;
  Golden golden = read_golden(expected);
  compare_with_golden(path, golden, second);
  row.hidden = second.picture_ok ? "yes" : "no";
  if (second.picture_ok || !row.picture_ok) return;
  row.word = "second picture";
  add_note(row, "the picture is right, but a second one, drawn with other settings, is not");
  row.shown = second.shown;
}

}  // namespace texmap::grade
