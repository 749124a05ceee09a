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
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "10_projections/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "12_environment_map/lesson.hpp"
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
  DrawnStep (*on_stage)(const char* name, const Drawing&,
                        const std::vector<std::string>& options);  ///< where it draws the stage
  DrawnStep (*scene)(const char* name, const std::filesystem::path& file, int threads);
};

template <class Lesson>
DrawnStep draw_on_stage(const char* name, const Drawing& drawing,
                        const std::vector<std::string>& options) {
  return steps::draw_step<Lesson>(name, drawing.width, drawing.height, drawing.threads, options);
}
template <class Lesson>
DrawnStep draw_scene(const char* name, const std::filesystem::path& file, int threads) {
  return steps::draw_scene<Lesson>(name, file, threads);
}

template <class Lesson>
constexpr Chapter on_stage(const char* name) {
  return {name, draw_on_stage<Lesson>, draw_scene<Lesson>};
}
template <class Lesson>
constexpr Chapter own_scene(const char* name) {
  return {name, nullptr, draw_scene<Lesson>};
}

constexpr std::array chapters = {
    on_stage<chapter_01::Lesson>("01_plain_spheres"),
    on_stage<chapter_02::Lesson>("02_checkerboard_uv"),
    on_stage<chapter_03::Lesson>("03_image_texture"),
    on_stage<chapter_04::Lesson>("04_uv_conventions"),
    on_stage<chapter_05::Lesson>("05_y_rotation"),
    on_stage<chapter_06::Lesson>("06_phong_texture_blend"),
    own_scene<chapter_07::Lesson>("07_earth_by_sampling"),
    own_scene<chapter_08::Lesson>("08_triangle_uv"),
    own_scene<chapter_09::Lesson>("09_texture_filtering"),
    own_scene<chapter_10::Lesson>("10_projections"),
    own_scene<chapter_11::Lesson>("11_bump_and_normal_maps"),
    own_scene<chapter_12::Lesson>("12_environment_map"),
};

/// The options that show what a step adds, compared with another. Chapter 04's own choice is the
/// convention that chapter 03 has; chapter 06 begins with the globe turned by 20 degrees.
std::vector<std::string> options_of(std::size_t chapter, std::size_t other) {
  const auto is = [](std::size_t i, const char* number) {
    return std::string_view(chapters[i].name).starts_with(number);
  };
  if (is(chapter, "04") && other < chapter) return {"--convention", "daily"};
  if (is(chapter, "05") && is(other, "06")) return {"--degrees", "20"};
  return {};
}

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

/// The page of two chapters with different scenes.
void show_scenes(const Chapter& from, const Chapter& to, const std::filesystem::path& place,
                 const std::string& before_code, const std::string& after_code,
                 const Choices& choices) {
  const int threads = choices.drawing.threads;
  const DrawnStep before = from.scene(from.name, place / "before.png", threads);
  const DrawnStep after = to.scene(to.name, place / "after.png", threads);
  const std::filesystem::path page = place / "index.html";
  write_text(page, steps::scenes_page(before, after, before_code, after_code));
  if (!choices.quiet) {
    print("from " + before.chapter + " to " + after.chapter +
          ": different scenes, so no pixels are compared; both pictures and the code: " +
          name_of(page) + "\n");
  }
}

/// Compares chapters[from] with chapters[to] and writes the page; true if nothing else changed.
bool compare_pair(std::size_t from, std::size_t to, const Choices& choices) {
  const std::filesystem::path place =
      path_of(choices.folder) /
      (std::string(chapters[from].name, 2) + "-" + std::string(chapters[to].name, 2));
  std::filesystem::create_directories(place);
  const auto lesson = [&](std::size_t i) {
    return text_of(path_of(choices.source) / chapters[i].name / "lesson.hpp");
  };
  if (chapters[from].on_stage == nullptr || chapters[to].on_stage == nullptr) {
    show_scenes(chapters[from], chapters[to], place, lesson(from), lesson(to), choices);
    return true;
  }
  const auto draw = [](std::size_t i, const Drawing& drawing, std::size_t other) {
    return chapters[i].on_stage(chapters[i].name, drawing, options_of(i, other));
  };
  DrawnStep before = draw(from, choices.drawing, to);
  DrawnStep after = draw(to, choices.drawing, from);
  std::vector<int> may_change;
  for (std::size_t i = std::min(from, to) + 1; i <= std::max(from, to); ++i) {
    const DrawnStep step = i == to ? after : i == from ? before : draw(i, {8, 6, 1}, i);
    may_change.insert(may_change.end(), step.may_change.begin(), step.may_change.end());
  }
  std::sort(may_change.begin(), may_change.end());
  may_change.erase(std::unique(may_change.begin(), may_change.end()), may_change.end());

  const steps::Comparison result = steps::compare(std::move(before), std::move(after), may_change);
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

/// The chapter's place among those that can be compared. Errors: UsageError if it is none of them.
std::size_t place_of(const std::string& typed) {
  const auto* const found =
      std::find_if(chapters.begin(), chapters.end(),
                   [&](const Chapter& chapter) { return is_number_of(typed, chapter.name); });
  if (found != chapters.end()) return static_cast<std::size_t>(found - chapters.begin());
  throw UsageError("there is no chapter '" + typed + "' to compare: name two of 01 to " +
                   std::string(chapters.back().name, 2));
}

}  // namespace

int main(int argc, char** argv) {
  std::string before;
  std::string after;
  Choices choices;
  CommandLine line(
      "compare_steps",
      "what changed from one chapter to another; without chapters, from each to the next");
  line.text("--from", "MM", before, "the chapter before");
  line.text("--to", "NN", after, "the chapter after");
  line.text("--out", "FOLDER", choices.folder,
            "write each page into its own folder MM-NN in this folder");
  line.text("--source", "FOLDER", choices.source, "the folder of the lessons' code");
  line.whole("--width", choices.drawing.width, 1, 4096, "columns of pixels");
  line.whole("--height", choices.drawing.height, 1, 4096, "rows of pixels");
  line.whole("--threads", choices.drawing.threads, 0, 1024,
             "number of threads, 0 for one per core");
  line.flag("--quiet", choices.quiet,
            "print nothing unless something changed that should not have");
  line.statuses(
      "0 only what may change has changed; 1 something else has changed too; 2 an error, no "
      "comparison");
  bool as_declared = true;
  const int status = run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (before.empty() != after.empty()) {
      throw UsageError(
          "--from and --to go together: give both, or neither to compare each chapter with the "
          "next");
    }
    if (!before.empty()) {
      as_declared = compare_pair(place_of(before), place_of(after), choices);
      return;
    }
    for (std::size_t i = 0; i + 1 < chapters.size(); ++i)
      as_declared = compare_pair(i, i + 1, choices) && as_declared;
  });
  if (status != 0) return 2;
  return as_declared ? 0 : 1;
}
