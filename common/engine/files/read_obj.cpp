// Meshes from files in OBJ format (Wavefront).
#include "engine/files/read_obj.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
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

// A piece of the file as a message shows it: at most 24 bytes, of which a terminal can show all.
std::string quoted(std::string_view word) {
  std::string shown = "'";
  for (const char c : word.substr(0, 24)) shown += c > ' ' && c <= '~' ? c : '?';
  return shown + (word.size() > 24 ? "...'" : "'");
}

// The words of a line up to a comment.
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
    if (c == ' ' || c == '\t' || c == '#') end_word(i);
    if (c == '#') in_comment = true;
    if (c == '\0' || c == '\r' || c == '\f' || c == '\v')
      throw FileError("it has a byte that is not text; is this an OBJ file?");
  }
  end_word(line.size());
}

double coordinate(std::string_view word) {
  const std::optional<double> number = read_decimal(word);
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
    if (!skipped_.empty()) note("skipped the lines that are no textured triangles: " + skipped_);
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
    if (!line.empty() && line.back() == '\\') {
      throw FileError(
          "it continues in the next line (\\), which is not supported: join the two lines");
    }
    if (words_.empty()) return;
    const std::string_view kind = words_.front();
    if (kind == "v") return add_point();
    if (kind == "vt") return add_uv();
    if (kind == "f") return add_face();
    constexpr std::string_view ignored[] = {"vn", "vp", "o", "g", "s", "mg", "usemtl", "mtllib"};
    if (std::find(std::begin(ignored), std::end(ignored), kind) == std::end(ignored)) skip(kind);
  }

 private:
  void note(std::string sentence) { result_.notes.push_back(std::move(sentence)); }

  // Lines, points, curved surfaces, and how they are to be shown: all of the format but its calls
  // of other files and programs.
  void skip(std::string_view kind) {
    constexpr std::string_view skippable[] = {
        "l",    "p",        "curv",       "curv2",     "surf",  "cstype", "deg",
        "bmat", "step",     "parm",       "trim",      "hole",  "scrv",   "sp",
        "con",  "end",      "shadow_obj", "trace_obj", "ctech", "stech",  "bevel",
        "lod",  "c_interp", "d_interp",   "usemap",    "maplib"};
    if (std::find(std::begin(skippable), std::end(skippable), kind) == std::end(skippable))
      throw FileError("it begins with " + quoted(kind) + ", which this program does not know");
    const std::string word = (skipped_.empty() ? "" : ", ") + std::string(kind);
    if ((", " + skipped_ + ",").find(", " + std::string(kind) + ",") == std::string::npos)
      skipped_ += word;
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
    if (numbers != 2 && numbers != 3)
      throw FileError("texture coordinates are 2 numbers, not " + std::to_string(numbers));
    uvs_.push_back({coordinate(words_[1]), coordinate(words_[2])});
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
    if (uv.empty()) {
      throw FileError("the corner " + quoted(word) +
                      " has no texture coordinates: export the mesh with them");
    }
    const int at = index_of(uv, uvs_.size(), "texture coordinates (vt)");
    if (const std::size_t second = rest.find('/'); second != std::string_view::npos) {
      const std::string_view normal = rest.substr(second + 1);
      if (normal.empty() || normal.find_first_not_of("-0123456789") != std::string_view::npos)
        throw FileError("the corner " + quoted(word) + " is not point/texture/normal");
    }
    return {point, uvs_[static_cast<std::size_t>(at)]};
  }

  void add_face() {
    const std::size_t corners = words_.size() - 1;
    if (corners < 3)
      throw FileError("a face has at least 3 corners, not " + std::to_string(corners));
    if (result_.mesh.triangles.size() + corners - 2 > max_mesh_triangles)
      throw FileError("more than " + std::to_string(max_mesh_triangles) + " triangles");
    corners_.clear();
    for (std::size_t i = 1; i < words_.size(); ++i) corners_.push_back(corner(words_[i]));
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
  int number_ = 0;       // of the line
  std::string skipped_;  // what other lines began with, each word once
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
  for (int number = 1; !text.empty(); ++number) {
    try {
      const std::size_t end = std::min(text.find('\n'), text.size());
      if (end > max_mesh_line)
        throw FileError("it is longer than " + std::to_string(max_mesh_line) + " bytes");
      std::string_view line = text.substr(0, end);
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      text.remove_prefix(std::min(end + 1, text.size()));  // many files end without a new line
      reader.read_line(line, number);
    } catch (const FileError& error) {
      throw FileError("line " + std::to_string(number) + ": " + error.what());
    }
  }
  ObjFile result = reader.take();
  if (result.mesh.triangles.empty()) throw FileError("it has no faces (f)");
  return result;
}

ObjFile load_obj(const std::filesystem::path& path) {
  return with_name("cannot load mesh", path, [&] {
    const std::vector<std::uint8_t> bytes = read_file(path, max_mesh_bytes);
    return read_obj({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
}

}  // namespace texmap
