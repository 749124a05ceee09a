// Compares two steps of the course: draws both, writes a page and a report, and says whether only
// what may change has changed.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "comparison.hpp"
#include "engine/app/run_chapter.hpp"
#include "engine/system/system.hpp"

namespace {

using namespace texmap;
using steps::DrawnStep;

struct Drawing {
  int width = 800;
  int height = 600;
  int threads = 0;
};

/// What the user chose.
struct Choices {
  Drawing drawing;
  std::string folder = "out/diff";
  std::string source = TEXMAP_CHAPTERS_DIR;
  bool quiet = false;
};

/// A chapter that can be compared.
struct Chapter {
  const char* name;
  DrawnStep (*draw)(const Drawing&);
};

template <class Lesson, const char* Name>
DrawnStep draw_chapter(const Drawing& drawing) {
  return steps::draw_step<Lesson>(Name, drawing.width, drawing.height, drawing.threads);
}

constexpr char name_01[] = "01_plain_spheres";
constexpr char name_02[] = "02_checkerboard_uv";
constexpr char name_03[] = "03_image_texture";
constexpr char name_04[] = "04_uv_conventions";
constexpr char name_05[] = "05_y_rotation";
constexpr char name_06[] = "06_phong_texture_blend";

constexpr std::array<Chapter, 6> chapters = {{
    {name_01, draw_chapter<chapter_01::Lesson, name_01>},
    {name_02, draw_chapter<chapter_02::Lesson, name_02>},
    {name_03, draw_chapter<chapter_03::Lesson, name_03>},
    {name_04, draw_chapter<chapter_04::Lesson, name_04>},
    {name_05, draw_chapter<chapter_05::Lesson, name_05>},
    {name_06, draw_chapter<chapter_06::Lesson, name_06>},
}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error("cannot read '" + name_of(path) + "'");
  return text.str();
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  with_name("cannot write", path, [&] { write_text_atomically(path, text); });
}

/// Compares chapters[from] with chapters[to] and writes the page; true if nothing else changed.
bool compare_pair(std::size_t from, std::size_t to, const Choices& choices) {
  DrawnStep before = chapters[from].draw(choices.drawing);
  DrawnStep after = chapters[to].draw(choices.drawing);
  std::vector<int> may_change;
  for (std::size_t i = std::min(from, to) + 1; i <= std::max(from, to); ++i) {
    const DrawnStep step = i == to ? after : i == from ? before : chapters[i].draw({8, 6, 1});
    may_change.insert(may_change.end(), step.may_change.begin(), step.may_change.end());
  }
  std::sort(may_change.begin(), may_change.end());
  may_change.erase(std::unique(may_change.begin(), may_change.end()), may_change.end());

  const steps::Comparison result = steps::compare(std::move(before), std::move(after), may_change);
  const std::filesystem::path place =
      path_of(choices.folder) /
      (std::string(chapters[from].name, 2) + "-" + std::string(chapters[to].name, 2));
  std::filesystem::create_directories(place);
  const auto lesson = [&](std::size_t i) {
    return text_of(path_of(choices.source) / chapters[i].name / "lesson.hpp");
  };
  write_text(place / "report.json", steps::report_json(result));
  const std::filesystem::path page = place / "index.html";
  write_text(page, steps::report_page(result, lesson(from), lesson(to)));
  if (!choices.quiet || result.changed_elsewhere > 0) print(steps::summary(result, name_of(page)));
  return result.changed_elsewhere == 0;
}

/// True if `typed` is the number of this chapter: "7" and "07" are those of 07_earth_by_sampling.
bool is_number_of(const std::string& typed, const std::string& name) {
  return typed.size() <= 2 && !typed.empty() &&
         parse_whole("a chapter", typed, 0, 99) == parse_whole("", name.substr(0, 2), 0, 99);
}

/// Where the chapter stands among those that can be compared; their number if it is none of them.
std::size_t place_of(const std::string& typed) {
  const auto found = std::find_if(chapters.begin(), chapters.end(), [&](const Chapter& chapter) {
    return is_number_of(typed, chapter.name);
  });
  return static_cast<std::size_t>(found - chapters.begin());
}

/// The chapter's folder, whether it can be compared or not.
/// Errors: UsageError if there is none.
std::string chapter_named(const std::string& typed, const std::string& source) {
  for (const auto& entry : std::filesystem::directory_iterator(path_of(source))) {
    std::string name = name_of(entry.path().filename());
    const bool is_chapter =
        name.size() > 3 && is_digit(name[0]) && is_digit(name[1]) && name[2] == '_';
    if (is_chapter && is_number_of(typed, name)) return name;
  }
  throw UsageError("there is no chapter '" + typed + "' to compare");
}

/// What to say of two chapters with different scenes: where their difference can be read.
std::string why_not(const std::string& before, const std::string& after, const Choices& choices) {
  const std::string from = chapter_named(before, choices.source);
  const std::string to = chapter_named(after, choices.source);
  const std::string new_scene = place_of(after) == chapters.size() ? to : from;
  const std::string folder = name_of(std::filesystem::proximate(path_of(choices.source)));
  return "chapter " + new_scene.substr(0, 2) +
         " begins a new scene, and pictures of different scenes have no pixels to compare.\nThe "
         "step is told in " +
         folder + "/" + new_scene + "/README.md; its code is shown by:\n  git diff --no-index " +
         folder + "/" + from + "/lesson.hpp " + folder + "/" + to + "/lesson.hpp";
}

}  // namespace

int main(int argc, char** argv) {
  std::string before;
  std::string after;
  Choices choices;
  CommandLine line(
      "compare_steps",
      "what changed between two steps of the course; without chapters, between all neighbours");
  line.text("--from", "MM", before, "the chapter before");
  line.text("--to", "NN", after, "the chapter after");
  line.text("--out", "FOLDER", choices.folder, "where the pages go, in a folder MM-NN each");
  line.text("--source", "FOLDER", choices.source, "where the lessons' code is");
  line.whole("--width", choices.drawing.width, 1, 4096, "columns of pixels");
  line.whole("--height", choices.drawing.height, 1, 4096, "rows of pixels");
  line.whole("--threads", choices.drawing.threads, 0, 1024,
             "threads to draw with, 0 for one per core");
  line.flag("--quiet", choices.quiet,
            "nothing printed unless something changed that should not have");
  line.statuses(
      "0 only what may change has changed; 1 something else has, too; 2 the comparison could not "
      "be made");
  bool as_declared = true;
  const int status = run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (before.empty() != after.empty()) {
      throw UsageError(
          "--from and --to go together: name two chapters to compare, or none for all neighbours");
    }
    if (!before.empty()) {
      const std::size_t from = place_of(before);
      const std::size_t to = place_of(after);
      if (std::max(from, to) == chapters.size())
        throw std::runtime_error(why_not(before, after, choices));
      as_declared = compare_pair(from, to, choices);
      return;
    }
    for (std::size_t i = 0; i + 1 < chapters.size(); ++i)
      as_declared = compare_pair(i, i + 1, choices) && as_declared;
  });
  if (status != 0) return 2;
  return as_declared ? 0 : 1;
}
