// The program grade from its command line on: pictures, checkouts by a builder that is played, and
// the formats' files.
#include <doctest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/running.hpp"

using namespace texmap;
using namespace texmap::test;
namespace fs = std::filesystem;

namespace {

const std::string golden = TEXMAP_TESTS_DIR "/golden/";

void copy(const std::string& from, const std::string& to) {
  fs::create_directories(path_of(to).parent_path());
  fs::copy_file(path_of(from), path_of(to), fs::copy_options::overwrite_existing);
}

std::string text_of(const std::string& path) {
  const std::vector<std::uint8_t> bytes = bytes_of(path);
  return {bytes.begin(), bytes.end()};
}

Outcome grade(const TemporaryFolder& folder, const std::string& words) {
  return run("\"" TEXMAP_GRADE "\" --out \"" + (folder / "out") + "\" " + words);
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

/// A program with build_and_run.py's interface that finds what `lines` says: printf's format for
/// the fields after the item, with the folder of the golden pictures as $golden.
std::string builder(const TemporaryFolder& folder, const std::string& body) {
  const std::string file = folder / "builder.sh";
  const std::string script = "#!/bin/sh\ngolden='" + golden +
                             "'\nwhile [ $# -gt 0 ]; do\n  case $1 in\n    --plan) plan=$2 ;;\n"
                             "    --results) results=$2 ;;\n  esac\n  shift\ndone\ntab=$(printf "
                             "'\\t')\nrow() { IFS=$tab; printf '%s\\n' \"$*\" >>\"$results\"; }\n" +
                             body;
  put(file, {script.begin(), script.end()});
  fs::permissions(path_of(file), fs::perms::owner_all);
  return "--builder " + quoted(file) + " ";
}

const char* const graded_well =
    "while IFS=$tab read -r id folder item; do\n"
    "  row $id $item bwrap ok ok 0.50 5.0 \"$golden$item.png\" \"$golden$item.png\" '' '' '' '' no "
    "''\ndone <\"$plan\"\n";

}  // namespace

TEST_CASE("a class of pictures is graded: statuses, tables, pages") {
  const TemporaryFolder folder;
  for (const char* name : {"ada", "Bea", "王小明", "=1+1"}) {
    for (const char* item : {"01_plain_spheres", "03_image_texture"})
      copy(golden + item + ".png", folder / ("class/" + std::string(name) + "/" + item + ".png"));
  }
  Image mirrored = load_image(golden + "03_image_texture.png");
  for (int y = 0; y < mirrored.height; ++y) {
    for (int x = 0; x < mirrored.width / 2; ++x)
      std::swap(mirrored.at(x, y), mirrored.at(mirrored.width - 1 - x, y));
  }
  save_png(mirrored, folder / "class/Bea/03_image_texture.png");

  const Outcome outcome = grade(folder, "--chapters 1,03 " + quoted(folder / "class"));
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("王小明") != std::string::npos);
  CHECK(outcome.out.find("1 of 2    Bea                      03 the whole picture is mirrored") !=
        std::string::npos);
  const std::string grades = text_of(folder / "out/grades.csv");
  CHECK(count(grades, "\r\n") == 1 + 8);
  CHECK(count(grades, "\"王小明\",\"03_image_texture\",\"\",\"\",\"\",\"0\"") == 1);
  CHECK(grades.find("\"'=1+1\"") != std::string::npos);
  CHECK(count(text_of(folder / "out/points.csv"), "\r\n") == 1 + 4);
  CHECK(fs::exists(folder / "out/Bea.html"));
  CHECK(!fs::exists(folder / "out/ada.html"));  // nothing is to be seen there
  CHECK(text_of(folder / "out/index.html").find("3 right<br>1 the whole picture is mirrored") !=
        std::string::npos);
}

