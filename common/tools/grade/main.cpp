// The program grade: students' pictures and checkouts become tables and pages.
#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "builder.hpp"
#include "class_pages.hpp"
#include "engine/app/command_line.hpp"
#include "engine/app/run_guarded.hpp"
#include "engine/system/system.hpp"
#include "folder_lock.hpp"
#include "formats.hpp"
#include "grades.hpp"
#include "known_words.hpp"
#include "picture_verdict.hpp"
#include "safe_text.hpp"
#include "submissions.hpp"
#include "tables.hpp"

namespace {

using namespace texmap;
using namespace texmap::grade;
namespace fs = std::filesystem;

volatile std::sig_atomic_t asked_to_stop = 0;
void stop(int /*signal*/) { asked_to_stop = 1; }
bool is_stopped() { return asked_to_stop != 0; }

struct Request {
  std::vector<std::string> folders;
  std::string chapters, out = TEXMAP_TREE "/out/grades",
                        builder = TEXMAP_TREE "/common/tools/grade/build_and_run.py";
  std::string work = TEXMAP_TREE "/build/grade";
  Format format = Format::none;
  bool no_tests = false, no_second_picture = false, trust_students = false;
  bool one = false, each = false;
  int seconds = 0, megabytes = 2048, jobs = 0;

  void declare(CommandLine& line) {
    line.positionals("DIR", folders,
                     "a student's checkout or pictures, or a folder of such folders");
    line.flag("--one", one, "each DIR is one student's, whatever is in it");
    line.flag("--class", each, "each folder in a DIR is a student's, whatever lies next to it");
    line.text("--chapters", "01,02.1", chapters,
              "grade these chapters and exercises only; exercises: all of them");
    line.flag("--no-tests", no_tests, "compare the pictures, do not run the chapters' tests");
    line.flag("--no-second-picture", no_second_picture,
              "do not draw each chapter a second time with other settings");
    line.whole("--seconds", seconds, 0, 86400,
               "processor time for a program; 0: ten times what the instructor's takes");
    line.whole("--megabytes", megabytes, 64, 1048576, "memory for a program");
    line.whole("--jobs", jobs, 0, 1024, "programs at the same time; 0: one for each processor");
    line.flag("--trust-students", trust_students,
              "run checkouts even where nothing can contain them");
    line.choice<Format>("--format", format,
                        {{"none", Format::none},
                         {"gradescope", Format::gradescope},
                         {"classroom", Format::classroom},
                         {"junit", Format::junit}},
                        "write each student's grades for a learning system, too");
    line.text("--out", "FOLDER", out, "where grades.csv, points.csv and index.html go");
    line.text("--work", "FOLDER", work, "where checkouts are built; kept for the next time");
    line.text("--builder", "FILE", builder, "the program that builds and runs checkouts");
    line.statuses(
        "0 all were graded, whatever the grades; 2 wrong command line, or nothing could be graded; "
        "130 ended by Ctrl-C, with what was done until then");
  }
};

/// The exercises of a chapter, by number. A student's file may have another name behind it.
std::vector<Item> exercises_of(const std::string& chapter) {
  const fs::path tree = TEXMAP_TREE;
  const fs::path below = fs::path("chapters") / path_of(chapter) / "exercises";
  std::map<std::string, Item> found;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(tree / below, none)) {
    const std::string file = name_of(entry.path().filename());
    const std::string number = chapter.substr(0, 2) + "." + file.substr(0, 1);
    if (file.find('_') == 1 && file.ends_with(".hpp"))
      found[number] = {number, number, {}, false, name_of(below / path_of(file))};
  }
  std::vector<Item> items;
  items.reserve(found.size());
  for (auto& [number, item] : found) items.push_back(std::move(item));
  return items;
}

/// All chapters, each with its exercises behind it.
std::vector<Item> all_items() {
  const fs::path tree = TEXMAP_TREE;
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(tree / "chapters")) {
    if (fs::exists(entry.path() / "lesson.hpp")) names.insert(name_of(entry.path().filename()));
  }
  std::vector<Item> items;
  for (const std::string& name : names) {
    const fs::path golden = tree / "tests/golden" / path_of(name + ".png");
    if (fs::exists(golden)) {
      const fs::path suite = tree / "tests/chapters" / path_of("test_" + name + ".cpp");
      // The suite of 13 measures times, and none of that counts.
      items.push_back(
          {name, name.substr(0, 2), golden, !name.starts_with("13") && fs::exists(suite), ""});
    }
    for (Item& item : exercises_of(name)) items.push_back(std::move(item));
  }
  return items;
}

