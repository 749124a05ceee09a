// What grading makes of folders, pictures and names: without any student's program.
#include <doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "builder.hpp"
#include "class_pages.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "known_words.hpp"
#include "picture_verdict.hpp"
#include "safe_text.hpp"
#include "submissions.hpp"
#include "support/made_pictures.hpp"
#include "support/temporary_folder.hpp"
#include "tables.hpp"

using namespace texmap;
using namespace texmap::grade;
using namespace texmap::test;
namespace fs = std::filesystem;

namespace {

const std::vector<Item> two_items = {{"03_image_texture", "03", "", false},
                                     {"04_uv_conventions", "04", "", false}};

/// Makes an empty file and the folders to it.
void touch(const fs::path& path) {
  fs::create_directories(path.parent_path());
  std::ofstream(path).put('x');
}

/// The one submission in a folder with this file.
Submission found_with(const std::string& file) {
  const TemporaryFolder folder;
  touch(path_of(folder / file));
  const auto all = find_submissions({path_of(folder / "ada")}, two_items).submissions;
  REQUIRE(all.size() == 1);
  return all[0];
}

/// The names of the students in these folders.
std::set<std::string> names_in(const std::vector<fs::path>& folders,
                               Reading reading = Reading::by_structure) {
  std::set<std::string> names;
  for (const Submission& one : find_submissions(folders, two_items, reading).submissions)
    names.insert(one.name);
  return names;
}

std::vector<std::string> remarks_on(const std::vector<fs::path>& folders) {
  return find_submissions(folders, two_items).remarks;
}

/// A golden picture in a file, and the row of a student's picture.
struct Compared {
  TemporaryFolder folder;
  Golden golden;
  Row row;

  Compared(const Image& should, const Image& is) {
    save_png(should, folder / "golden.png");
    save_png(is, folder / "is.png");
    golden = read_golden(folder / "golden.png");
    compare_with_golden(folder / "is.png", golden, row);
  }
};

Student student_named(const std::string& name, std::vector<Row> rows) {
  return {"students/" + name, name, file_name_of(name), "", std::move(rows)};
}

Row right_row(const std::string& item) {
  Row row;
  row.item = item;
  row.word = "ok";
  row.picture_ok = true;
  row.figures = PictureFigures{};
  return row;
}

Row wrong_row(const std::string& item, const std::string& word, const std::string& note) {
  Row row;
  row.item = item;
  row.word = word;
  row.note = note;
  return row;
}

}  // namespace

// --- Text ---------------------------------------------------------------------------------------

TEST_CASE("names in any writing stay as they are; control characters and turning marks go") {
  for (const char* name : {"王小明", "Ada Lovelace", "Ångström", "عمر", "a'b\"c", "=1+1"})
    CHECK(clean(name) == name);
  CHECK(clean("a\nb\tc") == "a b c");
  CHECK(clean("a\x1B[31mb\x7F") == "a[31mb");
  CHECK(clean("a\xE2\x80\xAE"
              "b") == "ab");
  CHECK(clean("a\xFF"
              "b\xC3") ==
        "a\xEF\xBF\xBD"
        "b\xEF\xBF\xBD");
  CHECK(clean("\xED\xA0\x80") == "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");  // a surrogate
}

TEST_CASE("a name that is not UTF-8 is shown with its letters, or its bytes") {
  CHECK(shown_name("王小明") == "王小明");
  CHECK(shown_name("M\xFC"
                   "ller") == "Müller");
  CHECK(shown_name("M\x81"
                   "ller") == "M\\x81ller");
  CHECK(shown_name("\xEF\xBF\xBD") == "\xEF\xBF\xBD");
}

TEST_CASE("every cell is quoted, and none is a formula for any spreadsheet") {
  CHECK(csv_cell("ada") == "\"ada\"");
  CHECK(csv_cell("say \"hi\"") == "\"say \"\"hi\"\"\"");
  CHECK(csv_cell("=1+1") == "\"'=1+1\"");
  CHECK(csv_cell(" =1+1") == "\" '=1+1\"");
  CHECK(csv_cell("\xE3\x80\x80=1") == "\"\xE3\x80\x80'=1\"");  // the wide blank
  CHECK(csv_cell("＝1+1") == "\"'＝1+1\"");
  CHECK(csv_cell("yours: (0, -1, 0); -2") == "\"yours: (0, -1, 0); -2\"");
  CHECK(csv_cell("\"=1") == "\"\"\"'=1\"");
  CHECK(csv_cell("x\n=1") == "\"x =1\"");  // one line: the cell does not begin there
  CHECK(csv_cell("a-b = c") == "\"a-b = c\"");
}

