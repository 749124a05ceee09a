// Compares two steps of the course, or two pictures: writes a page and a report, and says whether
// only what may change has changed.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "comparison.hpp"
#include "engine/app/run_chapter.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/decode_image.hpp"
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
  std::string drawn = "out";
  bool shared = false;
  bool quiet = false;
};

/// A chapter that draws the stage: its pixels can be compared with those of another.
struct OnStage {
  const char* name;
  DrawnStep (*draw)(const char* name, const Drawing&, const std::vector<std::string>& options);
};

template <class Lesson>
constexpr OnStage on_stage(const char* name) {
  return {name,
          [](const char* chapter, const Drawing& drawing, const std::vector<std::string>& options) {
            return steps::draw_step<Lesson>(chapter, drawing.width, drawing.height, drawing.threads,
                                            options);
          }};
}

constexpr std::array stages = {
    on_stage<chapter_01::Lesson>("01_plain_spheres"),
    on_stage<chapter_02::Lesson>("02_checkerboard_uv"),
    on_stage<chapter_03::Lesson>("03_image_texture"),
    on_stage<chapter_04::Lesson>("04_uv_conventions"),
    on_stage<chapter_05::Lesson>("05_y_rotation"),
    on_stage<chapter_06::Lesson>("06_phong_texture_blend"),
};

const OnStage* stage_of(const std::string& chapter) {
  const auto* const found = std::find_if(
      stages.begin(), stages.end(), [&](const OnStage& stage) { return stage.name == chapter; });
  return found == stages.end() ? nullptr : found;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string number_of(const std::string& chapter) { return chapter.substr(0, 2); }

/// The options that show what a step adds, compared with another. Chapter 04's own choice is the
/// convention that chapter 03 has; chapter 06 begins with the globe turned by 20 degrees.
std::vector<std::string> options_of(const std::string& chapter, const std::string& other) {
  if (number_of(chapter) == "04" && other < chapter) return {"--convention", "daily"};
  if (number_of(chapter) == "05" && number_of(other) == "06") return {"--degrees", "20"};
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

/// The folders of chapters, such as 07_earth_by_sampling, in their order.
std::vector<std::string> chapters_in(const std::filesystem::path& source) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source)) {
    const std::string name = name_of(entry.path().filename());
    if (name.size() > 3 && is_digit(name[0]) && is_digit(name[1]) && name[2] == '_')
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The chapter's code, which is lesson.hpp or a single file, and the picture that it drew last or
/// should draw.
steps::Code code_of(const std::string& chapter, const Choices& choices) {
  const std::filesystem::path source = path_of(choices.source);
  const std::filesystem::path folder = source / chapter;
  const std::filesystem::path lesson = folder / "lesson.hpp";
  steps::Code code{chapter, text_of(exists(lesson) ? lesson : folder / "main.cpp"), {}};
  for (const std::filesystem::path& place :
       {path_of(choices.drawn), source.parent_path() / "tests" / "golden"}) {
    if (code.picture.empty() && exists(place / (chapter + ".png")))
      code.picture = place / (chapter + ".png");
  }
  return code;
}

/// The folder of a page, made; and where its pictures go.
steps::Pictures place_for(const std::string& name, const Choices& choices) {
  const std::filesystem::path folder = path_of(choices.folder) / path_of(name);
  std::filesystem::create_directories(folder);
  return {choices.shared ? folder : std::filesystem::path(), path_of(choices.drawn)};
}

/// The page of two chapters that have no pixels to compare.
void show_code(const steps::Code& before, const steps::Code& after, const steps::Pictures& pictures,
               const std::filesystem::path& page, bool quiet) {
  std::string own;
  int scenes = 0;
  for (const std::string& chapter : {before.chapter, after.chapter}) {
    if (stage_of(chapter) != nullptr) continue;
    own.append(own.empty() ? "" : " and ").append(chapter);
    scenes += 1;
  }
  const std::string why =
      own + (scenes == 2 ? " draw scenes of their own" : " draws a scene of its own") +
      ", so no pixels are compared.";
  write_text(page, steps::code_page(before, after, why, pictures));
  if (!quiet) {
    print("from " + before.chapter + " to " + after.chapter + ": the code; " + why + " Look at " +
          name_of(page) + "\n");
  }
}

/// Compares two chapters and writes the page; true if nothing else changed.
bool compare_chapters(const std::string& from, const std::string& to, const Choices& choices) {
  const std::string name = number_of(from) + "-" + number_of(to);
  const steps::Pictures pictures = place_for(name, choices);
  const std::filesystem::path place = path_of(choices.folder) / name;
  const std::filesystem::path page = place / "index.html";
  const steps::Code before_code = code_of(from, choices);
  const steps::Code after_code = code_of(to, choices);
  if (stage_of(from) == nullptr || stage_of(to) == nullptr) {
    show_code(before_code, after_code, pictures, page, choices.quiet);
    return true;
  }
  const auto draw = [](const std::string& chapter, const Drawing& drawing,
                       const std::string& other) {
    const OnStage& stage = *stage_of(chapter);
    return stage.draw(stage.name, drawing, options_of(chapter, other));
  };
  DrawnStep before = draw(from, choices.drawing, to);
  DrawnStep after = draw(to, choices.drawing, from);
  std::vector<int> may_change;
  for (const OnStage& stage : stages) {
    if (stage.name <= std::min(from, to) || stage.name > std::max(from, to)) continue;
    const DrawnStep step = stage.name == to     ? after
                           : stage.name == from ? before
                                                : draw(stage.name, {8, 6, 1}, stage.name);
    may_change.insert(may_change.end(), step.may_change.begin(), step.may_change.end());
  }
  std::sort(may_change.begin(), may_change.end());
  may_change.erase(std::unique(may_change.begin(), may_change.end()), may_change.end());

  const steps::Comparison result = steps::compare(std::move(before), std::move(after), may_change);
  write_text(place / "report.json", steps::report_json(result));
  write_text(page, steps::report_page(result, before_code.text, after_code.text, pictures));
  if (!choices.quiet || result.changed_elsewhere > 0) print(steps::summary(result, name_of(page)));
  return result.changed_elsewhere == 0;
}

Image picture_in(const std::string& typed) {
  const std::filesystem::path path = path_of(typed);
  return with_name("cannot load", path,
                   [&] { return decode_image(read_file(path, max_file_bytes)); });
}

/// Compares two picture files and writes the page; true if they are the same.
bool compare_pictures(const std::string& from, const std::string& to, const Choices& choices) {
  const Image a = picture_in(from);
  const Image b = picture_in(to);
  const Figures figures = measure(a, b);
  std::string name = name_of(path_of(from).filename());
  name.append("-").append(name_of(path_of(to).filename()));
  const steps::Pictures pictures = place_for(name, choices);
  const std::filesystem::path page = path_of(choices.folder) / path_of(name) / "index.html";
  write_text(page, steps::picture_page(from, a, to, b, figures, pictures));
  if (!choices.quiet) {
    print(text("%zu of %zu pixels differ (%.2f %%); look at ", figures.pixels_different,
               figures.pixels_compared, 100 * figures.share_different) +
          name_of(page) + "\n");
  }
  return figures.pixels_different == 0;
}

/// True for a name such as picture.png: what is compared is then files.
bool is_picture(const std::string& typed) { return path_of(typed).has_extension(); }

/// The chapter of a number: "7" and "07" are that of 07_earth_by_sampling.
/// Errors: UsageError if there is none.
std::string chapter_of(const std::string& typed, const std::vector<std::string>& chapters) {
  const bool is_number =
      !typed.empty() && typed.size() <= 2 && std::all_of(typed.begin(), typed.end(), is_digit);
  std::string number = typed;
  if (typed.size() == 1) number.insert(0, 1, '0');
  for (const std::string& chapter : chapters) {
    if (is_number && number_of(chapter) == number) return chapter;
  }
  throw UsageError("there is no chapter '" + typed + "': name two of " +
                   number_of(chapters.front()) + " to " + number_of(chapters.back()) +
                   ", or two picture files");
}

}  // namespace