TEST_CASE("a wrong command line and nothing to grade have status 2 and say what helps") {
  const TemporaryFolder folder;
  put(folder / "file", {1});
  const auto refused = [&](const std::string& words, const std::string& why) {
    const Outcome outcome = grade(folder, words);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(why) != std::string::npos);
  };
  refused("", "DIR is missing");
  refused(quoted(folder / "nowhere"), "there is no folder");
  refused(quoted(folder / "file"), "there is nothing to grade");
  refused("--chapters 99 " + quoted(folder.path()), "there is no chapter '99'");
  refused("--chapters 02.9 " + quoted(folder.path()), "'02.9', and no exercise");
  refused("--chapters 02, " + quoted(folder.path()), "'02,' has a comma with nothing before or");
  refused("--one --class " + quoted(folder.path()), "--one and --class exclude each other");
  refused("--format pdf " + quoted(folder.path()), "gradescope|classroom");
}

TEST_CASE("checkouts are graded by what the builder finds, and its text is made harmless") {
  const TemporaryFolder folder;
  for (const char* name : {"ada/texmap-main", "eve"}) {
    copy(golden + "../../README.md",
         folder / ("class/" + std::string(name) + "/chapters/01_plain_spheres/lesson.hpp"));
  }
  const std::string body =
      "while IFS=$tab read -r id folder item; do\n"
      "  case $folder,$item in\n"
      "    */ada/texmap-main,01*) row $id $item bwrap ok ok 0.50 5.0 \"$golden$item.png\" "
      "\"$golden$item.png\" \"${golden}02_checkerboard_uv.png\" \"$golden$item.png\" '' '' no '' "
      ";;\n"
      "    */ada/texmap-main,02*) row $id $item bwrap ok 'crashed SIGSEGV' 0.50 5.0 '' "
      "\"$golden$item.png\" '' '' '' '' no 'it ended by signal SIGSEGV' ;;\n"
      "    */ada/texmap-main,03*) row $id $item bwrap ok 'left processes' 0.50 5.0 "
      "\"$golden$item.png\" \"$golden$item.png\" '' \"$golden$item.png\" '' '' no 'it left one' "
      ";;\n"
      "    *) row $id $item bwrap 'does not build' '' '' '' '' \"$golden$item.png\" '' '' '' '' no "
      "'<b>error</b>: =1+1\\nline 2' ;;\n"
      "  esac\ndone <\"$plan\"\n";
  const Outcome outcome =
      grade(folder, builder(folder, body) + "--chapters 01,02,03 " + quoted(folder / "class"));
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  const std::string grades = text_of(folder / "out/grades.csv");
  CHECK(grades.find("\"ada\",\"01_plain_spheres\",\"ok\",\"ok\",\"0.50\",\"0\"") !=
        std::string::npos);
  CHECK(grades.find("a second one, drawn with other settings, is not") != std::string::npos);
  CHECK(grades.find("\"crashed SIGSEGV\"") != std::string::npos);
  // A program that did not end well draws no second picture, so nothing is said of one.
  CHECK(grades.find("\"it left one\",\"left processes\",\"0\",\"1\",\"\"") != std::string::npos);
  CHECK(text_of(folder / "out/eve.html").find("&lt;b&gt;error") != std::string::npos);
  CHECK(text_of(folder / "out/points.csv").find("\"ada\",\"0\"") != std::string::npos);
  CHECK(grades.find("NOT CONTAINED") == std::string::npos);
}