TEST_CASE("pages have names of their own, also on systems that take ada and Ada for the same") {
  std::vector<Submission> all(6);
  const std::array<const char*, 6> names = {"ada", "Ada", "王小", "李小红", "index", "a/..b"};
  for (std::size_t i = 0; i < all.size(); ++i) all[i].name = names[i];
  const std::vector<std::string> pages = page_names(all);
  CHECK(pages ==
        std::vector<std::string>{"ada", "Ada-2", "student", "student-2", "index-2", "a___b"});
  CHECK(padded("王小明", 8) == "王小明  ");
}

TEST_CASE("the word of a note ends before a colon with a blank, and stands there once") {
  CHECK(first_word("std::fmod keeps the sign: tried -1; yours -1") == "std::fmod keeps the sign");
  CHECK(first_word("not yet; tried: 1") == "not yet");
  CHECK(first_word("mirrored") == "mirrored");
  CHECK(with_word("mirrored", "mirrored: columns run back") == "mirrored: columns run back");
  CHECK(with_word("not yet", "not yet; tried 1") == "not yet; tried 1");
  CHECK(with_word("hang", "it was stopped") == "hang: it was stopped");
  CHECK(with_word("missing", "") == "missing");
}

// --- Folders ------------------------------------------------------------------------------------

TEST_CASE("work is found in the layouts of learning systems, in any case") {
  for (const char* file :
       {"ada/03_image_texture.png", "ada/03.png", "ada/3.PNG", "ada/out/03_image_texture.png",
        "ada/OUT/03_IMAGE_TEXTURE.PNG", "ada/homework-main/out/03-globe.png", "ada/Chapter 3.png",
        "ada/ch03.png", "ada/Kap. 03.png", "ada/Chapter 3 final.png", "ada/picture_03.png",
        "ada/screenshot 03.png", "ada/03 (1).png"}) {
    CAPTURE(file);
    const Submission found = found_with(file);
    CHECK(found.name == "ada");
    CHECK(found.checkout.empty());
    CHECK(found.pictures.size() == 1);
    CHECK(found.pictures.at("03_image_texture").why_not.empty());
  }
  for (const char* file : {"ada/chapters/03_image_texture/lesson.hpp",
                           "ada/texmap-main/chapters/03_image_texture/lesson.hpp"}) {
    CAPTURE(file);
    CHECK(!found_with(file).checkout.empty());
  }
  for (const char* file : {"ada/033.png", "ada/image_texture.png", "ada/03.1.png", "ada/03.txt",
                           "ada/2 of 03 b.png", "ada/IMG_0034.png", "ada/x003.png",
                           "ada/tests/golden/03_image_texture.png", "ada/.git/03.png"}) {
    CAPTURE(file);
    CHECK(found_with(file).pictures.empty());
  }
}

TEST_CASE("chapters are found in Chapters/ and without a folder around them") {
  const auto checkout_of = [](const std::string& file) {
    const Submission found = found_with(file);
    return found.checkout.empty() ? "" : name_of(found.checkout.lexically_relative(found.path));
  };
  // The builder looks for chapters/ in it, then takes it for the folder of the chapters.
  CHECK(checkout_of("ada/chapters/03_image_texture/lesson.hpp") == ".");
  CHECK(checkout_of("ada/Chapters/03_image_texture/lesson.hpp") == "Chapters");
  CHECK(checkout_of("ada/03_image_texture/lesson.hpp") == ".");
  CHECK(checkout_of("ada/homework/03_image_texture/lesson.hpp") == "homework");
  CHECK(checkout_of("ada/03_image_texture/exercises/1_a.hpp") == ".");
  CHECK(checkout_of("ada/03_image_texture/03.png").empty());
  CHECK(checkout_of("ada/09_another/lesson.hpp").empty());
  const std::vector<Item> exercise = {
      {"03.1", "03.1", "", false, "chapters/03_image_texture/exercises/1_b.hpp"}};
  const TemporaryFolder folder;
  touch(path_of(folder / "ada/03_image_texture/exercises/1_a.hpp"));
  CHECK(!find_submissions({path_of(folder / "ada")}, exercise).submissions[0].checkout.empty());
}