int main(int argc, char** argv) {
  std::string before;
  std::string after;
  Choices choices;
  CommandLine line("compare_steps",
                   "what changed from one chapter to another, or between two pictures; without "
                   "them, from each chapter to the next");
  line.text("--from", "MM", before, "the chapter before, or a picture file");
  line.text("--to", "NN", after, "the chapter after, or a picture file");
  line.text("--out", "FOLDER", choices.folder,
            "write each page into its own folder MM-NN in this folder");
  line.text("--source", "FOLDER", choices.source, "the folder of the lessons' code");
  line.text("--drawn", "FOLDER", choices.drawn, "the folder of the chapters' own pictures");
  line.flag("--shared", choices.shared,
            "pages show those pictures and write others next to themselves; without it a page is "
            "one file");
  line.whole("--width", choices.drawing.width, 1, 4096, "columns of pixels");
  line.whole("--height", choices.drawing.height, 1, 4096, "rows of pixels");
  line.whole("--threads", choices.drawing.threads, 0, 1024,
             "number of threads, 0 for one per core");
  line.flag("--quiet", choices.quiet,
            "print nothing unless something changed that should not have");
  line.statuses(
      "0 only what may change has changed, or the pictures are the same; 1 something else has "
      "changed too, or they differ; 2 an error, no comparison");
  bool as_declared = true;
  const int status = run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    if (before.empty() != after.empty()) {
      throw UsageError(
          "--from and --to go together: give both, or neither to compare each chapter with the "
          "next");
    }
    if (is_picture(before) && is_picture(after)) {
      as_declared = compare_pictures(before, after, choices);
      return;
    }
    const std::vector<std::string> chapters = chapters_in(path_of(choices.source));
    if (chapters.empty()) throw UsageError("there are no chapters in '" + choices.source + "'");
    if (!before.empty()) {
      as_declared =
          compare_chapters(chapter_of(before, chapters), chapter_of(after, chapters), choices);
      return;
    }
    for (std::size_t i = 0; i + 1 < chapters.size(); ++i)
      as_declared = compare_chapters(chapters[i], chapters[i + 1], choices) && as_declared;
  });
  if (status != 0) return 2;
  return as_declared ? 0 : 1;
}