/// The items that `--chapters` names, by number or name; without it, the chapters.
std::vector<Item> chosen_items(const std::string& chapters) {
  std::vector<Item> all = all_items();
  if (chapters.empty()) {
    std::erase_if(all, [](const Item& item) { return !item.exercise.empty(); });
    return all;
  }
  std::vector<bool> chosen(all.size());
  for (std::size_t begin = 0; begin <= chapters.size();) {
    const std::size_t end = std::min(chapters.find(',', begin), chapters.size());
    std::string word = chapters.substr(begin, end - begin);
    begin = end + 1;
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    if (word.empty()) {
      throw UsageError("--chapters '" + chapters +
                       "' has a comma with nothing before or after it; such as 02,04 is right");
    }
    bool found = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool named = word == all[i].name || word == all[i].number ||
                         "0" + word == all[i].number ||
                         (word == "exercises" && !all[i].exercise.empty());
      if (!named) continue;
      chosen[i] = true;
      found = true;
    }
    if (!found) throw UsageError("there is no chapter '" + word + "', and no exercise");
  }
  std::vector<Item> items;
  items.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (chosen[i]) items.push_back(all[i]);
  }
  return items;
}

/// Students with pictures only, of whom all pictures of a chapter are compared in a row.
constexpr std::size_t students_at_once = 16;

/// One run: grades students a few at a time and writes what is known as soon as it is.
class Grading {
 public:
  explicit Grading(const Request& request)
      : request_(request), out_(path_of(request.out)), items_(chosen_items(request.chapters)) {}

  void run() {
    find_students();
    const FolderLock lock(out_, "--out");
    goldens_.reserve(items_.size());
    for (const Item& item : items_)
      goldens_.push_back(item.exercise.empty() ? read_golden(item.golden) : Golden());
    table_.open(out_ / "grades.csv", std::ios::binary | std::ios::trunc);
    append(grades_csv_head());

    for (std::size_t i = 0; i < submissions_.size(); i += students_at_once)
      compare_pictures_of(i, std::min(i + students_at_once, submissions_.size()));
    try {
      run_checkouts();
    } catch (const FileError&) {
      if (finished_ > 0) write_class();
      throw;
    }
    write_class();
  }

 private:
  void find_students() {
    std::vector<fs::path> folders;
    for (const std::string& typed : request_.folders) {
      const fs::path folder = path_of(typed);
      if (!fs::exists(folder)) throw UsageError("there is no folder '" + clean(typed) + "'");
      if (fs::is_directory(folder)) {
        folders.push_back(folder);
      } else {
        say("skipped, not a folder: " + clean(typed) + "\n");
      }
    }
    if (folders.empty()) throw FileError("there is nothing to grade: none of these is a folder");
    if (request_.one && request_.each) throw UsageError("--one and --class exclude each other");
    Found found = find_submissions(folders, items_,
                                   request_.one    ? Reading::one_student
                                   : request_.each ? Reading::students
                                                   : Reading::by_structure);
    for (const std::string& remark : found.remarks) say(remark + "\n");
    submissions_ = std::move(found.submissions);
    if (submissions_.empty()) throw FileError("there is nothing to grade: no folder is in there");
    const std::vector<std::string> pages = page_names(submissions_);
    class_.asked = submissions_.size();
    class_.items = items_;
    students_.resize(submissions_.size());
    done_.assign(submissions_.size(), std::vector<bool>(items_.size()));
    for (std::size_t i = 0; i < submissions_.size(); ++i) {
      const Submission& submission = submissions_[i];
      students_[i] = {submission.folder, submission.name, pages[i], submission.note, {}};
      students_[i].rows.resize(items_.size());
      has_checkouts_ = has_checkouts_ || !submission.checkout.empty();
    }
  }

  void compare(const fs::path& picture, std::size_t k, Row& row) {
    compare_with_golden(picture, goldens_[k], row, [&](const Image& is) {
      return words_.words_for(items_[k], is, goldens_[k].picture);
    });
  }

  /// Chapter by chapter, as a chapter's known mistakes take a while to load.
  void compare_pictures_of(std::size_t begin, std::size_t end) {
    for (std::size_t k = 0; k < items_.size(); ++k) {
      for (std::size_t i = begin; i < end; ++i) {
        if (submissions_[i].checkout.empty() && !is_stopped()) put(i, k, row_of_picture(i, k));
      }
    }
  }

