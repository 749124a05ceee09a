// Compares two steps of the course, or two pictures: writes a page and a report, and says whether
// only what may change has changed.
#include <algorithm>

#include "comparison.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace {

using namespace texmap;
using steps::Code, steps::Comparison, steps::DrawnStep, steps::Drawing, steps::OnStage,
    steps::Pictures, steps::stages;

struct Choices {
  Drawing drawing;
  std::string folder = "out/diff";
  std::string source = TEXMAP_CHAPTERS_DIR;
  std::string drawn = "out";
  std::string mistake;
  bool shared = false;
  bool quiet = false;
};

const OnStage* stage_of(const std::string& chapter) {
  for (const OnStage& stage : stages())
    if (stage.name == chapter) return &stage;
  return nullptr;
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

std::string text_in(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes =
      with_name("cannot read", file, [&] { return read_file(file, 1U << 20); });
  return {bytes.begin(), bytes.end()};
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
Code code_of(const std::string& chapter, const Choices& choices) {
  const std::filesystem::path source = path_of(choices.source);
  const std::filesystem::path lesson = source / chapter / "lesson.hpp";
  const std::filesystem::path file = exists(lesson) ? lesson : source / chapter / "main.cpp";
  Code code{chapter, text_in(file), path_of(choices.drawn) / (chapter + ".png")};
  if (!exists(code.picture))
    code.picture = source.parent_path() / "tests" / "golden" / (chapter + ".png");
  if (!exists(code.picture)) code.picture.clear();
  return code;
}

/// A page in a folder of its own, which is made.
struct Place {
  std::filesystem::path folder;
  Pictures pictures;

  Place(const std::string& name, const Choices& choices)
      : folder(path_of(choices.folder) / path_of(name)),
        pictures{choices.shared ? folder : std::filesystem::path(), path_of(choices.drawn)} {
    create_directories(folder);
  }
  [[nodiscard]] std::filesystem::path page() const { return folder / "index.html"; }
};

/// The page of two chapters that have no pixels to compare.
void show_code(const std::string& from, const std::string& to, const Place& place,
               const Choices& choices) {
  const bool of_from = stage_of(from) == nullptr, of_to = stage_of(to) == nullptr;
  const std::string who = of_from && of_to ? from + " and " + to + " draw scenes of their own"
                                           : (of_from ? from : to) + " draws a scene of its own";
  const std::string why = who + ", so no pixels are compared.";
  write_text(place.page(),
             steps::code_page(code_of(from, choices), code_of(to, choices), why, place.pictures));
  if (!choices.quiet) {
    print("from " + from + " to " + to + ": the code; " + why + " Look at " +
          name_of(place.page()) + "\n");
  }
}

/// Compares two chapters and writes the page; true if nothing else changed.
bool compare_chapters(const std::string& from, const std::string& to, const Choices& choices) {
  const Place place(number_of(from) + "-" + number_of(to), choices);
  if (stage_of(from) == nullptr || stage_of(to) == nullptr) {
    show_code(from, to, place, choices);
    return true;
  }
  const auto draw = [&](const std::string& chapter, const std::string& other) {
    return stage_of(chapter)->draw(chapter, choices.drawing, options_of(chapter, other));
  };
  ObjectSet may_change;
  for (const OnStage& stage : stages()) {
    if (stage.name > std::min(from, to) && stage.name <= std::max(from, to))
      may_change.bits |= stage.changed_objects.bits;
  }
  const Comparison result = steps::compare(draw(from, to), draw(to, from), may_change);
  write_text(place.folder / "report.json", steps::report_json(result));
  write_text(place.page(), steps::report_page(result, code_of(from, choices), code_of(to, choices),
                                              place.pictures));
  if (!choices.quiet || result.changed_elsewhere > 0)
    print(steps::summary(result, name_of(place.page())));
  return result.changed_elsewhere == 0;
}

DrawnStep picture_in(const std::string& typed) {
  const std::filesystem::path path = path_of(typed);
  const auto decoded = [&] { return decode_image(read_file(path, max_file_bytes)); };
  return {typed, with_name("cannot load", path, decoded), {}, {}};
}

/// Compares two picture files and writes the page; true if they are the same.
bool compare_pictures(const std::string& from, const std::string& to, const Choices& choices) {
  Comparison result = steps::compare(picture_in(from), picture_in(to));
  result.mistake = choices.mistake;
  const Place place(name_of(path_of(from).filename()) + "-" + name_of(path_of(to).filename()),
                    choices);
  write_text(place.page(), steps::report_page(result, {}, {}, place.pictures));
  const Figures& figures = result.figures;
  if (!choices.quiet) {
    print("different: " + differing_pixels(figures) + "\n" + result.mistake +
          (result.mistake.empty() ? "" : "\n") + "Look at " + name_of(place.page()) + "\n");
  }
  return figures.pixels_different == 0;
}

/// The C++ files of a checkout's chapters, by their place in it; no links.
steps::Files files_of(const std::string& typed) {
  const std::filesystem::path folder = path_of(typed);
  const std::filesystem::path inner = folder / "chapters";
  const std::filesystem::path chapters = exists(inner) ? inner : folder;
  steps::Files files;
  for (const std::string& chapter : chapters_in(chapters)) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(chapters / path_of(chapter))) {
      const std::string ending = name_of(entry.path().extension());
      if (!is_regular_file(entry.symlink_status()) || (ending != ".hpp" && ending != ".cpp"))
        continue;
      files[name_of(entry.path().lexically_relative(chapters))] = text_in(entry.path());
    }
  }
  if (files.empty()) throw UsageError("there are no chapters in '" + typed + "'");
  return files;
}