TEST_CASE("what lies there under another name is named") {
  CHECK(found_with("ada/lesson.hpp").seen == "lesson.hpp, but not in a chapter's folder");
  CHECK(found_with("ada/screenshot.png").seen == "screenshot.png");
  CHECK(found_with("ada/03.png").seen.empty());
  const TemporaryFolder folder;
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    touch(path_of(folder / (std::string("ada/") + name + ".png")));
  CHECK(find_submissions({path_of(folder / "ada")}, two_items).submissions[0].seen ==
        "a.png, b.png, c.png, d.png and 2 pictures more");
  CHECK(found_with("ada/notes.txt").seen.empty());
}

TEST_CASE("of several pictures the best name counts, then the one nearest to the top") {
  const TemporaryFolder folder;
  touch(path_of(folder / "ada/old/03_image_texture.png"));
  touch(path_of(folder / "ada/03.png"));
  auto all = find_submissions({path_of(folder / "ada")}, two_items).submissions;
  CHECK(all[0].pictures.at("03_image_texture").path.parent_path().filename() == "old");
  touch(path_of(folder / "ada/03_image_texture.png"));
  all = find_submissions({path_of(folder / "ada")}, two_items).submissions;
  CHECK(all[0].pictures.at("03_image_texture").path.parent_path().filename() == "ada");

  touch(path_of(folder / "bob/04_a.png"));
  touch(path_of(folder / "bob/04_b.png"));
  all = find_submissions({path_of(folder / "bob")}, two_items).submissions;
  CHECK(all[0].pictures.at("04_uv_conventions").why_not ==
        "04_a.png or 04_b.png? Name the picture 04_uv_conventions.png");
}

TEST_CASE("a folder of students' folders is a class; one student's folders are not") {
  const TemporaryFolder folder;
  touch(path_of(folder / "class/ada/03.png"));
  touch(path_of(folder / "class/bob/out/03.png"));
  touch(path_of(folder / "class/王小明/texmap-main/chapters/03_image_texture/lesson.hpp"));
  fs::create_directories(path_of(folder / "class/nobody"));
  touch(path_of(folder / "class/read me.txt"));
  CHECK(names_in({path_of(folder / "class")}) ==
        std::set<std::string>{"ada", "bob", "王小明", "nobody"});
  CHECK(remarks_on({path_of(folder / "class")}).empty());
  CHECK(found_with("ada/texmap-main/out/03.png").name == "ada");
}

TEST_CASE("a picture next to the students' folders does not turn a class into one student") {
  const TemporaryFolder folder;
  for (const char* file : {"03_expected.png", "03 solution.png", "ada/03.png", "nobody/a.txt"})
    touch(path_of(folder / (std::string("one in two/") + file)));
  const fs::path first = path_of(folder / "one in two");
  CHECK(names_in({first}) == std::set<std::string>{"ada", "nobody"});
  touch(first / "bob/chapters/03_image_texture/lesson.hpp");
  CHECK(names_in({first}) == std::set<std::string>{"ada", "bob", "nobody"});
  const std::vector<std::string> remarks = remarks_on({first});
  REQUIRE(remarks.size() == 1);
  CHECK(remarks[0].find("a class of 3 students; 03 solution.png is nobody's; --one") !=
        std::string::npos);
  CHECK(names_in({first}, Reading::one_student) == std::set<std::string>{"one in two"});

  // A student's own picture counts where each student was named.
  fs::create_directories(path_of(folder / "two"));
  CHECK(names_in({first, path_of(folder / "two")}) == std::set<std::string>{"one in two", "two"});
  touch(path_of(folder / "own/03.png"));
  touch(path_of(folder / "own/old/03.png"));
  CHECK(names_in({path_of(folder / "own")}) == std::set<std::string>{"own"});
  CHECK(remarks_on({path_of(folder / "own")}).size() == 1);
  CHECK(names_in({path_of(folder / "own")}, Reading::students) == std::set<std::string>{"old"});
}