  Row row_of_picture(std::size_t i, std::size_t k) {
    Row row;
    const auto found = submissions_[i].pictures.find(items_[k].name);
    if (!items_[k].exercise.empty()) {
      row.word = "missing";
      row.note = "there is no " + items_[k].exercise;
    } else if (found == submissions_[i].pictures.end()) {
      row.word = "missing";
      row.note = "there is no picture " + items_[k].name + ".png";
    } else if (!found->second.why_not.empty()) {
      row.word = "unreadable";
      row.note = found->second.why_not;
    } else {
      compare(found->second.path, k, row);
    }
    // In a class with checkouts all have the same points to reach.
    row.with_tests = has_checkouts_ && items_[k].has_tests && !request_.no_tests;
    if (row.with_tests && row.word.empty()) {
      row.word = "no tests";
      row.note = "the picture is right; the tests need the chapter's code";
    }
    if (row.word == "missing" && !submissions_[i].seen.empty())
      row.note.append("; found ").append(submissions_[i].seen);
    return row;
  }

  Row row_of_result(const TaskResult& result, std::size_t k) {
    Row row;
    row.build = result.build;
    row.run = result.run;
    row.containment = result.containment;
    row.cpu_seconds = result.cpu_seconds;
    row.limit_cpu_seconds = result.limit_cpu_seconds;
    row.note = result.note;
    row.cached = result.cached;
    // Where a chapter is missing or does not compile, the builder may not know about its tests.
    const bool has_tests = row.build == "ok" ? !result.tests_run.empty() : items_[k].has_tests;
    row.with_tests = !request_.no_tests && has_tests;
    row.tests_passed = std::strtoul(result.tests_passed.c_str(), nullptr, 10);
    row.tests_run = std::strtoul(result.tests_run.c_str(), nullptr, 10);
    if (result.build != "ok") {
      row.word = result.build;
      return row;
    }
    if (!items_[k].exercise.empty()) {
      // The note begins with the word: "u runs the other way: your map is mirrored; tried: ..."
      if (!row.tests_ok()) row.word = row.run == "ok" ? first_word(row.note) : row.run;
      return row;
    }
    if (result.picture.empty()) {
      row.word = "no picture";
    } else {
      compare(result.picture, k, row);
    }
    if (result.run != "ok") {
      row.word = result.run;
      row.picture_ok = false;
    } else if (!result.hidden_expected.empty()) {
      compare_hidden(result.hidden_picture, result.hidden_expected, row);
    }
    if (row.word.empty() && row.with_tests && !row.tests_ok()) row.word = "tests " + row.tests();
    return row;
  }

