// Tests of engine/files/read_obj.hpp: a file loads whole, or an error names the line.
#include <doctest.h>

#include <cmath>
#include <sstream>

#include "engine/files/read_obj.hpp"
#include "engine/files/text.hpp"
#include "support/temporary_folder.hpp"

namespace texmap::test {
namespace {

/// The file that a line of meshes.tsv stands for, which says how it is written.
std::string file_of(std::string text) {
  const std::string face = "f 1/1 2/2 3/3\n";
  std::string faces;
  for (int i = 0; i < 1000; ++i) faces += face;
  for (const auto& [word, lines] : std::vector<std::pair<std::string, std::string>>{
           {"{square}", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"},
           {"{face}", face},
           {"{faces}", faces},
           {"{long}", std::string(1 << 20, 'x')}}) {
    const std::size_t at = text.find(word);
    if (at != std::string::npos) text.replace(at, word.size(), lines);
  }
  std::string file;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string letters = "nrt";
    const std::size_t letter = text[i] == '\\' ? letters.find(text[++i]) : letters.size();
    if (letter < letters.size()) {
      file += "\n\r\t"[letter];
    } else if (letter == std::string::npos && text[i] == 'x') {
      file += static_cast<char>(std::stoi(text.substr((i += 2) - 1, 2), nullptr, 16));
    } else {
      file += text[i];
    }
  }
  return file;
}

TEST_CASE(
    "a file loads with all points and triangles, or is refused with its line and the reason") {
  int loaded = 0, refused = 0;
  std::istringstream lines(text_in(TEXMAP_TESTS_DIR "/corpus/meshes.tsv"));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos) continue;
    CAPTURE(line);
    const std::string should = line.substr(0, tab);
    ObjFile read;
    const std::string error =
        image_error_of([&] { read = read_obj(file_of(line.substr(tab + 1))); });
    if (should.ends_with("triangles")) {
      const std::size_t points = read.mesh.points.size(), triangles = read.mesh.triangles.size();
      CHECK(text("%zu points, %zu triangles", points, triangles) == should);
      CHECK(read.mapping.corners.size() == triangles);
      ++loaded;
    } else {
      CHECK(error.substr(0, should.size()) == should);
      CHECK(error.size() < 160);
      ++refused;
    }
  }
  CHECK(loaded >= 15);
  CHECK(refused >= 40);
}

using Notes = std::vector<std::string>;

TEST_CASE("what is not drawn as the file says is told in a line, each word once") {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5\nf 1/1 2/1 3/1\n";
  const std::string silent = "o a \\\n# \\\ng b\ns 1\nmg 1 2\nvn 0 0 1\nusemtl c\nmtllib d\\\n";
  const ObjFile plain = read_obj(silent + triangle);
  CHECK(plain.notes.empty());
  CHECK(plain.mapping.corners[0][0].v == 0);
  const ObjFile read = read_obj(triangle + "p 1\nl 1 2\nfo 1 2 \\\n3\ncurv2 1\nl 2 3\nf 1 2 3\n");
  CHECK(read.mesh.triangles.size() == 2);
  CHECK(std::isnan(read.mapping.corners[1][2].u));
  CHECK(read.notes == Notes{"skipped the lines that are no textured triangles: "
                            "'p' (line 6), 'l' (line 7), 'fo' (line 8), 'curv2' (line 10)",
                            "faces without texture coordinates: 1, the first in line 12; "
                            "they have a plain color"});
  CHECK(read_obj("v 0 0 1 1 0 0\n" + triangle).notes ==
        Notes{"points with a color of their own: 1, the first in line 1; it is not drawn"});
  std::string many = triangle;
  for (int i = 0; i < 1000; ++i) many += "word" + std::to_string(i) + "\n";
  CHECK(read_obj(many).notes.at(0).ends_with("'word15' (line 21), and perhaps others"));
}

TEST_CASE("a polygon that is not convex keeps its shape and its (u, v); one that crosses is told") {
  const std::string corners =
      "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\n"
      "vt 1 0\nvt 1 .5\nvt .5 .5\nvt .5 1\nvt 0 1\nvt 0 0\n";
  const ObjFile read = read_obj(corners + "f 1/1 2/2 3/3 4/4 5/5 6/6\n");
  CHECK(read.notes.empty());
  double area = 0;
  for (std::size_t i = 0; i < read.mesh.triangles.size(); ++i) {
    const int t = static_cast<int>(i);
    const Point &a = read.mesh.corner(t, 0), &b = read.mesh.corner(t, 1);
    area += std::abs(cross(b - a, read.mesh.corner(t, 2) - a).z) / 2;
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(read.mapping.corners[i][k].u * 2 == read.mesh.corner(t, static_cast<int>(k)).x);
  }
  CHECK(area == 3);
  const std::string crossed = "f 1/1 3/3 2/2 6/6\n";
  CHECK(read_obj(corners + crossed + crossed).notes ==
        Notes{"polygons that cross themselves: 2, the first in line 13; their triangles cover "
              "more than they do"});
}

