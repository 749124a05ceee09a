// Whether pictures are right, and if not, what is wrong with them in words: grade.py asks.
//
// A question is two texts, each with a zero byte at its end: a picture and the golden picture. The
// answer is a line of JSON. Before the first question comes a line with the page that shows
// answers.
#include <algorithm>
#include <iostream>
#include <map>

#include "diagnose/slips.hpp"
#include "engine/compare/difference.hpp"
#include "engine/compare/known_mistakes.hpp"
#include "engine/files/blit.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/json.hpp"
#include "engine/files/png_chunks.hpp"
#include "engine/files/read_jpeg.hpp"
#include "engine/files/read_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"
#include "tools/page/page.hpp"

namespace {

using namespace texmap;

/// Pixels across a picture on a page.
constexpr int shown_width = 256;
/// Answers that are kept for each golden picture: many students hand in the same bytes.
constexpr std::size_t most_answers = 20;

struct Answer {
  std::string word;  ///< empty if the picture is right
  std::string note;
  bool right = false;
  bool measured = false;
  std::size_t pixels_off = 0;  ///< by more than one level
  double share_off = 0;        ///< of all pixels, 0 to 1
  double rmse = 0;             ///< levels, 0 to 255
  double ssim = 1;
  std::string shown_html;  ///< the part that is wrong: what is there, and what should be

  void add_note(const std::string& words) {
    note += (note.empty() || words.empty() ? "" : "; ") + words;
  }

  [[nodiscard]] std::string json() const {
    return Json::object({{"word", word},
                         {"note", note},
                         {"right", right},
                         {"measured", measured},
                         {"pixels_off", pixels_off},
                         {"share_off", share_off},
                         {"rmse", rmse},
                         {"ssim", ssim},
                         {"shown", shown_html}})
        .text;
  }
};

/// The picture with a pixel for each block of `step` pixels a side.
Image in_steps(const Image& image, int step) {
  return shrunk(image, (image.width + step - 1) / step, (image.height + step - 1) / step);
}

/// The largest difference in each block of `step` pixels a side, so that a single pixel stays
/// visible.
Image small_map(const Image& a, const Image& b, int step) {
  Image map((a.width + step - 1) / step, (a.height + step - 1) / step);
  std::vector<int> levels(map.pixels.size());
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      int& most = levels[static_cast<std::size_t>(y / step * map.width + x / step)];
      most = std::max(most, channel_difference(a.at(x, y), b.at(x, y)));
    }
  }
  std::transform(levels.begin(), levels.end(), map.pixels.begin(), difference_color);
  return map;
}

/// The part of a picture around a box, at least as large as a page shows it in full size.
PixelBox around(const PixelBox& box, const Image& image) {
  const int width = std::min(image.width, std::max(box.width, shown_width));
  const int height = std::min(image.height, std::max(box.height, shown_width * 3 / 4));
  const auto begin = [](int from, int size, int new_size, int all) {
    return std::clamp(from + (size - new_size) / 2, 0, all - new_size);
  };
  return {begin(box.left, box.width, width, image.width),
          begin(box.top, box.height, height, image.height), width, height};
}

std::string shown(const Image& is, const Image& should, const PixelBox& box) {
  const PixelBox part = around(box, is);
  const auto cut = [&part](const Image& image) {
    Image result(part.width, part.height);
    blit(result, image, -part.left, -part.top);
    return result;
  };
  const Image is_there = cut(is), should_there = cut(should);
  const int step = (part.width + shown_width - 1) / shown_width;
  const std::string where = text("columns %d to %d, rows %d to %d", part.left,
                                 part.left + part.width - 1, part.top, part.top + part.height - 1);
  return page::side_by_side(
      {page::figure(page::inside(in_steps(is_there, step)), "is: " + where),
       page::figure(page::inside(in_steps(should_there, step)), "should be"),
       page::figure(page::inside(small_map(should_there, is_there, step)),
                    "where they differ: black nowhere, yellow most", "the map of differences")});
}

std::string percent(double share) {
  const double p = 100 * share;
  return text(p >= 10 ? "%.0f %%" : p >= 1 ? "%.1f %%" : "%.2g %%", p);
}

/// Names wrong pictures.
class KnownWords {
 public:
  /// Such as "mirrored: u runs the other way"; empty if nothing is sure.
  ///
  /// @param golden  the file of the right picture
  [[nodiscard]] std::string words_for(const Image& is, const Image& should,
                                      const std::filesystem::path& golden) {
    std::string words = by_slips_.of(is, {name_of(golden.stem()), "", should});
    for (const WrongPicture& other : beside(golden)) {
      if (is_of_another_chapter(other, golden) && is_same_picture(is, other.picture))
        words += (words.empty() ? "" : "; or ") + other.words;
    }
    return words;
  }

  /// The pictures in the folder of a golden one, with words such as "a picture of chapter 02".
  [[nodiscard]] const std::vector<WrongPicture>& beside(const std::filesystem::path& golden) {
    const auto [place, is_new] = beside_.try_emplace(golden.parent_path());
    if (is_new) place->second = right_pictures(golden.parent_path());
    return place->second;
  }
  [[nodiscard]] static bool is_of_another_chapter(const WrongPicture& other,
                                                  const std::filesystem::path& golden) {
    return other.name.substr(0, 2) != name_of(golden.filename()).substr(0, 2);
  }

 private:
  slips::Words by_slips_;
  std::map<std::filesystem::path, std::vector<WrongPicture>> beside_;
};