TEST_CASE("folders in a folder are students, even if nothing that was asked for is in them") {
  const TemporaryFolder folder;
  for (const char* file : {"ada/05.png", "bob/05.png", "eve/notes.txt"})
    touch(path_of(folder / (std::string("class/") + file)));
  touch(path_of(folder / "small/ada/03.png"));
  CHECK(names_in({path_of(folder / "class")}) == std::set<std::string>{"ada", "bob", "eve"});
  CHECK(names_in({path_of(folder / "small")}) == std::set<std::string>{"ada"});
  CHECK(remarks_on({path_of(folder / "small")}).size() == 1);
  CHECK(names_in({path_of(folder / "class/ada"), path_of(folder / "small/ada")}).size() == 1);
}

#ifdef __linux__  // other systems make no such names
TEST_CASE("a folder is graded whatever bytes its name has, except what ends a line") {
  const TemporaryFolder folder;
  const auto found = [&folder](const std::string& name) {
    touch(path_of(folder / (name + "/chapters/03_image_texture/lesson.hpp")));
    return find_submissions({path_of(folder / name)}, two_items).submissions.at(0);
  };
  for (const char* name : {"M\xFC"
                           "ller",
                           "a\xE2\x80\xAE"
                           "b",
                           "a\x1B"
                           "b"}) {
    const Submission one = found(name);
    CHECK(one.note.empty());
    CHECK(one.checkout == one.path);
  }
  CHECK(found("M\xFC"
              "ller")
            .name == "Müller");
  for (const char* name : {"a\tb", "a\nb",
                           "a\xC2\x85"
                           "b"}) {
    const Submission one = found(name);
    CHECK(one.checkout.empty());
    CHECK(one.note == "the folder's name has a tab or a line end; rename it");
  }
}
#endif

#ifndef _WIN32
TEST_CASE("links are not followed: neither pictures nor folders") {
  const TemporaryFolder folder;
  touch(path_of(folder / "secret/04_uv_conventions.png"));
  fs::create_directories(path_of(folder / "ada"));
  fs::create_symlink(path_of(folder / "secret/04_uv_conventions.png"),
                     path_of(folder / "ada/03.png"));
  fs::create_directory_symlink(path_of(folder / "secret"), path_of(folder / "ada/out"));
  const auto all = find_submissions({path_of(folder / "ada")}, two_items).submissions;
  CHECK(all[0].pictures.at("03_image_texture").why_not ==
        "03.png is a link; links are not followed");
  CHECK(all[0].pictures.count("04_uv_conventions") == 0);
}
#endif

// --- Pictures -----------------------------------------------------------------------------------

TEST_CASE("0.02 % of the pixels may be off by more than one level, and not one more") {
  const Image should = ramps(250, 40);  // of 10000 pixels, two
  Image is = should;
  const auto worsen = [&is](int column, int by) {
    std::uint8_t& green = is.at(column, 3).g;
    green = static_cast<std::uint8_t>(green ^ by);
  };
  for (int column = 10; column < 100; ++column) worsen(column, 1);
  CHECK(Compared(should, is).row.picture_ok);
  worsen(1, 64);
  worsen(2, 64);
  const Compared allowed(should, is);
  CHECK(allowed.row.picture_ok);
  CHECK(allowed.row.note == "as few as the rule allows: 2 pixels are off by more than one level");
  worsen(3, 64);
  const Compared wrong(should, is);
  CHECK(!wrong.row.picture_ok);
  CHECK(wrong.row.word == "differs 0.03 %");
  REQUIRE(wrong.row.shown);
  CHECK(wrong.row.shown->map.width <= 256);
}

TEST_CASE("the page shows the part of a picture that is wrong, and a single wrong pixel in it") {
  const Image should(800, 600, {10, 20, 30});
  Image is = should;
  for (int column = 700; column < 800; ++column) is.at(column, 599) = {200, 20, 30};
  const Compared compared(should, is);
  REQUIRE(compared.row.shown);
  CHECK(compared.row.shown->where == "columns 544 to 799, rows 408 to 599");
  CHECK(compared.row.shown->map.at(255, 191) != Rgb8{});
  CHECK(compared.row.shown->map.at(0, 0) == Rgb8{});
}