  void run_checkouts() {
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < submissions_.size(); ++i) {
      if (submissions_[i].checkout.empty()) continue;
      for (std::size_t k = 0; k < items_.size(); ++k) {
        std::string id = std::to_string(i);
        id.append("-").append(std::to_string(k));
        tasks.push_back({id, submissions_[i].checkout, items_[k].name});
      }
    }
    if (tasks.empty() || is_stopped()) return;
    Builder builder{path_of(request_.builder), TEXMAP_TREE, path_of(request_.work), {}};
    builder.options = {"--megabytes", std::to_string(request_.megabytes)};
    if (request_.jobs > 0) {
      builder.options.insert(builder.options.end(), {"--jobs", std::to_string(request_.jobs)});
    }
    if (request_.seconds > 0) {
      builder.options.insert(builder.options.end(),
                             {"--seconds", std::to_string(request_.seconds)});
    }
    if (request_.no_tests) builder.options.emplace_back("--no-tests");
    if (request_.no_second_picture) builder.options.emplace_back("--no-hidden");
    if (request_.trust_students) builder.options.emplace_back("--trust-students");
    std::size_t ended = 0;
    bool warned = false;
    builder.run(
        tasks,
        [&](const TaskResult& result) {
          std::size_t i = 0, k = 0;
          std::sscanf(result.id.c_str(), "%zu-%zu", &i, &k);  // as it was made above
          if (result.containment == "none" && !warned) {
            clear_progress();
            print(std::string(not_contained) + "\n");
            warned = true;
          }
          put(i, k, row_of_result(result, k));
          progress(std::to_string(++ended) + " of " + std::to_string(tasks.size()) +
                   " done: " + clean(students_[i].name) + " " + items_[k].number);
        },
        is_stopped);
  }

  /// Keeps a row; with the last one of a student, writes the student's page.
  void put(std::size_t i, std::size_t k, Row row) {
    Student& student = students_[i];
    row.item = items_[k].name;
    row.exercise = items_[k].exercise;
    if (row.word.empty()) row.word = "ok";
    append(grades_csv_line(student, row));
    student.rows[k] = std::move(row);
    done_[i][k] = true;
    if (std::find(done_[i].begin(), done_[i].end(), false) == done_[i].end()) finish(i);
  }

  void finish(std::size_t i) {
    Student& student = students_[i];
    ++finished_;
    if (student.has_page())
      write_text_atomically(out_ / path_of(student.page + ".html"), student_page(student));
    for (Row& row : student.rows) row.shown.reset();  // a class has thousands
    write_format(student);
    clear_progress();
    print(line_of(student));
  }

  /// In words, if nothing is there of what was asked for.
  [[nodiscard]] std::string nothing_of(const Student& student) const {
    const bool missing = std::all_of(student.rows.begin(), student.rows.end(),
                                     [](const Row& row) { return row.word == "missing"; });
    if (!missing) return "";
    const Submission& submission =
        submissions_[static_cast<std::size_t>(&student - students_.data())];
    if (!student.note.empty()) return clean(student.note);
    if (!submission.checkout.empty()) return "nothing of what was asked for is in its chapters";
    if (!submission.seen.empty()) return "missing; found " + submission.seen;
    return "no chapter and no picture found";
  }

  [[nodiscard]] std::string line_of(const Student& student) const {
    std::string wrong = nothing_of(student);
    const bool by_item = wrong.empty();
    for (std::size_t k = 0; k < items_.size() && by_item; ++k) {
      const Row& row = student.rows[k];
      if (row.right()) continue;
      wrong.append(wrong.empty() ? "" : ", ").append(items_[k].number).append(" ");
      wrong += clean(row.word);
    }
    std::string line = "[" + std::to_string(finished_) + "/" + std::to_string(class_.asked) + "]";
    line = padded(line, 10) +
           padded(std::to_string(student.points()) + " of " + std::to_string(student.of()), 10);
    line += padded(clean(student.name), 24) + " " + (wrong.empty() ? "all right" : wrong);
    return line + "\n";
  }

  void write_format(const Student& student) const {
    const bool alone = class_.asked == 1;
    const auto write = [&](const std::string& name, const std::string& content) {
      write_text_atomically(out_ / path_of(alone ? name : student.page + "." + name), content);
    };
    switch (request_.format) {
      case Format::none:
        break;
      case Format::gradescope:
        write("results.json", gradescope_json(student));
        break;
      case Format::classroom:
        write("classroom.json", classroom_json(student));
        print(classroom_notices(student));
        break;
      case Format::junit:
        write("junit.xml", junit_xml(student));
        break;
    }
  }

  /// The tables and the index of all that is done.
  void write_class() {
    clear_progress();
    for (std::size_t i = 0; i < students_.size(); ++i) {
      Student student = students_[i];
      student.rows.clear();
      for (std::size_t k = 0; k < items_.size(); ++k) {
        if (done_[i][k]) student.rows.push_back(students_[i].rows[k]);
      }
      if (!student.rows.empty()) class_.students.push_back(std::move(student));
    }
    table_.close();
    write_text_atomically(out_ / "grades.csv", grades_csv(class_));
    write_text_atomically(out_ / "points.csv", points_csv(class_));
    write_text_atomically(out_ / "index.html", class_page(class_));
    print("Look at " + name_of(out_ / "index.html") + "\n");
  }

  void append(const std::string& text) {
    table_ << text;
    if (!table_.flush()) throw FileError("cannot write '" + name_of(out_ / "grades.csv") + "'");
  }

  static void say(const std::string& text) { std::fputs(text.c_str(), stderr); }
  void progress(const std::string& what) const {
    if (watched_) say("\r\033[K" + what);
  }
  void clear_progress() const { progress(""); }

  const Request& request_;
  fs::path out_;
  std::vector<Item> items_;
  std::vector<Golden> goldens_;
  KnownWords words_{program_folder() / "draw_mistakes", program_folder() / "../mistakes",
                    is_stopped};
  std::vector<Submission> submissions_;
  std::vector<Student> students_;        // in the order of the submissions
  std::vector<std::vector<bool>> done_;  // which of their rows are there
  Class class_;
  std::size_t finished_ = 0;
  bool has_checkouts_ = false;
  std::ofstream table_;
  bool watched_ = stderr_is_watched();
};

}  // namespace

int main(int argc, char** argv) {
  texmap::CommandLine line("grade", "students' chapters against the golden pictures");
  Request request;
  request.declare(line);
  bool refused = false;
  const int status = texmap::run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    std::signal(SIGINT, stop);
    std::signal(SIGTERM, stop);
    try {
      Grading(request).run();
    } catch (const AlreadySaid&) {
      refused = true;
    }
  });
  if (status != 0 || refused) return 2;
  return is_stopped() ? 130 : 0;
}
