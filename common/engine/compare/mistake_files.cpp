// Pictures of known mistakes in folders, and the chapters' right ones.
#include <algorithm>
#include <sstream>
#include <system_error>

#include "engine/compare/known_mistakes.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"

namespace texmap {
namespace {

constexpr std::uint64_t max_file_of_words = 1U << 20;

}  // namespace

std::vector<WrongPicture> load_wrong_pictures(const std::filesystem::path& folder) {
  const std::filesystem::path table = folder / "mistakes.txt";
  const std::vector<std::uint8_t> bytes =
      with_name("cannot read", table, [&] { return read_file(table, max_file_of_words); });
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::vector<WrongPicture> wrong;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos)
      throw FileError("cannot read '" + name_of(table) + "': a line without a tab: " + line);
    const std::filesystem::path file = path_of(line.substr(0, tab));
    wrong.push_back(
        {name_of(file.stem()), line.substr(tab + 1), load_image(folder / file.filename())});
  }
  return wrong;
}

bool has_drawn_mistakes(const std::filesystem::path& folder, const Image& right) {
  if (!exists(folder / "mistakes.txt")) return false;
  const std::filesystem::path drawn = folder / "right.png";
  return !exists(drawn) || is_same_picture(load_image(drawn), right);
}

std::vector<WrongPicture> known_mistakes(const std::filesystem::path& folder, const Image& right) {
  std::vector<WrongPicture> known;
  if (has_drawn_mistakes(folder, right)) known = load_wrong_pictures(folder);
  for (WrongPicture& one : mistakes_of_the_whole(right)) {
    if (std::none_of(known.begin(), known.end(),
                     [&](const auto& drawn) { return drawn.name == one.name; }))
      known.push_back(std::move(one));
  }
  return known;
}

std::vector<WrongPicture> right_pictures(const std::filesystem::path& folder) {
  std::vector<WrongPicture> right;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::string name = name_of(entry.path().stem());
    if (entry.path().extension() != ".png") continue;
    try {
      right.push_back(
          {name, "a picture of chapter " + name.substr(0, 2), load_image(entry.path())});
    } catch (const FileError&) {  // less is known
    }
  }
  std::sort(right.begin(), right.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return right;
}

void save_wrong_pictures(std::span<const WrongPicture> wrong, const std::filesystem::path& folder) {
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);  // if it fails, writing says so
  std::string table;
  for (const WrongPicture& one : wrong) {
    save_png(one.picture, folder / (one.name + ".png"));
    table.append(one.name).append(".png\t").append(one.words).append("\n");
  }
  const std::filesystem::path file = folder / "mistakes.txt";
  with_name("cannot write", file, [&] { write_text_atomically(file, table); });
}

}  // namespace texmap