TEST_CASE("exercises are graded where they are asked for") {
  const TemporaryFolder folder;
  copy(golden + "../../README.md", folder / "class/ada/chapters/01_plain_spheres/lesson.hpp");
  copy(golden + "01_plain_spheres.png", folder / "class/bob/01.png");
  const std::string body =
      "while IFS=$tab read -r id folder item; do\n"
      "  case $item in\n"
      "    02.1) row $id $item bwrap ok ok 0.50 5.0 '' '' '' '' 1 1 no '' ;;\n"
      "    02.2) row $id $item bwrap ok ok 0.50 5.0 '' '' '' '' 0 1 no 'std::fmod: no squares; "
      "tried' "
      ";;\n"
      "    02.3) row $id $item bwrap ok hang 5.00 5.0 '' '' '' '' 0 1 no 'it was stopped' ;;\n"
      "    *.*) row $id $item bwrap missing '' '' '' '' '' '' '' '' '' no 'there is none' ;;\n"
      "    *) row $id $item bwrap ok ok 0.50 5.0 \"$golden$item.png\" '' '' '' 5 5 no '' ;;\n"
      "  esac\ndone <\"$plan\"\n";
  const std::string of_class = quoted(folder / "class");
  const Outcome outcome =
      grade(folder, builder(folder, body) + "--chapters exercises,01 " + of_class);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  const std::string grades = text_of(folder / "out/grades.csv");
  CHECK(count(grades, "\r\n") == 1 + 2 * (1 + 36));
  CHECK(grades.find("\"std::fmod: no squares; tried\",\"std::fmod\",\"0\",\"1\"") !=
        std::string::npos);
  CHECK(grades.find("\"it was stopped\",\"hang\",\"0\",\"1\"") != std::string::npos);
  // The chapter, its tests and 02.1; of pictures alone, no tests and no exercise.
  CHECK(text_of(folder / "out/points.csv").find("\"ada\",\"3\",\"38\"") != std::string::npos);
  CHECK(text_of(folder / "out/points.csv").find("\"bob\",\"1\",\"38\"") != std::string::npos);
  CHECK(count(grades, "\"bob\",\"02.1\",\"\",") == 1);
  // Blanks in a list are allowed. Who has nothing of it has one word for all.
  fs::create_directories(path_of(folder / "class/nobody"));
  const Outcome blanks =
      grade(folder, builder(folder, body) + "--chapters '01, 02.1 ,2.2' " + of_class);
  CHECK(blanks.status == 0);
  CHECK(blanks.out.find("0 of 4    nobody                   no chapter and no picture found\n") !=
        std::string::npos);
  CHECK(grade(folder, "--chapters 2.1 " + quoted(folder / "class/bob"))
            .out.find("bob                      missing; found 01.png\n") != std::string::npos);
  // Without being asked for, none.
  CHECK(grade(folder, builder(folder, body) + of_class).status == 0);
  CHECK(text_of(folder / "out/grades.csv").find("02.1") == std::string::npos);
}

TEST_CASE("programs that were not contained are named first: terminal, tables, pages") {
  const TemporaryFolder folder;
  copy(golden + "../../README.md", folder / "ada/chapters/01_plain_spheres/lesson.hpp");
  std::string body = graded_well;
  body.replace(body.find("bwrap"), 5, "none");
  const Outcome outcome = grade(
      folder, builder(folder, body) + "--chapters 01 --trust-students " + quoted(folder / "ada"));
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.starts_with("NOT CONTAINED"));
  for (const char* file : {"grades.csv", "points.csv"})
    CHECK(text_of(folder / ("out/" + std::string(file))).find("NOT CONTAINED") == 4);
  CHECK(text_of(folder / "out/index.html").find("NOT CONTAINED") != std::string::npos);
}

TEST_CASE("a builder that refuses ends the run with status 2, and what was graded stays") {
  const TemporaryFolder folder;
  copy(golden + "../../README.md", folder / "class/ada/chapters/01_plain_spheres/lesson.hpp");
  copy(golden + "01_plain_spheres.png", folder / "class/bob/01.png");
  const Outcome outcome = grade(folder, builder(folder, "echo 'cannot contain' >&2; exit 1\n") +
                                            "--chapters 01 " + quoted(folder / "class"));
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("cannot contain") != std::string::npos);
  CHECK(outcome.err.find("did not run to its end") != std::string::npos);
  CHECK(text_of(folder / "out/points.csv").find("\"bob\",\"1\",\"2\"") != std::string::npos);
}

TEST_CASE("a builder that has said why it refuses has the last word") {
  const TemporaryFolder folder;
  copy(golden + "../../README.md", folder / "ada/chapters/01_plain_spheres/lesson.hpp");
  const Outcome outcome = grade(folder, builder(folder, "echo 'error: no box' >&2; exit 2\n") +
                                            "--chapters 01 " + quoted(folder / "ada"));
  CHECK(outcome.status == 2);
  CHECK(outcome.err == "error: no box\n");
}

