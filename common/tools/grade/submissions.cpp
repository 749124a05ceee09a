// What students handed in: whose folder it is, and where their chapters or pictures lie in it.
//
// Learning systems and students pack the same work in many ways: ada/03.png, ada/out/03_image.png,
// ada/texmap-main/chapters. So the folder is searched three levels deep; of several places the
// one nearest to the top counts.
#include "submissions.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <system_error>

#include "engine/measure/utf8.hpp"
#include "engine/system/file_error.hpp"
#include "safe_text.hpp"

namespace texmap::grade {
namespace {

namespace fs = std::filesystem;

constexpr int most_levels = 3;
constexpr std::size_t most_entries = 20000;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Folders in which no student's pictures lie, but perhaps other ones of the same names.
bool is_passed_over(const std::string& name) {
  static const std::set<std::string> others = {"__macosx",          "assets", "build",
                                               "cmake-build-debug", "common", "docs",
                                               "node_modules",      "tests"};
  return name.starts_with('.') || others.contains(lower(name));
}

/// The entries of a folder in the order of their names; none if it may not be read.
std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code error;
  for (fs::directory_iterator next(folder, error), end; !error && next != end;
       next.increment(error)) {
    entries.push_back(*next);
    if (entries.size() == most_entries) break;
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_real_folder(const fs::directory_entry& entry) {
  std::error_code error;
  return entry.symlink_status(error).type() == fs::file_type::directory;
}

bool has_chapters(const fs::path& folder) {
  const auto entries = entries_of(folder);
  return std::any_of(entries.begin(), entries.end(), [](const fs::directory_entry& entry) {
    const std::string name = name_of(entry.path().filename());
    return is_real_folder(entry) && name.size() > 3 && is_digit(name[0]) && is_digit(name[1]) &&
           name[2] == '_';
  });
}

bool is_code(const fs::path& file) {
  const std::string ending = lower(name_of(file.extension()));
  return ending == ".hpp" || ending == ".cpp";
}

/// Whether this is the folder of a chapter that is graded. The name alone does not say so: a
/// student's folder, or one of pictures, can have it. So there must be code in it.
bool is_chapter(const std::vector<Item>& items, const fs::directory_entry& folder) {
  const std::string name = name_of(folder.path().filename());
  const auto asked = std::find_if(items.begin(), items.end(), [&name](const Item& item) {
    return name == item.name ||
           (!item.exercise.empty() && item.exercise.find('/' + name + '/') != std::string::npos);
  });
  if (asked == items.end()) return false;
  const auto entries = entries_of(folder);
  return std::any_of(entries.begin(), entries.end(), [](const fs::directory_entry& entry) {
    return is_code(entry.path()) ||
           (is_real_folder(entry) && entry.path().filename() == "exercises");
  });
}

/// The only number in a name; empty if there is none, or a second one.
std::string only_number(const std::string& name) {
  constexpr const char* digits = "0123456789";
  const std::size_t begin = std::min(name.find_first_of(digits), name.size());
  const std::size_t end = std::min(name.find_first_not_of(digits, begin), name.size());
  const bool another = name.find_first_of(digits, end) != std::string::npos;
  return another ? "" : name.substr(begin, end - begin);
}

constexpr int no_fit = 4;

/// How well a file's name says that it is an item's picture: 0 best, then 1, 2, 3.
int misfit(const std::string& stem, const Item& item) {
  std::string name = lower(stem);
  if (name == lower(item.name)) return 0;
  for (const std::string_view word : {"chapter", "kapitel"}) {
    if (!name.starts_with(word)) continue;
    name.erase(0, word.size());
    name.erase(0, name.find_first_not_of(" _-"));
  }
  const std::string number = item.number;
  const std::string shorter = number.starts_with('0') ? number.substr(1) : number;
  if (name == number || name == shorter) return 1;
  const bool goes_on = name.size() > number.size() && name.starts_with(number) &&
                       !is_digit(name[number.size()]) &&
                       (name[number.size()] != '.' || name.size() == number.size() + 1 ||
                        !is_digit(name[number.size() + 1]));
  if (goes_on) return 2;
  const std::string only = only_number(name);
  return only == number || only == shorter ? 3 : no_fit;
}

/// What one folder holds.
struct Search {
  const std::vector<Item>& items;
  fs::path checkout;
  struct Candidate {
    fs::path path;
    int misfit = no_fit;
    int level = 0;
    bool is_link = false;
  };
  std::map<std::string, std::vector<Candidate>> candidates = {};
  std::size_t entries = 0;
  bool cut = false;
  std::vector<std::string> seen = {};  ///< names of pictures that fit nothing
  std::string code = {};               ///< the first file of code outside a chapter

  /// Searches a folder and those in it, down to so many levels.
  void look_into(const fs::path& folder, int level, int levels) {
    std::vector<fs::path> below;
    bool holds_chapters = false;
    for (const fs::directory_entry& entry : entries_of(folder)) {
      if (++entries > most_entries) {
        cut = true;
        return;
      }
      const std::string name = name_of(entry.path().filename());
      if (is_real_folder(entry)) {
        if (lower(name) == "chapters" && has_chapters(entry.path())) {
          // The builder knows chapters/ in small letters; else it gets the folder itself.
          if (checkout.empty()) checkout = name == "chapters" ? folder : entry.path();
        } else if (is_chapter(items, entry)) {
          holds_chapters = true;
        } else if (!is_passed_over(name)) {
          below.push_back(entry.path());
        }
      }
      take_picture(entry, level);
      if (code.empty() && is_code(entry.path())) code = name_of(entry.path().filename());
    }
    if (checkout.empty() && holds_chapters) checkout = folder;
    if (level == levels || !checkout.empty()) return;
    for (const fs::path& next : below) look_into(next, level + 1, levels);
  }

  void take_picture(const fs::directory_entry& entry, int level) {
    if (lower(name_of(entry.path().extension())) != ".png") return;
    std::error_code error;
    const bool is_link = entry.symlink_status(error).type() == fs::file_type::symlink;
    const std::string stem = name_of(entry.path().stem());
    bool fits = false;
    for (const Item& item : items) {
      if (!item.exercise.empty()) continue;
      const int fit = misfit(stem, item);
      if (fit == no_fit) continue;
      candidates[item.name].push_back({entry.path(), fit, level, is_link});
      fits = true;
    }
    if (!fits) seen.push_back(name_of(entry.path().filename()));
  }

  [[nodiscard]] bool has_work() const {
    return !checkout.empty() || !candidates.empty() || !seen.empty() || !code.empty();
  }

  /// What lies there under other names, at most so many pictures.
  [[nodiscard]] std::string what_else(std::size_t most) const {
    std::string words;
    for (std::size_t i = 0; i < seen.size() && i < most; ++i)
      words.append(i == 0 ? "" : ", ").append(clean(shown_name(seen[i])));
    if (seen.size() > most)
      words.append(" and ").append(counted(seen.size() - most, "picture")) += " more";
    if (!code.empty()) {
      words.append(words.empty() ? "" : "; ").append(clean(shown_name(code)));
      words += ", but not in a chapter's folder";
    }
    return words;
  }

  /// Of the candidates the one whose name fits best, then the one nearest to the top.
  [[nodiscard]] std::map<std::string, FoundPicture> pictures() const {
    std::map<std::string, FoundPicture> result;
    for (const auto& [item, all] : candidates) {
      const auto best =
          std::min_element(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
            return std::pair(a.misfit, a.level) < std::pair(b.misfit, b.level);
          });
      const auto rival = std::find_if(all.begin(), all.end(), [&best](const Candidate& other) {
        return other.path != best->path && other.misfit == best->misfit && best->misfit >= 2 &&
               other.level == best->level;
      });
      FoundPicture& found = result[item];
      found.path = best->path;
      if (best->is_link) {
        found.why_not = name_of(best->path.filename()) + " is a link; links are not followed";
      } else if (rival != all.end()) {
        found.why_not = name_of(best->path.filename()) + " or " + name_of(rival->path.filename()) +
                        "? Name the picture " + item + ".png";
      }
    }
    return result;
  }
};

/// What a folder and those in it hold, down to so many levels.
Search searched(const std::vector<Item>& items, const fs::path& folder, int levels) {
  Search search{items, {}, {}};
  search.look_into(folder, 0, levels);
  return search;
}

/// Has a tab, or what Python takes for the end of a line.
bool breaks_line(std::string_view name) {
  while (!name.empty()) {
    const char32_t c = take_character(name);
    if ((c >= 0x09 && c <= 0x0D) || (c >= 0x1C && c <= 0x1E) || c == 0x85 || c == 0x2028 ||
        c == 0x2029) {
      return true;
    }
  }
  return false;
}

Submission submission_of(const std::vector<Item>& items, const fs::path& path,
                         const std::string& folder) {
  Submission result{shown_name(folder), shown_name(name_of(path.filename())), path, {}, {}, ""};
  std::error_code error;
  if (fs::directory_iterator(path, error); error) {
    result.note = "the folder cannot be read: " + error.message();
    return result;
  }
  const Search search = searched(items, path, most_levels);
  result.checkout = search.checkout;
  if (search.checkout.empty()) {
    result.pictures = search.pictures();
    result.seen = search.what_else(4);
  }
  if (breaks_line(name_of(result.checkout))) {
    // The plan of tasks is a table of lines.
    result.checkout.clear();
    result.note = "the folder's name has a tab or a line end; rename it";
  }
  if (search.cut) {
    result.note = "the folder has more than " + std::to_string(most_entries) +
                  " files; not all were looked at";
  }
  return result;
}

/// A folder in a student's own tree, not a student.
bool is_part_of_one(const std::vector<Item>& items, const fs::directory_entry& folder) {
  const std::string name = lower(name_of(folder.path().filename()));
  if (name == "out" || name == "chapters" || is_passed_over(name) || is_chapter(items, folder))
    return true;
  return std::any_of(items.begin(), items.end(),
                     [&name](const Item& item) { return name == lower(item.name); });
}

/// The one folder that a site, or a student, packs all in.
bool is_packing(const std::string& folder) {
  static const std::set<std::string> words = {"bilder",   "homework", "hw",         "images",
                                              "pictures", "png",      "screenshots"};
  const std::string name = lower(folder);
  return words.contains(name) || name.ends_with("-main") || name.ends_with("-master") ||
         name.find("texmap") != std::string::npos || name.find("texture") != std::string::npos;
}

/// A folder that was named: the folders in it that may be students', and what speaks against that.
struct Structure {
  std::vector<fs::directory_entry> folders = {};
  std::size_t with_work = 0;  ///< of these folders
  std::string own_picture = {};
  bool has_chapters = false;

