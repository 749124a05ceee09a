// Names the mistake in a picture of the reader's own: ./course diagnose FILE. It tries the chapters
// whose pictures have this size, the most similar first, so the reader need not name the chapter.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "cards.hpp"
#include "engine/compare/difference.hpp"
#include "engine/compare/known_mistakes.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/read_jpeg.hpp"
#include "engine/files/read_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"
#include "slips.hpp"

namespace {

using namespace texmap;
namespace fs = std::filesystem;

struct Choices {
  std::string file, beside;
  std::string texture;  ///< in place of the chapter's; empty: its own
  std::string chapter;  ///< two digits, or empty: any
  std::string source = TEXMAP_CHAPTERS_DIR;
  bool first = false;  ///< another program, with more chapters, can be asked

  [[nodiscard]] fs::path root() const { return fs::absolute(path_of(source)).parent_path(); }
};

constexpr const char* if_another = "If it is another chapter's, name it: --chapter NN\n";

/// A page, in the book where that is made, and as Markdown.
std::string place_of(const fs::path& root, const std::string& html, const std::string& anchor,
                     const std::string& markdown) {
  const fs::path file = root / "out" / html;
  return "out/" + html + anchor + "\n              " +
         (exists(file) ? "file://" + file.generic_string() + anchor
                       : markdown + " (./course book makes the book)") +
         "\n";
}

/// What a card says to change, where it is, and the page that explains it. A card is a row of a
/// table: its picture with others and words, the cause, the change, and a link to a chapter.
///
/// @param change  what to write, where it is known better than the card says
std::string card_in(const fs::path& root, const std::string& card, const std::string& change,
                    std::string& chapter) {
  const std::vector<std::uint8_t> page = read_file(root / "docs/symptoms.md", max_file_bytes);
  std::istringstream lines(std::string(page.begin(), page.end()));
  const std::string image = "/" + card + ".png)", ends = ".png) ", link = "[chapter ";
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(image);
    if (!line.starts_with("| ![") || first == std::string::npos || first > line.find(ends))
      continue;
    std::vector<std::string> cells;
    for (std::size_t begin = 2, end = 0; begin < line.size(); begin = end + 3) {
      end = std::min(line.find(" | ", begin), line.size());
      cells.push_back(line.substr(begin, end - begin));
    }
    if (cells.size() < 4 || cells[3].find(link) == std::string::npos) continue;
    chapter = cells[3].substr(cells[3].find(link) + link.size(), 2);
    return "  change      " + (change.empty() ? cells[2] : change) +
           "\n  the card    My Earth is \u2026 " +
           cells[0].substr(cells[0].rfind(ends) + ends.size()) + "\n              " +
           place_of(root, "symptoms.html", "#" + card, "docs/symptoms.md");
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
std::string explained(const Choices& choices, const std::string& right,
                      const std::vector<slips::Slip>& slips, const std::string& evidence = "") {
  std::string said = choices.file + ": wrong. Chapter " + right.substr(0, 2) + "'s picture, " +
                     slips::all_of(slips) + evidence + "\n";
  std::string chapter = right.substr(0, 2);
  for (const slips::Slip& slip : slips) {
    std::string found;
    for (const slips::Card& row : slips::cards) {
      if (slip.words.find(row.words) != std::string::npos)
        found += card_in(choices.root(), row.name, slip.change, chapter);
    }
    if (found.empty() && !slip.change.empty()) found = "  change      " + slip.change + "\n";
    said += found;
  }
  const std::string page = page_of(choices, chapter);  // its chapter may not be in a students' copy
  return said + (page.empty() ? page_of(choices, right.substr(0, 2)) : page);
}

/// The stages of chapters that draw them, in the picture's size; with the reader's texture those
/// that have one. A chapter's lesson may be the reader's own.
std::vector<slips::StageView> stages_of(const Choices& choices, const Image& mine,
                                        const std::vector<WrongPicture>& candidates) {
  std::vector<slips::StageView> stages;
  for (const WrongPicture& one : candidates) {
    const slips::OnStage* chapter = slips::find_chapter(one.name);
    if (chapter == nullptr) continue;
    slips::StageView stage = chapter->view(chapter->name, choices.texture);
    if (stage.pixels.empty() || stage.width != mine.width || stage.height != mine.height) continue;
    if (choices.texture.empty() ? slips::draws(stage, one.picture) : !stage.picture.pixels.empty())
      stages.push_back(std::move(stage));
  }
  return stages;
}

/// The explanations by the fewest slips; else nothing.
/// A turned globe of chapter 03 may be chapter 05's: then the earlier is explained, both are said.
std::string by_slips(const Choices& choices, const Image& mine,
                     const std::vector<slips::StageView>& stages) {
  const auto whys = explain_by_any(mine, stages);
  if (whys.empty()) return "";
  const auto& [first, why] = whys.front();
  std::string evidence =
      text(" (this explains %.1f %% of what is wrong)",
           100.0 * static_cast<double>(why.explained) / static_cast<double>(why.different));
  for (const std::string& other : why.instead) evidence += "\n  or          " + other;
  for (const auto& [stage, other] : whys) {
    if (stage != first && other.slips.size() <= why.slips.size()) {
      evidence += "\n  or          chapter " + stage->chapter.substr(0, 2) + "'s picture, " +
                  slips::all_of(other.slips);
    }
  }
  return explained(choices, first->chapter, why.slips, evidence) +
         (whys.size() > 1 ? if_another : "");
}

/// Pixels that no rounding made: none of the right picture's around has their color.
struct Stray {
  std::size_t count = 0, black = 0, white = 0;
  int column = -1, row = -1;                                   ///< of the first
  int right = -1, bottom = -1, left = 1 << 20, top = 1 << 20;  ///< what they lie in
};
Stray stray_pixels(const Image& mine, const Image& right) {
  Stray stray;
  for (int y = 0; y < mine.height; ++y) {
    for (int x = 0; x < mine.width; ++x) {
      const Rgb8 is = mine.at(x, y);
      bool is_near = channel_difference(is, right.at(x, y)) <= 1;
      for (int i = 0; i < 9 && !is_near; ++i) {
        const int column = std::clamp(x + i % 3 - 1, 0, mine.width - 1);
        const int row = std::clamp(y + i / 3 - 1, 0, mine.height - 1);
        is_near = channel_difference(is, right.at(column, row)) <= 3;
      }
      if (is_near) continue;
      if (stray.count++ == 0) stray.column = x, stray.row = y;
      stray.black += is == Rgb8{} ? 1U : 0U;
      stray.white += is == Rgb8{255, 255, 255} ? 1U : 0U;
      stray.left = std::min(stray.left, x), stray.right = std::max(stray.right, x);
      stray.top = std::min(stray.top, y), stray.bottom = std::max(stray.bottom, y);
    }
  }
  return stray;
}

/// Words for a picture that is right but for a few pixels.
///
/// @param stage  of the chapter; null if it is not known
std::string but_for(const Choices& choices, const Image& mine, const WrongPicture& right,
                    const Stray& stray, const slips::StageView* stage) {
  const double box = (stray.right - stray.left + 1.0) * (stray.bottom - stray.top + 1);
  const std::string pixels = text("%zu %s: ", stray.count, stray.count == 1 ? "pixel" : "pixels");
  std::string what = "pixels of other colors";
  if (stray.count > 1 &&
      box * 100 < right.picture.width * static_cast<double>(right.picture.height)) {
    what = text("something is painted over columns %d to %d, rows %d to %d", stray.left,
                stray.right, stray.top, stray.bottom);
  }
  if (stray.white * 10 >= stray.count * 9) what = "white dots: most likely a division by 0";
  if (stray.black * 10 >= stray.count * 9) {
    what =
        "black dots: most likely a number that is none (NaN), or, on objects, shadow rays that "
        "meet their own surface";
  }
  if (stage != nullptr && slips::is_in_highlight(mine, *stage)) {
    what = "the highlight is wrong, by a mistake that is not known";
  }
  return choices.file + ": chapter " + right.name.substr(0, 2) + "'s picture, right but for " +
         pixels + what + text("\n  the first   column %d, row %d\n", stray.column, stray.row);
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

/// The chapter that a file's name says: 03 in 03.png, my_03_globe.png and ch03.png, none in
/// 3_amb05.png.
std::string number_in(const std::string& name) {
  const auto digit = [&](std::size_t i) {
    return i < name.size() && name[i] >= '0' && name[i] <= '9';
  };
  for (std::size_t i = 0; i + 2 < name.size(); ++i) {
    std::string number = name.substr(i, 2);
    const std::string before = name.substr(0, i);
    const bool is_alone = i == 0 || std::isalnum(static_cast<unsigned char>(name[i - 1])) == 0 ||
                          before.ends_with("ch") || before.ends_with("chapter");
    if (is_alone && digit(i) && digit(i + 1) && !digit(i + 2) && number > "00" && number < "15")
      return number;
  }
  return "";
}

/// The chapters' own pictures that may be meant, the nearest first.
///
/// @param by_name  set if the file's name left others out
/// Errors: UsageError; FileError with the sizes that there are.
std::vector<WrongPicture> meant(const Choices& choices, const Image& mine,
                                const std::vector<WrongPicture>& right, bool& by_name) {
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
  const std::string number = number_in(name_of(path_of(choices.file).filename()));
  const auto is_another = [&](const auto& one) { return !one.name.starts_with(number); };
  by_name = !std::ranges::all_of(fitting, is_another) && std::erase_if(fitting, is_another) > 0;
  return fitting;
}

/// True if only a program with more chapters can tell what is wrong with a picture of this one.
bool is_for_another(const Choices& choices, const WrongPicture& one) {
  return choices.first && one.name < "13" && slips::find_chapter(one.name) == nullptr;
}

/// What is wrong with a picture that no chapter draws; empty if another program is to be asked.
std::string wrong(const Choices& choices, const Image& mine, std::vector<WrongPicture> candidates) {
  // A picture that is right but for a few pixels is that chapter's, and no other's.
  const auto few = mine.pixels.size() / 1000;
  std::size_t least = few + 1;
  for (const WrongPicture& one : candidates)
    least = std::min(least, stray_pixels(mine, one.picture).count);
  if (least <= few) {
    std::erase_if(candidates, [&](const WrongPicture& one) {
      return stray_pixels(mine, one.picture).count > least;
    });
  }
  const std::vector<slips::StageView> stages = stages_of(choices, mine, candidates);
  std::string found = by_slips(choices, mine, stages);
  if (!found.empty()) return found;
  for (const slips::StageView& stage : stages) {
    const slips::Slip slip = slips::wrong_shadows(mine, stage);
    if (!slip.words.empty()) return explained(choices, stage.chapter, {slip});
  }
  bool is_sure = false;
  for (const WrongPicture& one : candidates) {
    const std::string words = name_mistake(mine, one.picture, mistakes_of_the_whole(one.picture));
    const bool is_vague = words.starts_with("softer") || words.starts_with("rougher");
    if (!words.empty() && (found.empty() || !is_vague))
      found = explained(choices, one.name, {{words, ""}});
    is_sure = !words.empty() && !is_vague;
    if (is_sure) break;
    if (is_for_another(choices, one)) return "";
  }
  for (const slips::StageView& stage : stages) {
    if (is_sure) break;
    if (stage.tolerance > slips::of_rounding &&
        explain(mine, stage, 0).different * 200 < static_cast<long>(stage.pixels.size())) {
      return choices.file + ": chapter " + stage.chapter.substr(0, 2) +
             "'s picture, right but for its noise: other random numbers than the course's\n";
    }
    if (!has_other_colors(mine, stage)) continue;
    return choices.file + ": chapter " + stage.chapter.substr(0, 2) +
           "'s picture, right but for its texture: the file has few of these colors\n"
           "  judge it    if you took another texture: --texture FILE\n";
  }
  const WrongPicture& nearest = candidates.front();
  if (found.empty() && least <= few) {
    return but_for(choices, mine, nearest, stray_pixels(mine, nearest.picture),
                   stages.empty() ? nullptr : stages.data());
  }
  if (found.empty()) {
    const std::string quote = choices.file.find(' ') == std::string::npos ? "" : "\"";
    found = choices.file + ": wrong, by a mistake that is not known. The nearest picture is " +
            nearest.name.substr(0, 2) + "'s:\n  where       ./course diff " + quote + choices.file +
            quote + " tests/golden/" + nearest.name + ".png\n  more        " +
            place_of(choices.root(), "symptoms.html", "", "docs/symptoms.md");
  }
  return found + (candidates.size() > 1 ? if_another : "");
}

/// The same for a picture with the reader's texture, by the pixels that the stage has.
/// Errors: UsageError where no chapter that may be meant has a texture.
bool is_right_with_texture(const Choices& choices, const Image& mine,
                           const std::vector<WrongPicture>& right) {
  bool by_name = false;
  const std::vector<WrongPicture> candidates = meant(choices, mine, right, by_name);
  const std::vector<slips::StageView> stages = stages_of(choices, mine, candidates);
  if (stages.empty()) throw UsageError("none of these chapters has a texture: leave it out");
  for (const slips::StageView& stage : stages) {
    if (explain(mine, stage, 0).different > 0) continue;
    print(
        text("%s: right, chapter %s's picture with that texture, at each of the %zu pixels that "
             "were compared\n",
             choices.file.c_str(), stage.chapter.substr(0, 2).c_str(), stage.pixels.size()));
    return true;
  }
  const std::string found = by_slips(choices, mine, stages);
  print(found.empty() ? choices.file + ": wrong with that texture, by a mistake that is not known\n"
                      : found);
  if (by_name) print(if_another);
  return false;
}

/// What to do next.
enum Status { is_right = 0, is_wrong = 1, no_diagnosis = 2, ask_another = 3 };

/// Says what a picture is.
Status diagnose(const Choices& choices) {
  const Image mine = picture_in(choices.file);
  const std::vector<WrongPicture> right = right_pictures(choices.root() / "tests/golden");
  std::string found;
  bool is_it = false;
  if (!choices.texture.empty())
    return is_right_with_texture(choices, mine, right) ? is_right : is_wrong;
  for (const WrongPicture& one : right) {
    if (!is_same_picture(mine, one.picture) || stray_pixels(mine, one.picture).count > 0) continue;
    is_it = one.name.starts_with(choices.chapter);
    found = choices.file + (is_it ? ": right, " : ": not chapter " + choices.chapter + "'s, but ") +
            one.words + (one.name.starts_with("02") ? ", which 00 draws, too\n" : "\n");
    if (is_it) break;
  }
  if (found.empty()) {
    bool by_name = false;
    found = wrong(choices, mine, meant(choices, mine, right, by_name));
    if (by_name && !found.empty()) found += if_another;
  }
  print(found);
  return found.empty() ? ask_another : is_it ? is_right : is_wrong;
}

/// Says in a line what is wrong with one of two pictures, if the other is a chapter's.
Status name_difference(const Choices& choices) {
  const Image first = picture_in(choices.file), second = picture_in(choices.beside);
  for (const WrongPicture& one : right_pictures(choices.root() / "tests/golden")) {
    const bool is_second = is_same_picture(second, one.picture);
    if (!is_second && !is_same_picture(first, one.picture)) continue;
    if (is_for_another(choices, one)) return ask_another;
    const std::string words = slips::Words().of(is_second ? first : second, one);
    if (!words.empty()) print((is_second ? "The first: " : "The second: ") + words + "\n");
    break;
  }
  return is_right;
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  CommandLine line("diagnose", "names the mistake in a picture, and the page that explains it");
  line.positional("FILE", choices.file, "the picture, a PNG in the size that a chapter draws");
  line.text("--chapter", "NN", choices.chapter,
            "the chapter that should have drawn it; the default is the nearest");
  line.text("--texture", "FILE", choices.texture, "the texture that you drew it with");
  line.text("--source", "FOLDER", choices.source, "the folder of the chapters");
  line.text("--beside", "FILE", choices.beside,
            "another picture: print only what is wrong with one of both, if the other is a "
            "chapter's; the status is 0 if no error comes up");
  line.flag("--first", choices.first,
            "where only ./course's other program may know more, say nothing: the status is 3");
  line.statuses("0 the picture is right; 1 it is wrong; 2 an error, no diagnosis");
  Status found = is_right;
  const int status = run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (choices.chapter.size() == 1) choices.chapter.insert(0, "0");
    if (choices.chapter == "00") choices.chapter = "02";  // whose picture 00 draws
    found = choices.beside.empty() ? diagnose(choices) : name_difference(choices);
  });
  return status != 0 ? no_diagnosis : found;
}