TEST_CASE("a task without a result ends the run with status 2") {
  const TemporaryFolder folder;
  for (const char* name : {"ada", "bob"}) {
    copy(golden + "../../README.md",
         folder / ("class/" + std::string(name) + "/chapters/01_plain_spheres/lesson.hpp"));
  }
  std::string body = graded_well;
  body.replace(body.find("row $id"), 7, "[ $id = 1-0 ] || row $id");
  const Outcome outcome =
      grade(folder, builder(folder, body) + "--chapters 01 " + quoted(folder / "class"));
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("1 of 2 tasks have no result, the first is 01_plain") !=
        std::string::npos);
}

TEST_CASE("two runs at once: the second one says which folder is in use, with status 2") {
  const TemporaryFolder folder;
  copy(golden + "../../README.md", folder / "class/ada/chapters/01_plain_spheres/lesson.hpp");
  const std::string words =
      "--chapters 01 --work " + quoted(folder / "work") + " " + quoted(folder / "class");
  // The first run's builder begins the others, with one of the two folders.
  const auto other = [&](const std::string& out, const std::string& work) {
    return "\"" TEXMAP_GRADE "\" " + words + " --out " + quoted(folder / out) + " --work " +
           quoted(folder / work) + " 2>>" + quoted(folder / "said") + "; echo $? >>" +
           quoted(folder / "said") + "\n";
  };
  const std::string body = other("out", "free") + other("free", "work") + graded_well;
  const Outcome outcome = grade(folder, builder(folder, body) + words);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  const std::string said = text_of(folder / "said");
  CHECK(said.find("is using the folder '" + folder / "out" + "'") != std::string::npos);
  CHECK(said.find("is using the folder '" + folder / "work" + "'") != std::string::npos);
  CHECK(count(said, "\n2\n") == 2);
  CHECK(text_of(folder / "out/points.csv").find("\"ada\",\"1\",\"1\"") != std::string::npos);
}

TEST_CASE("a run that is ended keeps what is done, and says so") {
  const TemporaryFolder folder;
  for (const char* name : {"ada", "eve"}) {
    copy(golden + "../../README.md",
         folder / ("class/" + std::string(name) + "/chapters/01_plain_spheres/lesson.hpp"));
  }
  const std::string body =
      "IFS=$tab read -r id folder item <\"$plan\"\n"
      "row $id $item bwrap ok ok 0.50 5.0 \"$golden$item.png\" \"$golden$item.png\" '' '' '' '' no "
      "''\nkill -s TERM $PPID\nexec sleep 60\n";
  const Outcome outcome =
      grade(folder, builder(folder, body) + "--chapters 01,02 " + quoted(folder / "class"));
  CAPTURE(outcome.err);
  CHECK(outcome.status == 130);
  CHECK(count(text_of(folder / "out/grades.csv"), "\r\n") == 2);
  CHECK(text_of(folder / "out/index.html").find("1 folder graded of 2") != std::string::npos);
  for (const char* file : {"points.csv", "index.html"}) {
    CHECK(text_of(folder / (std::string("out/") + file)).find("ended with 1 of 2 graded") !=
          std::string::npos);
  }
}

TEST_CASE("each format leaves its file, with the page's name where there are several students") {
  const TemporaryFolder folder;
  for (const char* name : {"ada", "bob"})
    copy(golden + "01_plain_spheres.png", folder / ("class/" + std::string(name) + "/01.png"));
  for (const auto& pair : {std::pair{"gradescope", "results.json"},
                           {"classroom", "classroom.json"},
                           {"junit", "junit.xml"}}) {
    const std::string format =
        pair.first;  // CAPTURE makes a lambda, which takes no structured binding
    const std::string file = pair.second;
    CAPTURE(format);
    const std::string words = "--chapters 01 --format " + std::string(format) + " ";
    const Outcome alone = grade(folder, words + quoted(folder / "class/ada"));
    CHECK(alone.status == 0);
    CHECK(fs::exists(path_of(folder / ("out/" + std::string(file)))));
    CHECK((alone.out.find("::notice title=Autograding complete::Points 1/1") !=
           std::string::npos) == (std::string(format) == "classroom"));
    CHECK(grade(folder, words + quoted(folder / "class")).status == 0);
    CHECK(fs::exists(path_of(folder / ("out/bob." + std::string(file)))));
  }
}
