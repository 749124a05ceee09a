// Meshes from files in OBJ format (Wavefront).
#include "engine/files/read_obj.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/cut_polygon.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t most_skipped = 16;  // words that are listed
constexpr Uv<double> no_uv{std::numeric_limits<double>::quiet_NaN(), 0};

bool has_uv(const Uv<double>& uv) { return !std::isnan(uv.u); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// True if a line goes on in the next. A comment ends with its line; a name may end with the sign.
bool goes_on(std::string_view line) {
  if (line.empty() || line.back() != '\\' || line.find('#') != line.npos) return false;
  const char first = *std::find_if_not(line.begin(), line.end(), is_blank);
  const char before = line.size() > 1 ? line[line.size() - 2] : ' ';
  return first == 'v' || first == 'f' || is_blank(before);
}

// The words of a line up to a comment; 1.#QNAN has none.
void split_words(std::string_view line, Words& words) {
  words.clear();
  bool in_comment = false;
  std::size_t first = 0;
  const auto end_word = [&](std::size_t end) {
    if (end > first && !in_comment) words.push_back(line.substr(first, end - first));
    first = end + 1;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c > '#') continue;
    if (c == '#' && i > 0 && line[i - 1] == '.') continue;
    if (c == ' ' || c == '\t' || c == '#') end_word(i);
    if (c == '#') in_comment = true;
    if (c == '\r') throw FileError("it has a carriage return inside: save it with line feeds");
    if (c == '\0' || c == '\f' || c == '\v')
      throw FileError("it has a byte that is not text: save it as UTF-8");
  }
  end_word(line.size());
}

std::string in_small_letters(std::string_view word) {
  std::string lower;
  for (const char c : word.substr(0, 24)) lower += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return lower;
}

// As programs write the result of 0 / 0: nan, -nan(ind), 1.#QNAN, -1.#IND00.
bool is_nan(std::string_view word) {
  const std::string lower = in_small_letters(word);
  return lower.find("nan") != lower.npos || lower.find("#ind") != lower.npos;
}

double coordinate(std::string_view word) {
  const std::optional<double> number = read_decimal(word);
  if (!number && is_nan(word)) throw FileError(quoted(word) + " is not a number (NaN)");
  if (!number) throw FileError(quoted(word) + " is not a finite decimal number");
  if (!(std::abs(*number) <= max_mesh_number))
    throw FileError(quoted(word) + " is too large: numbers may reach 1e30");
  return *number;
}

// From the index in a file, which counts from 1, or from the last entry with -1, to that in memory.
int index_of(std::string_view word, std::size_t entries, const char* what) {
  long long index = 0;
  const char* const end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, index);
  if (error == std::errc::result_out_of_range)
    throw FileError("the index " + quoted(word) + " is too large");
  if (error != std::errc() || stopped != end)
    throw FileError(quoted(word) + " is not an index, a whole number");
  const auto count = static_cast<long long>(entries);
  const long long from_zero = index < 0 ? count + index : index - 1;
  if (index == 0) throw FileError("the index 0: indices begin at 1");
  if (from_zero < 0 || from_zero >= count) {
    throw FileError("the index " + quoted(word) + ", but only " + std::to_string(count) + " " +
                    what + " come before it");
  }
  return static_cast<int>(from_zero);
}

// A name with its blanks: from a word to the end of the line, or to a comment, a # between blanks:
// names may end with #1. Some programs put names into quotes.
std::string_view name_from(std::string_view line, std::string_view word) {
  std::string_view name = line.substr(static_cast<std::size_t>(word.data() - line.data()));
  for (std::size_t i = 1; i < name.size(); ++i) {
    if (name[i] == '#' && is_blank(name[i - 1]) && (i + 1 == name.size() || is_blank(name[i + 1])))
      name = name.substr(0, i);
  }
  while (is_blank(name.back())) name.remove_suffix(1);
  if (name.size() > 2 && name.front() == '"' && name.back() == '"')
    name = name.substr(1, name.size() - 2);
  return name;
}

// The name behind a keyword; it may begin with #. Empty if there is none.
std::string_view name_behind(std::string_view keyword, std::string_view line) {
  line.remove_prefix(static_cast<std::size_t>(keyword.data() - line.data()) + keyword.size());
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  const bool is_comment = line.starts_with('#') && (line.size() == 1 || is_blank(line[1]));
  return line.empty() || is_comment ? std::string_view() : name_from(line, line);
}

