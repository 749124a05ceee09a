// Names the mistake in a picture of the reader's own: ./course diagnose FILE. It tries the chapters
// whose pictures have this size, the most similar first, so the reader need not name the chapter.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/compare/known_mistakes.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/read_jpeg.hpp"
#include "engine/files/read_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"

namespace {

using namespace texmap;
namespace fs = std::filesystem;

struct Choices {
  std::string file, undrawn;
  std::string chapter;  ///< two digits, or empty: any
  std::string source = TEXMAP_CHAPTERS_DIR;

  [[nodiscard]] fs::path root() const { return fs::absolute(path_of(source)).parent_path(); }
};

/// What a mistake's words hold, and its card: the name of the card's picture in docs/symptoms.md.
constexpr struct {
  const char *words, *card;
} cards[] = {
    {"mirrored: u runs", "mirrored"},
    {"upside down: v runs", "upside_down"},
    {"turned by half: u and v", "half_turn"},
    {"a quarter turn off", "quarter_turn"},
    {"striped", "stripes"},
    {"half a texel", "half_a_texel"},
    {"squeezed at the poles", "squeezed_pole"},
    {"black texture", "black"},
    {"too dark: light was", "too_dark"},
    {"the texture is too dark", "too_dark"},
    {"too pale", "too_pale"},
    {"dark at the outline", "dark_rim"},
    {"shining on its night side", "night_highlight"},
    {"dents and not bumps", "dents"},
};

/// A page, in the book where that is made, and as Markdown.
std::string place_of(const fs::path& root, const std::string& html, const std::string& anchor,
                     const std::string& markdown) {
  const fs::path file = root / "out" / html;
  return "out/" + html + anchor + "\n              " +
         (exists(file) ? "file://" + file.generic_string() + anchor
                       : markdown + " (./course book makes the book)") +
         "\n";
}

/// What a card says to change, where it is, and the page that explains it.
std::string card_in(const fs::path& root, const std::string& card, std::string& chapter) {
  const std::vector<std::uint8_t> page = read_file(root / "docs/symptoms.md", max_file_bytes);
  std::istringstream lines(std::string(page.begin(), page.end()));
  for (std::string line; std::getline(lines, line);) {
    static const std::regex row(
        R"(\| !\[[^\]]*\]\([^)]*?(\w+)\.png\)(?: !\[[^\]]*\]\([^)]*\))* (.*) \|)"
        R"( .* \| (.*) \| .*chapter (\d\d).*)");
    std::smatch cells;
    if (!std::regex_match(line, cells, row) || cells[1] != card) continue;
    chapter = cells[4];
    return "  change      " + cells[3].str() + "\n  the card    My Earth is … " + cells[2].str() +
           "\n              " + place_of(root, "symptoms.html", "#" + card, "docs/symptoms.md");
  }
  return "";
}

std::string page_of(const Choices& choices, const std::string& chapter) {
  for (const auto& entry : fs::directory_iterator(path_of(choices.source))) {
    const std::string name = name_of(entry.path().filename());
    if (!name.starts_with(chapter + "_")) continue;
    return "  the page    chapter " + chapter + ": " +
           place_of(choices.root(), name + ".html", "", "chapters/" + name + "/README.md");
  }
  return "";
}

/// The words of a mistake, and where it is explained.
std::string explained(const Choices& choices, const WrongPicture& right, const std::string& words) {
  std::string said =
      choices.file + ": wrong. Chapter " + right.name.substr(0, 2) + "'s picture, " + words + "\n";
  std::string chapter = right.name.substr(0, 2);
  for (const auto& row : cards) {
    if (words.find(row.words) != std::string::npos)
      said += card_in(choices.root(), row.card, chapter);
  }
  const std::string page = page_of(choices, chapter);  // its chapter may not be in a students' copy
  return said + (page.empty() ? page_of(choices, right.name.substr(0, 2)) : page);
}

/// Errors: FileError, with the remedy.
Image picture_in(const std::string& typed) {
  const fs::path path = path_of(typed);
  return with_name("cannot diagnose", path, [&] {
    const std::vector<std::uint8_t> file = read_file(path, max_file_bytes);
    if (looks_like_jpeg(file))
      throw FileError("it is a JPEG, which has other colors: name the PNG file that you drew");
    if (!looks_like_png(file)) throw FileError("it is no PNG: name the file that you drew");
    return decode_image(file);
  });
}

/// How far a picture is from a right one, in few pixels: from itself, or from what goes wrong with
/// a whole picture. What is painted over a part of a picture counts by its area, not by its color.
double distance(const Image& mine, const Image& right) {
  const auto small = [](const Image& image) {
    return shrunk(image, (image.width + 7) / 8, (image.height + 7) / 8);
  };
  const Image seen = small(mine), itself = small(right);
  std::vector<WrongPicture> ways = mistakes_of_the_whole(itself);
  ways.push_back({"", "", itself});
  constexpr int plainly_wrong = 8;  // levels: a pixel that is farther off is no farther off
  double least = std::numeric_limits<double>::infinity();
  for (const WrongPicture& way : ways) {
    double sum = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i)
      sum += std::min(channel_difference(seen.pixels[i], way.picture.pixels[i]), plainly_wrong);
    least = std::min(least, sum);
  }
  return least;
}

