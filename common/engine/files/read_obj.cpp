// Meshes from files in OBJ format (Wavefront).
#include "engine/files/read_obj.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
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
  const char before = line.size() > 1 ? line[line.size() - 2] : ' ';
  return line.front() == 'v' || line.front() == 'f' || is_blank(before);
}

// A piece of the file as a message shows it: at most 24 bytes, of which a terminal can show all.
std::string quoted(std::string_view word) {
  std::string shown = "'";
  for (const char c : word.substr(0, 24)) shown += c > ' ' && c <= '~' ? c : '?';
  return shown + (word.size() > 24 ? "...'" : "'");
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
    if (c == '\0' || c == '\r' || c == '\f' || c == '\v')
      throw FileError("it has a byte that is not text; is this an OBJ file?");
  }
  end_word(line.size());
}

// As programs write the result of 0 / 0: nan, -nan(ind), 1.#QNAN, -1.#IND00.
bool is_nan(std::string_view word) {
  std::string lower;
  for (const char c : word.substr(0, 24)) lower += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
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
    if (without_uv_ > 0) {
      note(
          text("faces without texture coordinates: %d of %d, the first in line %d; they have a "
               "plain color",
               without_uv_, faces_, first_without_uv_));
    }
    if (crossing_ > 0) {
      note(
          text("polygons that cross themselves%s: %d, the first in line %d; their triangles cover "
               "more than they do",
               looks_ > 0 ? "" : " or have too many corners", crossing_, first_crossing_));
    }
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
    constexpr std::string_view ignored[] = {"vn", "o", "g", "s", "mg", "usemtl", "mtllib"};
    if (std::find(std::begin(ignored), std::end(ignored), kind) == std::end(ignored)) skip(kind);
  }

 private:
  void note(std::string sentence) { result_.notes.push_back(std::move(sentence)); }

  // Another statement of the format, or a program's own.
  void skip(std::string_view kind) {
    const std::string shown = quoted(kind);
    const auto is_shown = [&](const auto& known) { return known.first == shown; };
    if (skipped_.size() < most_skipped && std::none_of(skipped_.begin(), skipped_.end(), is_shown))
      skipped_.emplace_back(shown, number_);
  }

  void add_point() {
    const std::size_t numbers = words_.size() - 1;
    if (numbers != 3 && numbers != 4 && numbers != 6)  // with a weight; with a color
      throw FileError("a point has 3 numbers, not " + std::to_string(numbers));
    const Point p{coordinate(words_[1]), coordinate(words_[2]), coordinate(words_[3])};
    if (numbers == 4 && coordinate(words_[4]) != 1)
      throw FileError("a point with the weight " + quoted(words_[4]) + "; only 1 is supported");
    result_.mesh.points.push_back(p);
  }

  void add_uv() {
    const std::size_t numbers = words_.size() - 1;
    if (numbers < 1 || numbers > 3)  // v is 0 where it is not given
      throw FileError("texture coordinates are 1 to 3 numbers, not " + std::to_string(numbers));
    uvs_.push_back({coordinate(words_[1]), numbers > 1 ? coordinate(words_[2]) : 0});
  }

  struct Corner {
    int point;
    Uv<double> uv;
  };
  Corner corner(std::string_view word) const {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view rest = word.substr(std::min(slash + 1, word.size()));
    const std::string_view uv = rest.substr(0, rest.find('/'));
    const int point = index_of(word.substr(0, slash), result_.mesh.points.size(), "points (v)");
    const int at = uv.empty() ? -1 : index_of(uv, uvs_.size(), "texture coordinates (vt)");
    if (const std::size_t second = rest.find('/'); second != std::string_view::npos) {
      const std::string_view normal = rest.substr(second + 1);
      if (normal.empty() || normal.find_first_not_of("-0123456789") != std::string_view::npos)
        throw FileError("the corner " + quoted(word) + " is not point/texture/normal");
    }
    return {point, at < 0 ? no_uv : uvs_[static_cast<std::size_t>(at)]};
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
      if (has_uv(corners_.back().uv) != has_uv(corners_.front().uv))
        throw FileError("the corner " + quoted(words_[has_uv(corners_[0].uv) ? i : 1]) +
                        " has no texture coordinates, but others of its face have");
    }
    ++faces_;
    if (!has_uv(corners_[0].uv) && without_uv_++ == 0) first_without_uv_ = number_;
    if (corners == 3) return add_triangle({0, 1, 2});
    places_.clear();
    for (const Corner& at : corners_)
      places_.push_back(result_.mesh.points[static_cast<std::size_t>(at.point)]);
    if (!cut_polygon(places_, cuts_, looks_) && crossing_++ == 0) first_crossing_ = number_;
    for (const auto& cut : cuts_) add_triangle(cut);
  }

  void add_triangle(const std::array<std::size_t, 3>& cut) {
    const Corner &a = corners_[cut[0]], &b = corners_[cut[1]], &c = corners_[cut[2]];
    result_.mesh.triangles.push_back({a.point, b.point, c.point});
    result_.mapping.corners.push_back({a.uv, b.uv, c.uv});
  }

  ObjFile result_;
  std::vector<Uv<double>> uvs_;
  int number_ = 0;                                    // of the line
  std::vector<std::pair<std::string, int>> skipped_;  // what else lines begin with; the first one
  int faces_ = 0, without_uv_ = 0, first_without_uv_ = 0;
  int crossing_ = 0, first_crossing_ = 0;
  std::size_t looks_ = most_polygon_looks;
  Words words_;  // of the line, and what a face has
  std::vector<Corner> corners_;
  std::vector<Point> places_;
  Cuts cuts_;
};

}  // namespace

ObjFile read_obj(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, 3) == byte_order_mark) text.remove_prefix(3);
  ObjReader reader;
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
      reader.read_line(line, first);
      joined.clear();
    } catch (const FileError& error) {
      throw FileError("line " + std::to_string(first) + ": " + error.what());
    }
  }
  ObjFile result = reader.take();
  if (result.mesh.triangles.empty()) throw FileError("it has no faces (f); is this an OBJ file?");
  return result;
}

ObjFile load_obj(const std::filesystem::path& path) {
  return with_name("cannot load mesh", path, [&] {
    const std::vector<std::uint8_t> bytes = read_file(path, max_mesh_bytes);
    return read_obj({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
}

}  // namespace texmap