// Calls read(line, number) for each line; an error gets its number. A line that goes on is one.
template <class Read>
void for_each_line(std::string_view text, const Read& read) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, 3) == byte_order_mark) text.remove_prefix(3);
  std::string joined;
  int number = 0;
  const auto next_line = [&] {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));  // many files end without a new line
    if (end + joined.size() > max_mesh_line)
      throw FileError("it is longer than " + std::to_string(max_mesh_line) + " bytes");
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    return line;
  };
  while (!text.empty()) {
    const int first = number + 1;
    try {
      std::string_view line = next_line();
      if (goes_on(line)) {
        joined = line;
        do {
          joined.back() = ' ';
          joined += next_line();
        } while (goes_on(joined));
        line = joined;
      }
      read(line, first);
      joined.clear();
    } catch (const FileError& error) {
      throw FileError("line " + std::to_string(first) + ": " + error.what());
    }
  }
}

class ObjReader {
 public:
  ObjFile take() {
    std::string list;
    for (const auto& [kind, number] : skipped_)
      list += (list.empty() ? "" : ", ") + kind + " (line " + std::to_string(number) + ")";
    if (!list.empty()) {
      note("skipped the lines that are no textured triangles: " + list +
           (skipped_.size() < most_skipped ? "" : ", and perhaps others"));
    }
    note(colored_, "points with a color of their own", "; it is not drawn");
    note(without_uv_, "faces without texture coordinates", "; they have a plain color");
    note(without_normals_, "faces without their normals (vn)", "; they are flat");
    note(crossing_,
         looks_ > 0 ? "polygons that cross themselves"
                    : "polygons that cross themselves or are too large",
         "; their triangles cover more than they do");
    if (!result_.material_names.empty()) end_material();
    if (!result_.normals.triangles.empty())
      result_.normals.triangles.resize(result_.mesh.triangles.size());
    return std::move(result_);
  }

  void read_line(std::string_view line, int number) {
    number_ = number;
    split_words(line, words_);
    if (words_.empty()) return;
    const std::string_view kind = words_.front();
    if (kind == "v") return add_point();
    if (kind == "vt") return add_uv();
    if (kind == "f") return add_face();
    if (kind == "vn") return add_normal();
    const std::string name(name_behind(kind, line));
    if (kind == "usemtl") return use_material(name);
    if (kind == "mtllib" && result_.libraries.size() < max_mesh_libraries)
      result_.libraries.push_back(name);
    constexpr std::string_view ignored[] = {"o", "g", "s", "mg", "mtllib"};
    if (std::find(std::begin(ignored), std::end(ignored), kind) == std::end(ignored)) skip(kind);
  }

 private:
  // How many faces or points, and the line of the first.
  struct Counted {
    int number = 0, first = 0;
  };
  void count(Counted& some) const {
    if (some.number++ == 0) some.first = number_;
  }
  void note(std::string sentence) { result_.notes.push_back(std::move(sentence)); }
  void note(const Counted& some, const char* what, const char* so) {
    if (some.number > 0)
      note(text("%s: %d, the first in line %d%s", what, some.number, some.first, so));
  }

  // Another statement of the format, or a program's own.
  void skip(std::string_view kind) {
    const std::string shown = quoted(kind);
    const auto is_shown = [&](const auto& known) { return known.first == shown; };
    if (skipped_.size() < most_skipped && std::none_of(skipped_.begin(), skipped_.end(), is_shown))
      skipped_.emplace_back(shown, number_);
  }

  void add_point() {
    const std::size_t numbers = words_.size() - 1;
    if (numbers != 3 && numbers != 4 && numbers != 6 && numbers != 7)
      throw FileError("a point has 3 numbers, not " + std::to_string(numbers));
    const Point p{coordinate(words_[1]), coordinate(words_[2]), coordinate(words_[3])};
    if (numbers == 4 && coordinate(words_[4]) != 1)
      throw FileError("a point with the weight " + quoted(words_[4]) + "; only 1 is supported");
    if (numbers > 4) count(colored_);
    result_.mesh.points.push_back(p);
  }

  void add_uv() {
    const std::size_t numbers = words_.size() - 1;
    if (numbers < 1 || numbers > 3)  // v is 0 where it is not given
      throw FileError("texture coordinates are 1 to 3 numbers, not " + std::to_string(numbers));
    uvs_.push_back({coordinate(words_[1]), numbers > 1 ? coordinate(words_[2]) : 0});
  }