  Structure(const std::vector<Item>& items, const fs::path& folder) {
    for (const fs::directory_entry& entry : entries_of(folder)) {
      if (!entry.is_directory() || is_part_of_one(items, entry)) continue;
      folders.push_back(entry);
      if (is_real_folder(entry) && searched(items, entry.path(), most_levels - 1).has_work())
        ++with_work;
    }
    for (const fs::path& place : {folder, folder / "out"}) {
      if (!fs::is_directory(place)) continue;
      const Search search = searched(items, place, 0);
      has_chapters = has_chapters || !search.checkout.empty();
      if (!search.candidates.empty() && own_picture.empty())
        own_picture = name_of(search.candidates.begin()->second[0].path.filename());
    }
  }

  [[nodiscard]] bool is_packed() const {
    return folders.size() == 1 && is_packing(name_of(folders[0].path().filename()));
  }

  /// @param alone  no other folder was named
  [[nodiscard]] bool is_class(bool alone) const {
    if (folders.empty() || has_chapters) return false;
    if (!alone) return with_work > 1 && own_picture.empty();
    return own_picture.empty() ? !is_packed() : folders.size() > 1 && with_work > 0;
  }

  /// Both readings are possible.
  [[nodiscard]] bool is_unclear(bool as_class, bool alone) const {
    if (as_class) return with_work < 2 || !own_picture.empty();
    return with_work > (alone && !is_packed() && !has_chapters ? 0U : 1U);
  }
};

std::string remark_on(const std::string& folder, const Structure& structure, bool as_class) {
  std::string remark = clean(shown_name(folder));
  if (!as_class) {
    return remark +
           " is graded as one student's folder; --class grades each folder in it as a student's";
  }
  remark.append(" is graded as a class of ").append(counted(structure.folders.size(), "student"));
  if (!structure.own_picture.empty())
    remark.append("; ").append(clean(shown_name(structure.own_picture))).append(" is nobody's");
  return remark.append("; --one grades it as one student's folder");
}

}  // namespace

Found find_submissions(const std::vector<fs::path>& folders, const std::vector<Item>& items,
                       Reading reading) {
  Found found;
  std::vector<Submission>& all = found.submissions;
  for (const fs::path& folder : folders) {
    const fs::path path = fs::canonical(folder);
    const Structure structure(items, path);
    const bool alone = folders.size() == 1;
    const bool as_class =
        reading == Reading::by_structure ? structure.is_class(alone) : reading == Reading::students;
    if (reading == Reading::by_structure && structure.is_unclear(as_class, alone))
      found.remarks.push_back(remark_on(name_of(folder), structure, as_class));
    if (!as_class) {
      all.push_back(submission_of(items, path, name_of(folder)));
      continue;
    }
    for (const fs::directory_entry& entry : structure.folders) {
      const std::string name = name_of(folder / entry.path().filename());
      if (is_real_folder(entry)) {
        all.push_back(submission_of(items, entry.path(), name));
      } else {
        all.push_back({shown_name(name),
                       shown_name(name_of(entry.path().filename())),
                       entry.path(),
                       {},
                       {},
                       "the folder is a link; links are not followed"});
      }
    }
  }
  return found;
}

std::vector<std::string> page_names(const std::vector<Submission>& submissions) {
  std::set<std::string> taken = {"index"};
  std::map<std::string, int> last_number;
  std::vector<std::string> pages;
  pages.reserve(submissions.size());
  for (const Submission& submission : submissions) {
    const std::string name = file_name_of(submission.name);
    std::string page = name;
    int& number = last_number.try_emplace(lower(name), 1).first->second;
    while (!taken.insert(lower(page)).second) page = name + "-" + std::to_string(++number);
    pages.push_back(page);
  }
  return pages;
}

}  // namespace texmap::grade