/// A golden picture, and the answers on the files that were compared with it. It is read once: what
/// a student's program makes of the file later does not count.
struct Golden {
  std::filesystem::path path;
  std::vector<std::uint8_t> file;
  Image picture;
  std::map<std::string, std::string> answers = {};  // by the file's bytes
};

Answer compare(const std::vector<std::uint8_t>& file, const Golden& golden, KnownWords& known) {
  Answer answer;
  const Image& should = golden.picture;
  const auto has_wrong_size = [&](auto width, auto height) {
    if (std::cmp_equal(width, should.width) && std::cmp_equal(height, should.height)) return false;
    answer.word = "wrong size";
    answer.add_note("the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels and should have " + text("%d x %d", should.width, should.height));
    // Only what is no larger than a picture of the course is unpacked.
    const auto is_like = [&](const Image& other) {
      return std::cmp_equal(width, other.width) && std::cmp_equal(height, other.height) &&
             apart_when_soft(decode_image(file), other) < nearly_the_same;
    };
    for (const int step : {2, 3, 4}) {
      if (is_like(in_steps(should, step)))
        answer.add_note(text("it is the right picture, drawn or scaled to 1/%d", step));
    }
    for (const WrongPicture& other : known.beside(golden.path)) {
      if (!known.is_of_another_chapter(other, golden.path) || !is_like(other.picture)) continue;
      answer.word = other.words;
      answer.add_note("it is " + other.words);
      break;
    }
    return true;
  };
  if (looks_like_png(file)) {  // a small file can unpack to a gigabyte
    const PngHeader header = read_png_chunks(file).header;
    if (has_wrong_size(header.size.width, header.size.height)) return answer;
    if (header.color_type == 4 || header.color_type == 6)
      answer.add_note("the file has an alpha channel, which is not looked at");
  }
  const Image is = decode_image(file);
  if (has_wrong_size(is.width, is.height)) return answer;
  const bool is_jpeg = !looks_like_png(file);
  if (is_jpeg)
    answer.add_note("the file is a JPEG, which has other colors than the picture: hand in a PNG");
  const Figures figures = measure(should, is, {}, Detail::similarity);
  const std::size_t off = pixels_off_by_more_than(figures, 1);
  answer.measured = true;
  answer.pixels_off = off;
  answer.share_off = static_cast<double>(off) / static_cast<double>(figures.pixels_compared);
  answer.rmse = figures.root_mean_square_error;
  answer.ssim = figures.structural_similarity;
  answer.right = 5000 * off <= figures.pixels_compared;  // 0.02 % without a rounded quotient
  const std::string off_words =
      text("%zu pixel%s off by more than one level", off, off == 1 ? " is" : "s are");
  if (answer.right) {
    if (off > 0) answer.add_note("as few as the rule allows: " + off_words);
    return answer;
  }
  answer.word = "differs " + percent(answer.share_off);
  std::string mistake = known.words_for(is, should, golden.path);
  const bool has_cause =
      !mistake.empty() && !mistake.starts_with("softer") && !mistake.starts_with("rougher");
  if (looks_like_jpeg(file) && !has_cause && apart_when_soft(is, should) < nearly_the_same)
    mistake = "a JPEG: its losses change colors; hand in the file that the program writes";
  if (!mistake.empty()) {
    answer.word = short_words(mistake);
    answer.add_note(mistake);
  } else if (is_jpeg) {
    answer.word = "a JPEG";
  }
  answer.add_note(off_words);
  answer.shown_html = shown(is, should, figures.box);
  return answer;
}

class Judge {
 public:
  /// Errors: FileError if the golden picture cannot be read.
  std::string answer(const std::string& picture, const std::string& golden_picture) {
    Golden& golden = golden_of(golden_picture);
    Answer answer;
    try {
      const std::vector<std::uint8_t> file = read_file(path_of(picture), max_file_bytes);
      if (file == golden.file) {
        answer.right = answer.measured = true;
        return answer.json();
      }
      const std::string key(file.begin(), file.end());
      if (golden.answers.size() == most_answers && !golden.answers.contains(key))
        golden.answers.clear();
      std::string& known = golden.answers[key];
      if (known.empty()) known = compare(file, golden, words_).json();
      return known;
    } catch (const std::exception& error) {
      answer.word = "unreadable";
      answer.note = std::string("the picture cannot be read: ") + error.what();
      return answer.json();
    }
  }

 private:
  Golden& golden_of(const std::string& path) {
    const auto known = goldens_.find(path);
    if (known != goldens_.end()) return known->second;
    Golden golden = with_name("cannot load the golden picture", path_of(path), [&] {
      std::vector<std::uint8_t> file = read_file(path_of(path), max_file_bytes);
      Image picture = decode_image(file);
      return Golden{path_of(path), std::move(file), std::move(picture)};
    });
    return goldens_.emplace(path, std::move(golden)).first->second;
  }

  std::map<std::string, Golden> goldens_;
  KnownWords words_;
};

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("judge_pictures", "pictures against golden ones; ./course grade asks");
  return run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    const auto page = [](const char* script) {
      return Json(page::framed({"@TITLE@", "@STYLE@", script}, "@BODY@"));
    };
    print(Json::object({{"page", page("")}, {"page_with_script", page("@SCRIPT@")}}).text + "\n");
    Judge judge;
    std::string picture, golden;
    while (std::getline(std::cin, picture, '\0') && std::getline(std::cin, golden, '\0'))
      print(judge.answer(picture, golden) + "\n");
  });
}