  // One that is not finite or has no length is 0, as if it was not there.
  void add_normal() {
    double sides[3] = {};
    for (std::size_t i = 0; i < 3 && i + 1 < words_.size(); ++i)
      sides[i] = read_decimal(words_[i + 1]).value_or(0);
    const Vec3d normal{sides[0], sides[1], sides[2]};
    const double size = length(normal);
    const bool usual = size > 1e-100 && size < 1e100;
    result_.normals.points.push_back(usual ? normal * (1 / size) : Vec3d{});
  }

  void use_material(const std::string& name) {
    end_material();
    const int next = static_cast<int>(materials_.size());
    const auto [known, is_new] = materials_.try_emplace(name, next);
    if (is_new) result_.material_names.push_back(name);
    if (materials_.size() > max_mesh_materials)
      throw FileError("more than " + std::to_string(max_mesh_materials) + " materials");
    material_ = known->second;
  }
  // Gives the material to the triangles since it was named.
  void end_material() { result_.materials.resize(result_.mesh.triangles.size(), material_); }

  struct Corner {
    int point, normal;  // normal: 0 if it has none, -1 if it is not there
    Uv<double> uv;
  };
  Corner corner(std::string_view word) const {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view rest = word.substr(std::min(slash + 1, word.size()));
    const std::string_view uv = rest.substr(0, rest.find('/'));
    const int point = index_of(word.substr(0, slash), result_.mesh.points.size(), "points (v)");
    const int at = uv.empty() ? -1 : index_of(uv, uvs_.size(), "texture coordinates (vt)");
    int normal = 0;
    if (const std::size_t second = rest.find('/'); second < rest.size() - 1) {
      const char *const from = rest.data() + second + 1, *const end = rest.data() + rest.size();
      if (std::from_chars(from, end, normal).ptr != end)
        throw FileError("the corner " + quoted(word) + " is not point/texture/normal");
      const auto& normals = result_.normals.points;
      const int entries = static_cast<int>(normals.size());
      if (normal < 0) normal += entries;
      if (normal <= 0 || normal >= entries ||
          largest(normals[static_cast<std::size_t>(normal)]) == 0)
        normal = -1;
    }
    return {point, normal, at < 0 ? no_uv : uvs_[static_cast<std::size_t>(at)]};
  }

  void add_face() {
    const std::size_t corners = words_.size() - 1;
    if (corners < 3)
      throw FileError("a face has at least 3 corners, not " + std::to_string(corners));
    if (result_.mesh.triangles.size() + corners - 2 > max_mesh_triangles)
      throw FileError("more than " + std::to_string(max_mesh_triangles) + " triangles");
    corners_.clear();
    for (std::size_t i = 1; i < words_.size(); ++i) {
      corners_.push_back(corner(words_[i]));
      if (has_uv(corners_.back().uv) != has_uv(corners_.front().uv)) {
        throw FileError("the corner " + quoted(words_[has_uv(corners_[0].uv) ? i : 1]) +
                        " has no texture coordinates, but others of its face have");
      }
    }
    if (!has_uv(corners_[0].uv)) count(without_uv_);
    const auto has_normal = [](const Corner& at) { return at.normal > 0; };
    if (!std::all_of(corners_.begin(), corners_.end(), has_normal)) {
      const auto has_none = [](const Corner& at) { return at.normal == 0; };
      if (!std::all_of(corners_.begin(), corners_.end(), has_none)) count(without_normals_);
      for (Corner& at : corners_) at.normal = 0;
    }
    if (corners == 3) return add_triangle({0, 1, 2});
    places_.clear();
    for (const Corner& at : corners_)
      places_.push_back(result_.mesh.points[static_cast<std::size_t>(at.point)]);
    if (!cut_polygon(places_, cuts_, looks_)) count(crossing_);
    for (const auto& cut : cuts_) add_triangle(cut);
  }

  void add_triangle(const std::array<std::size_t, 3>& cut) {
    const Corner &a = corners_[cut[0]], &b = corners_[cut[1]], &c = corners_[cut[2]];
    result_.mesh.triangles.push_back({a.point, b.point, c.point});
    result_.mapping.corners.push_back({a.uv, b.uv, c.uv});
    if (auto& normals = result_.normals.triangles; a.normal > 0 || !normals.empty()) {
      normals.resize(result_.mesh.triangles.size() - 1);
      normals.push_back({a.normal, b.normal, c.normal});
    }
  }