/// The chapters' own pictures that may be meant, the nearest first.
/// Errors: UsageError; FileError with the sizes that there are.
std::vector<WrongPicture> meant(const Choices& choices, const Image& mine,
                                const std::vector<WrongPicture>& right) {
  std::multimap<double, WrongPicture> nearest;
  std::string sizes;
  for (const WrongPicture& one : right) {
    if (!one.name.starts_with(choices.chapter) || !exists(path_of(choices.source) / one.name))
      continue;
    const Image& picture = one.picture;
    if (picture.width == mine.width && picture.height == mine.height)
      nearest.emplace(distance(mine, picture), one);
    sizes += text(" %s: %d x %d,", one.name.substr(0, 2).c_str(), picture.width, picture.height);
  }
  if (sizes.empty()) throw UsageError("there is no picture of a chapter '" + choices.chapter + "'");
  sizes.back() = '.';
  if (nearest.empty()) {
    throw FileError(text("'%s' has %d x %d pixels: draw it as large as its chapter does, without "
                         "--width and --height.",
                         choices.file.c_str(), mine.width, mine.height) +
                    sizes);
  }
  std::vector<WrongPicture> fitting;
  for (auto& [error, one] : nearest) fitting.push_back(std::move(one));
  return fitting;
}

/// Says what a picture is; true if it is right.
bool diagnose(const Choices& choices) {
  const Image mine = picture_in(choices.file);
  const std::vector<WrongPicture> right = right_pictures(choices.root() / "tests/golden");
  std::string found;
  bool is_it = false;
  for (const WrongPicture& one : right) {
    if (!is_same_picture(mine, one.picture)) continue;
    is_it = one.name.starts_with(choices.chapter);
    found = choices.file + (is_it ? ": right, " : ": not chapter " + choices.chapter + "'s, but ") +
            one.words + (one.name.starts_with("02") ? ", which 00 draws, too\n" : "\n");
    if (is_it) break;
  }
  if (!found.empty()) {
    print(found);
    return is_it;
  }
  const std::vector<WrongPicture> candidates = meant(choices, mine, right);
  for (const WrongPicture& one : candidates) {
    const fs::path drawn = choices.root() / "build/learn/mistakes" / one.name;
    if (!choices.undrawn.empty() && one.name < "13" && !has_drawn_mistakes(drawn, one.picture)) {
      write_text_atomically(path_of(choices.undrawn), one.name);
      return false;
    }
    const std::string words = name_mistake(mine, one.picture, known_mistakes(drawn, one.picture));
    const bool is_vague = words.starts_with("softer") || words.starts_with("rougher");
    if (!words.empty() && (found.empty() || !is_vague)) found = explained(choices, one, words);
    if (!words.empty() && !is_vague) break;
  }
  if (found.empty()) {
    const std::string& nearest = candidates.front().name;
    found = choices.file + ": wrong, by a mistake that is not known. The nearest picture is " +
            nearest.substr(0, 2) + "'s:\n  where       ./course diff " + choices.file +
            " tests/golden/" + nearest + ".png\n  more        " +
            place_of(choices.root(), "symptoms.html", "", "docs/symptoms.md");
  }
  print(found +
        (candidates.size() > 1 ? "If it is another chapter's, name it: --chapter NN\n" : ""));
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  CommandLine line("diagnose", "names the mistake in a picture, and the page that explains it");
  line.positional("FILE", choices.file, "the picture, a PNG in the size that a chapter draws");
  line.text("--chapter", "NN", choices.chapter,
            "the chapter that should have drawn it; the default is the nearest");
  line.text("--source", "FOLDER", choices.source, "the folder of the chapters");
  line.text("--undrawn", "FILE", choices.undrawn,
            "where a chapter's known mistakes are not drawn yet, write its name into this file");
  line.statuses("0 the picture is right; 1 it is wrong; 2 an error, no diagnosis");
  bool is_right = true;
  const int status = run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (choices.chapter.size() == 1) choices.chapter.insert(0, "0");
    if (choices.chapter == "00") choices.chapter = "02";  // whose picture 00 draws
    is_right = diagnose(choices);
  });
  return status != 0 ? 2 : is_right ? 0 : 1;
}