TEST_CASE("a picture of another size, a bomb and a text are refused in words") {
  CHECK(Compared(ramps(40, 30), ramps(30, 40)).row.note ==
        "the picture has 30 x 40 pixels and should have 40 x 30");
  for (const char* file :
       {"bad_bomb_100000x100000.png", "bad_one_byte.png", "bad_trunc_idat.png"}) {
    CAPTURE(file);
    const TemporaryFolder folder;
    save_png(ramps(40, 30), folder / "golden.png");
    Golden golden = read_golden(folder / "golden.png");
    Row row;
    compare_with_golden(std::string(TEXMAP_TESTS_DIR "/corpus/") + file, golden, row);
    CHECK(row.word == "unreadable");
    CHECK(!row.picture_ok);
  }
}

TEST_CASE("colors are compared; an alpha channel is not looked at, and the note says so") {
  const std::string file = TEXMAP_TESTS_DIR "/corpus/png_rgba16.png";
  Golden golden{{}, load_image(file), {}};
  Row row;
  compare_with_golden(file, golden, row);
  CHECK(row.picture_ok);
  CHECK(row.note == "the file has an alpha channel, which is not looked at");
}

TEST_CASE("a right picture whose second picture is wrong gets no point") {
  const TemporaryFolder folder;
  save_png(ramps(40, 30), folder / "expected.png");
  save_png(ramps(40, 30, 5), folder / "other.png");
  Row row = right_row("03_image_texture");
  compare_hidden(folder / "expected.png", folder / "expected.png", row);
  CHECK(row.hidden == "yes");
  CHECK(row.points() == 1);
  compare_hidden(folder / "other.png", folder / "expected.png", row);
  CHECK(row.hidden == "no");
  CHECK(row.points() == 0);
  compare_hidden("", folder / "expected.png", row);  // it drew none
  CHECK(row.hidden == "no");
}

TEST_CASE("a known mistake gets its word: of the whole picture, or drawn before") {
  const TemporaryFolder folder;
  save_png(ramps(200, 150), folder / "golden.png");
  const Item item{"03_image_texture", "03", folder / "golden.png", false};
  const Image should = ramps(200, 150);
  Image mirrored(200, 150);
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 200; ++x) mirrored.at(x, y) = should.at(199 - x, y);
  }
  const Image texture = noise(200, 150, 7);
  save_wrong_pictures(
      std::vector<WrongPicture>{{"mirrored", "mirrored: u runs the other way", texture}},
      path_of(folder / "03_image_texture"));
  KnownWords words("no program", folder.path(), [] { return false; });
  CHECK(words.words_for(item, mirrored, should) ==
        "the whole picture is mirrored: columns run the other way");
  CHECK(words.words_for(item, texture, should) == "mirrored: u runs the other way");
  CHECK(words.words_for(item, noise(200, 150, 8), should).empty());
}

// --- Tables and pages ---------------------------------------------------------------------------

TEST_CASE("a table begins with the byte order mark, and warns first if nothing was contained") {
  Class all{two_items, {student_named("ada", {right_row("03_image_texture")})}, 1};
  CHECK(grades_csv(all).starts_with("\xEF\xBB\xBF\"student\",\"chapter\""));
  CHECK(points_csv(all) ==
        "\xEF\xBB\xBF\"folder\",\"name\",\"points\",\"of\",\"chapters\",\"page\",\"note\"\r\n"
        "\"students/ada\",\"ada\",\"1\",\"1\",\"1\",\"ada\",\"ended with 1 of 2 graded\"\r\n");
  CHECK(class_page(all).find(">1 of 1<br>ended with 1 of 2 graded</td>") != std::string::npos);
  all.students[0].rows[0].containment = "none";
  CHECK(grades_csv(all).starts_with("\xEF\xBB\xBF\"NOT CONTAINED"));
  CHECK(points_csv(all).starts_with("\xEF\xBB\xBF\"NOT CONTAINED"));
  CHECK(class_page(all).find("<h1>Grades</h1>\n<p class=\"verdict bad\">NOT CONTAINED") !=
        std::string::npos);
  CHECK(student_page(all.students[0]).find("NOT CONTAINED") != std::string::npos);
}