TEST_CASE("normals of unit length and materials arrive; where one is missing a face has none") {
  const ObjFile read = read_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 4\nvn 3 0 4\nvn 1.#IND 0 0\nmtllib a b.mtl # c\n"
      "f 1/1 2/1 3/1\nusemtl old  wood#1 \nf 1/1/1 2/1/-2 3/1/1\nf 1/1/1 2/1/3 3/1/1\n"
      "usemtl b\nf 1/1/1 2/1/9 3/1/1\nusemtl old  wood#1\nf 1//1 2//2 3//1\nf 1/1 2/1 3/1\n");
  CHECK(read.normals.triangles.size() == 6);
  CHECK(read.normals.triangles[1] == std::array{1, 2, 1});
  for (const std::size_t flat : {0U, 2U, 3U, 5U})
    CHECK(read.normals.triangles[flat] == std::array{0, 0, 0});
  CHECK(largest(read.normals.points[0]) == 0);
  CHECK(read.normals.points[1].z == 1);
  CHECK(read.normals.points[2].x == doctest::Approx(0.6));
  CHECK(read.libraries == std::vector<std::string>{"a b.mtl"});
  CHECK(read.material_names == std::vector<std::string>{"old  wood#1", "b"});
  CHECK(read.materials == std::vector<int>{-1, 0, 0, 1, 0, 0});
  CHECK(read.notes ==
        Notes{"faces without texture coordinates: 1, the first in line 16; they have a plain color",
              "faces without their normals (vn): 2, the first in line 12; they are flat"});
}

TEST_CASE("a material is its picture, with blanks and options, or its color") {
  const std::map<std::string, Material> read = read_mtl(
      "map_Kd none.png\nnewmtl a b\nNs 9\nKd 1 .5 0\n\tmap_Kd -s 2 3 1 -clamp on -o .5 "
      "-mm .1 .7 -bm 2 C:\\my pics\\a 1.png # x\nnewmtl c\r\nKd .25\r\nnewmtl d\nKd xyz 1 1\n"
      "map_Kd\n"
      "newmtl e\nmap_Kd -clamp on a.png\nmap_Kd -clamp off -mm 1 b.png\n");
  CHECK(read.size() == 4);
  const Material& picture = read.at("a b");
  CHECK(picture.picture == "C:\\my pics\\a 1.png");
  CHECK(picture.left_out == "-bm");
  CHECK(picture.clamped);
  CHECK(std::array{picture.base, picture.gain} == std::array{0.1, 0.7});
  // A second map_Kd replaces the first and its options. Its -mm has one number and is left out.
  const Material& last = read.at("e");
  CHECK(!last.clamped);
  CHECK(std::array{last.base, last.gain} == std::array{0.0, 1.0});
  CHECK(last.left_out == "-mm");
  CHECK(last.picture == "b.png");
  CHECK(picture.color.g == 0.5);
  CHECK(std::array{picture.scale.u, picture.scale.v} == std::array{2.0, 3.0});
  CHECK(std::array{picture.offset.u, picture.offset.v} == std::array{0.5, 0.0});
  CHECK(read.at("c").color.b == 0.25);
  CHECK(read.at("d").color.r == 0.8);
  CHECK(read.at("d").picture.empty());
}

TEST_CASE("names with # and in quotes, words in any letters, and a material without a name") {
  const std::map<std::string, Material> read = read_mtl(
      "newmtl Grey #1\nkd 1 0 0\nnewmtl Grey #2 # the second\nKd 0 1 0\nmap_kd \"my wood.png\"\n"
      "newmtl # none\nKd 0 0 1\nnewmtl #3\nKd 1 0 1\nnewmtl e\nKd -1 nan 2\n");
  CHECK(read.size() == 5);
  CHECK(read.at("Grey #1").color.g == 0);
  CHECK(read.at("Grey #2").color.g == 1);
  CHECK(read.at("Grey #2").picture == "my wood.png");
  CHECK(read.at("").color.b == 1);
  CHECK(read.at("#3").color.r == 1);
  CHECK(read.at("e").color.r == 0.8);  // not the gray of one number
  const ObjFile mesh =
      read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl #1\nf 1 2 3\nusemtl #2\nf 1 2 3\n");
  CHECK(mesh.material_names == std::vector<std::string>{"#1", "#2"});
}

TEST_CASE("numbers, indices and fans arrive as they are in the file") {
  const ObjFile read = read_obj(
      "v 0 0 0\nv 1.5 -2e-3 3\nv 4 5 6\nv 7 8 9\nvt 0.25 0.5\nvt -1 2\n"
      "f 1/1 2/2 3/1 4/2\nf -1/-1/7 -2/-2/7 -3/-1/7\n");
  CHECK(read.mesh.points[1].x == 1.5);
  CHECK(read.mesh.points[1].y == -2e-3);
  CHECK(read.mesh.triangles[0] == std::array{0, 1, 2});
  CHECK(read.mesh.triangles[1] == std::array{0, 2, 3});
  CHECK(read.mesh.triangles[2] == std::array{3, 2, 1});
  CHECK(read.mapping.corners[0][1].u == -1);
  CHECK(read.mapping.corners[1][0].u == 0.25);
  CHECK(read.mapping.corners[2][0].v == 2);
  CHECK(read.mapping.corners[2][1].v == 0.5);
}

}  // namespace
}  // namespace texmap::test