/// Compares two checkouts' code and writes the page; true if it is the same.
bool compare_checkouts(const std::string& from, const std::string& to, const Choices& choices) {
  const auto before = files_of(from), after = files_of(to);
  auto all = before;
  all.insert(after.begin(), after.end());
  Code left{from, {}, {}}, right{to, {}, {}};
  std::string differing;
  std::ptrdiff_t lines = 0;
  for (const auto& [name, text] : all) {
    const std::string was = before.contains(name) ? before.at(name) : "";
    const std::string is = after.contains(name) ? after.at(name) : "";
    if (was == is) continue;
    differing += (differing.empty() ? "" : ", ") + name;
    lines += std::ranges::count(was, '\n') + std::ranges::count(is, '\n');
    if (lines > 8000) continue;  // each line is compared with each
    left.text.append("======== ").append(name).append("\n").append(was);
    right.text.append("======== ").append(name).append("\n").append(is);
  }
  const auto short_name = [](const std::string& typed) {
    return name_of(std::filesystem::canonical(path_of(typed)).filename());
  };
  const Place place(short_name(from) + "-" + short_name(to), choices);
  const std::string found = "different: " + (differing.empty() ? "no file" : differing);
  write_text(place.page(), steps::code_page(left, right, found, place.pictures));
  if (!choices.quiet) print(found + "\nLook at " + name_of(place.page()) + "\n");
  return differing.empty();
}

/// True for a name such as picture.png: what is compared is then files. A folder j.doe is none.
bool is_picture(const std::string& typed) {
  const std::filesystem::path path = path_of(typed);
  return path.has_extension() && !is_directory(path);
}

/// The chapter of a number: "7" and "07" are that of 07_earth_by_sampling.
/// Errors: UsageError if there is none.
std::string chapter_of(const std::string& typed, const std::vector<std::string>& chapters) {
  const std::string number = typed.size() == 1 ? "0" + typed : typed;
  for (const std::string& chapter : chapters) {
    if (number_of(chapter) == number) return chapter;
  }
  throw UsageError("there is no chapter '" + typed + "': name two of " +
                   number_of(chapters.front()) + " to " + number_of(chapters.back()) +
                   ", two picture files, or two checkouts");
}

/// Compares what was named, or each chapter with the next; true if nothing but what may change has.
bool compare_named(const std::string& before, const std::string& after, const Choices& choices) {
  if (before.empty() != after.empty()) {
    throw UsageError(
        "--from and --to go together: give both, or neither to compare each chapter with the "
        "next");
  }
  if (is_picture(before) && is_picture(after)) return compare_pictures(before, after, choices);
  if (is_directory(path_of(before)) && is_directory(path_of(after)))
    return compare_checkouts(before, after, choices);
  const std::vector<std::string> chapters = chapters_in(path_of(choices.source));
  if (chapters.empty()) throw UsageError("there are no chapters in '" + choices.source + "'");
  if (!before.empty())
    return compare_chapters(chapter_of(before, chapters), chapter_of(after, chapters), choices);
  bool as_declared = true;
  for (std::size_t i = 0; i + 1 < chapters.size(); ++i)
    as_declared = compare_chapters(chapters[i], chapters[i + 1], choices) && as_declared;
  return as_declared;
}

}  // namespace

int main(int argc, char** argv) {
  std::string before;
  std::string after;
  Choices choices;
  CommandLine line("compare_steps",
                   "what changed from one chapter to another, or between two pictures or two "
                   "checkouts; without them, from each chapter to the next");
  line.text("--from", "MM", before, "the chapter before, a picture file, or a checkout");
  line.text("--to", "NN", after, "the chapter after, a picture file, or a checkout");
  line.text("--out", "FOLDER", choices.folder,
            "write each page into its own folder MM-NN in this folder");
  line.text("--source", "FOLDER", choices.source, "the folder of the lessons' code");
  line.text("--drawn", "FOLDER", choices.drawn, "the folder of the chapters' own pictures");
  line.text("--mistake", "WORDS", choices.mistake,
            "what is wrong with one of two pictures: ./course asks diagnose");
  line.flag("--shared", choices.shared,
            "pages show those pictures and write others next to themselves; without it a page is "
            "one file");
  line.whole("--width", choices.drawing.width, 1, 4096, "columns of pixels");
  line.whole("--height", choices.drawing.height, 1, 4096, "rows of pixels");
  line.flag("--quiet", choices.quiet,
            "print nothing unless something changed that should not have");
  line.statuses(
      "0 only what may change has changed, or the pictures are the same; 1 something else has "
      "changed too, or they differ; 2 an error, no comparison");
  bool as_declared = true;
  const int status = run_guarded(line, [&] {
    if (line.parse(argc, argv)) as_declared = compare_named(before, after, choices);
  });
  if (status != 0) return 2;
  return as_declared ? 0 : 1;
}