  ObjFile result_;
  std::vector<Uv<double>> uvs_;
  int number_ = 0;                                    // of the line
  std::vector<std::pair<std::string, int>> skipped_;  // what else lines begin with; the first one
  Counted colored_, without_uv_, without_normals_, crossing_;
  std::map<std::string, int> materials_;
  int material_ = -1;
  std::size_t looks_ = most_polygon_looks;
  Words words_;  // of the line, and what a face has
  std::vector<Corner> corners_;
  std::vector<Point> places_;
  Cuts cuts_;
};

}  // namespace

ObjFile read_obj(std::string_view text) {
  ObjReader reader;
  for_each_line(text, [&](std::string_view line, int number) { reader.read_line(line, number); });
  ObjFile result = reader.take();
  if (result.mesh.triangles.empty()) throw FileError("it has no faces (f); is this an OBJ file?");
  return result;
}

std::map<std::string, Material> read_mtl(std::string_view text) {
  std::map<std::string, Material> materials;
  Material* material = nullptr;
  Words words;
  for_each_line(text, [&](std::string_view line, int) {
    split_words(line, words);
    const auto begins_with = [&](std::string_view word) {  // some programs write map_kd
      return !words.empty() && in_small_letters(words[0]) == in_small_letters(word);
    };
    if (begins_with("newmtl")) material = &materials[std::string(name_behind(words[0], line))];
    if (words.size() < 2 || material == nullptr) return;
    // The numbers from a word on, at most three.
    const auto numbers_at = [&](std::size_t first) {
      std::vector<double> numbers;
      for (std::size_t i = first; i < words.size() && numbers.size() < 3; ++i) {
        const std::optional<double> number = read_decimal(words[i]);
        if (!number) break;
        numbers.push_back(*number);
      }
      return numbers;
    };
    if (begins_with("Kd")) {
      if (const auto rgb = numbers_at(1); rgb.size() == 3 || (rgb.size() == 1 && words.size() == 2))
        material->color = {rgb.front(), rgb[rgb.size() / 2], rgb.back()};
    } else if (begins_with("map_Kd")) {
      *material = {.color = material->color};
      std::size_t i = 1;
      while (i < words.size() && words[i].front() == '-') {
        const std::string_view option = words[i++];
        const std::vector<double> numbers = numbers_at(i);
        const std::string_view word = i < words.size() ? words[i] : std::string_view();
        std::size_t taken = numbers.size();
        if (option == "-s" || option == "-o") {
          Uv<double>& uv = option == "-s" ? material->scale : material->offset;
          if (!numbers.empty()) uv.u = numbers[0];
          if (numbers.size() > 1) uv.v = numbers[1];
        } else if (option == "-mm" && taken > 1) {
          taken = 2;
          material->base = numbers[0];
          material->gain = numbers[1];
        } else if (option == "-clamp" && (word == "on" || word == "off")) {
          taken = 1;
          material->clamped = word == "on";
        } else {
          taken = std::max(taken, std::size_t{1});
          material->left_out += (material->left_out.empty() ? "" : ", ") + std::string(option);
        }
        i += taken;
      }
      if (i < words.size()) material->picture = name_from(line, words[i]);
    }
  });
  return materials;
}

std::filesystem::path beside(const std::filesystem::path& file, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::filesystem::path there = file.parent_path() / path_of(name);
  std::error_code error;
  if (std::filesystem::exists(there, error)) return there;
  return file.parent_path() / there.filename();
}

std::map<std::string, Material> load_mtl(const std::filesystem::path& path) {
  auto materials = with_name("cannot load materials", path, [&] {
    const std::vector<std::uint8_t> bytes = read_file(path, max_mesh_bytes);
    return read_mtl({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
  for (auto& [name, material] : materials) {
    if (!material.picture.empty()) material.picture = name_of(beside(path, material.picture));
  }
  return materials;
}

ObjFile load_obj(const std::filesystem::path& path) {
  return with_name("cannot load mesh", path, [&] {
    const std::vector<std::uint8_t> bytes = read_file(path, max_mesh_bytes);
    return read_obj({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
}

}  // namespace texmap
