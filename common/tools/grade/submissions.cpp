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

/// How well a file's name says that it is an item's picture: 0 best, 1, 2; 3 not at all.
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
  return goes_on ? 2 : 3;
}

/// What one folder holds.
struct Search {
  const std::vector<Item>& items;
  fs::path checkout;
  struct Candidate {
    fs::path path;
    int misfit = 3;
    int level = 0;
    bool is_link = false;
  };
  std::map<std::string, std::vector<Candidate>> candidates = {};
  std::size_t entries = 0;
  bool cut = false;

  /// Searches a folder and those in it, down to so many levels.
  void look_into(const fs::path& folder, int level, int levels) {
    std::vector<fs::path> below;
    for (const fs::directory_entry& entry : entries_of(folder)) {
      if (++entries > most_entries) {
        cut = true;
        return;
      }
      const std::string name = name_of(entry.path().filename());
      if (is_real_folder(entry)) {
        if (lower(name) == "chapters" && has_chapters(entry.path())) {
          if (checkout.empty()) checkout = folder;
        } else if (!is_passed_over(name)) {
          below.push_back(entry.path());
        }
      }
      take_picture(entry, level);
    }
    if (level == levels || !checkout.empty()) return;
    for (const fs::path& next : below) look_into(next, level + 1, levels);
  }

  void take_picture(const fs::directory_entry& entry, int level) {
    if (lower(name_of(entry.path().extension())) != ".png") return;
    std::error_code error;
    const bool is_link = entry.symlink_status(error).type() == fs::file_type::symlink;
    const std::string stem = name_of(entry.path().stem());
    for (const Item& item : items) {
      if (!item.exercise.empty()) continue;
      const int fit = misfit(stem, item);
      if (fit < 3) candidates[item.name].push_back({entry.path(), fit, level, is_link});
    }
  }

  [[nodiscard]] bool found() const { return !checkout.empty() || !candidates.empty(); }

  /// Of the candidates the one whose name fits best, then the one nearest to the top.
  [[nodiscard]] std::map<std::string, FoundPicture> pictures() const {
    std::map<std::string, FoundPicture> result;
    for (const auto& [item, all] : candidates) {
      const auto best =
          std::min_element(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
            return std::pair(a.misfit, a.level) < std::pair(b.misfit, b.level);
          });
      const auto rival = std::find_if(all.begin(), all.end(), [&best](const Candidate& other) {
        return other.path != best->path && other.misfit == best->misfit && best->misfit == 2 &&
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

bool has_own_work(const std::vector<Item>& items, const fs::path& folder) {
  if (searched(items, folder, 0).found()) return true;
  const fs::path out = folder / "out";
  return fs::is_directory(out) && searched(items, out, 0).found();
}

Submission submission_of(const std::vector<Item>& items, const fs::path& path,
                         const std::string& folder) {
  Submission result{folder, name_of(path.filename()), path, {}, {}, ""};
  std::error_code error;
  if (fs::directory_iterator(path, error); error) {
    result.note = "the folder cannot be read: " + error.message();
    return result;
  }
  const Search search = searched(items, path, most_levels);
  result.checkout = search.checkout;
  if (search.checkout.empty()) result.pictures = search.pictures();
  if (name_of(result.checkout) != clean(name_of(result.checkout))) {
    // The plan of tasks is a table of lines.
    result.checkout.clear();
    result.note = "the folder's name has control characters; rename it";
  }
  if (search.cut) {
    result.note = "the folder has more than " + std::to_string(most_entries) +
                  " files; not all were looked at";
  }
  return result;
}

/// The folders in a class, if it is one.
std::vector<fs::directory_entry> folders_of_class(const std::vector<Item>& items,
                                                  const fs::path& folder) {
  if (has_own_work(items, folder)) return {};
  std::vector<fs::directory_entry> all;
  int with_work = 0;
  for (const fs::directory_entry& entry : entries_of(folder)) {
    if (!entry.is_directory() || is_passed_over(name_of(entry.path().filename()))) continue;
    all.push_back(entry);
    const bool found =
        is_real_folder(entry) && searched(items, entry.path(), most_levels - 1).found();
    with_work += found ? 1 : 0;
  }
  return with_work > 1 ? all : std::vector<fs::directory_entry>();
}

}  // namespace

std::vector<Submission> find_submissions(const std::vector<fs::path>& folders,
                                         const std::vector<Item>& items) {
  std::vector<Submission> all;
  for (const fs::path& folder : folders) {
    const fs::path path = fs::canonical(folder);
    const std::vector<fs::directory_entry> in_class = folders_of_class(items, path);
    if (in_class.empty()) all.push_back(submission_of(items, path, name_of(folder)));
    for (const fs::directory_entry& entry : in_class) {
      const std::string name = name_of(folder / entry.path().filename());
      if (is_real_folder(entry)) {
        all.push_back(submission_of(items, entry.path(), name));
      } else {
        all.push_back({name,
                       name_of(entry.path().filename()),
                       entry.path(),
                       {},
                       {},
                       "the folder is a link; links are not followed"});
      }
    }
  }
  return all;
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