TEST_CASE("the class's page has the worst first, a row of sums, and links where there is a page") {
  Class all{two_items, {}, 200};
  for (int i = 0; i < 200; ++i) {
    all.students.push_back(
        student_named("student " + std::to_string(i),
                      {right_row("03_image_texture"), right_row("04_uv_conventions")}));
  }
  CHECK(class_page(all).size() < 100000);
  CHECK(class_page(all).find("<a href=\"student_7.html\">") == std::string::npos);
  for (int i = 0; i < 37; ++i)
    all.students[static_cast<std::size_t>(150 + i)].rows[0] =
        wrong_row("03_image_texture", "mirrored", "");
  all.students[190].rows[0] = wrong_row("03_image_texture", "differs 3 %", "");
  const std::string page = class_page(all);
  CHECK(page.find("<td>162 right<br>37 mirrored<br>1 differ</td>") != std::string::npos);
  CHECK(page.find("Tests") == std::string::npos);             // no student has tests
  CHECK(page.find("class=\"scroll\"") == std::string::npos);  // it would be cut on paper
  CHECK(student_page(all.students[150]).find("pre { white-space: pre-wrap") != std::string::npos);
  all.students[0].rows[0].tests_run = 5;
  CHECK(class_page(all).find("Tests</button>") != std::string::npos);
  CHECK(page.find("student 150<") < page.find("student 0<"));
  CHECK(page.find("<a href=\"student_150.html\">") != std::string::npos);
}

TEST_CASE("an exercise is worth one point, and its mistakes are counted") {
  const std::string file = "chapters/02_checkerboard_uv/exercises/1_where_on_the_map.hpp";
  Row wrong = wrong_row("02.1", "u runs the other way", "u runs the other way: mirrored");
  wrong.exercise = file;
  wrong.tests_run = 1;
  Row right = wrong;
  right.word = "ok";
  right.note = "";
  right.tests_passed = 1;
  CHECK((wrong.points() == 0 && wrong.of() == 1));
  CHECK((right.points() == 1 && right.of() == 1));
  right.with_tests = true;  // as a chapter's tests would be
  CHECK((right.points() == 1 && right.of() == 1));
  const Class all{{{"02.1", "02.1", "", false, file}},
                  {student_named("ada", {right}), student_named("bob", {wrong})},
                  2};
  CHECK(class_page(all).find("1 right<br>1 u runs the other way") != std::string::npos);
  CHECK(
      grades_csv(all).find("\"ada\",\"02.1\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"1 of 1\"") !=
      std::string::npos);
  CHECK(student_page(all.students[1]).find("u runs the other way: mirrored") != std::string::npos);
}

TEST_CASE("a picture is none of an exercise, also with its number as a name") {
  const TemporaryFolder folder;
  touch(path_of(folder / "ada/02.1.png"));
  const std::vector<Item> items = {{"02.1", "02.1", "", false, "chapters/02_a/exercises/1_b.hpp"}};
  CHECK(find_submissions({path_of(folder / "ada")}, items).submissions[0].pictures.empty());
}

TEST_CASE("nothing that a student wrote becomes part of a page") {
  const std::string evil = "<script>alert(1)</script>\"'&\x1B";
  Student student = student_named(evil, {wrong_row("03_image_texture", evil, evil)});
  student.note = evil;
  for (const std::string& page : {student_page(student), class_page({two_items, {student}, 1})}) {
    CHECK(page.find("<script>alert") == std::string::npos);
    CHECK(page.find("\x1B") == std::string::npos);
    CHECK(page.find("&lt;script&gt;") != std::string::npos);
  }
}

TEST_CASE("a right picture takes no room on a page; a wrong one stands there once") {
  const Image should = ramps(800, 600);
  const Compared compared(should, ramps(800, 600, 3));
  Row row = compared.row;
  row.item = "03_image_texture";
  const std::string page =
      student_page(student_named("ada", {row, right_row("04_uv_conventions")}));
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.find("<img", at)) != std::string::npos; ++at) ++pictures;
  CHECK(pictures == 3);
  CHECK(page.size() < 300000);
}

// --- The program that builds and runs -----------------------------------------------------------

TEST_CASE("a line of results.tsv is read field by field") {
  const TaskResult result = task_result(
      "0-1\t03_image_texture\tbwrap\tok\tcrashed "
      "SIGSEGV\t0.12\t5.0\t/a\\\\b.png\t/e\t/h\t/i\t3\t4\tyes"
      "\ttwo\\nlines\\tand a tab");
  CHECK(result.run == "crashed SIGSEGV");
  CHECK(name_of(result.picture) == "/a\\b.png");
  CHECK(result.tests_run == "4");
  CHECK(result.cached);
  CHECK(result.note == "two\nlines\tand a tab");
  CHECK_THROWS_AS(static_cast<void>(task_result("too\tshort")), FileError);
}
