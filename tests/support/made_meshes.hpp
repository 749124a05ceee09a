// Meshes in OBJ format, made here: good files and bad ones, and meshes of any size.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace texmap::test {

/// A file that must be refused.
struct BadMesh {
  std::string name;
  std::string text;
  std::string error;  ///< in its message
};

/// A file that must load.
struct GoodMesh {
  std::string name;
  std::string text;
  std::size_t points, triangles;
};

inline const std::string square_points =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";  // 8 lines

/// Each with the line that is wrong, where there is one.
[[nodiscard]] inline std::vector<BadMesh> bad_meshes() {
  const std::string good_face = "f 1/1 2/2 3/3\n";
  std::vector<BadMesh> all;
  for (const auto& [line, error] : std::vector<std::pair<std::string, std::string>>{
           {"f 1/1 2/2 5/3", "the index '5', but only 4 points"},
           {"f 1/1 2/2 3/5", "the index '5', but only 4 texture"},
           {"f 0/1 2/2 3/3", "the index 0"},
           {"f 1/0 2/2 3/3", "the index 0"},
           {"f -5/1 -2/2 -1/3", "the index '-5', but only 4 points"},
           {"f 1/1 2/2 4294967297/3", "the index '4294967297', but only 4 points"},
           {"f 1/1 2/2 99999999999999999999/3", "the index '99999999999999999999' is too large"},
           {"f 1/1 2/2 3.5/3", "'3.5' is not an index"},
           {"f 1/1 2/2 three/3", "'three' is not an index"},
           {"f 1/1 2/2 3x/3", "'3x' is not an index"},
           {"f 1 2 3", "the corner '1' has no texture coordinates"},
           {"f 1//1 2//1 3//1", "the corner '1//1' has no texture coordinates"},
           {"f 1/1 2 3/3", "the corner '2' has no texture coordinates"},
           {"f 1/1/x 2/2/1 3/3/1", "the corner '1/1/x'"},
           {"f 1/1 2/2", "a face has at least 3 corners, not 2"},
           {"f", "a face has at least 3 corners"},
           {"f 1/1 2/2 \\\n3/3", "it continues in the next line"},
           {"vt nan 0", "'nan'"},
           {"vt 0.5", "texture coordinates are 2 numbers, not 1"},
           {"vertex 1 2 3", "it begins with 'vertex'"},
           {"# " + std::string(1 << 20, 'x'), "it is longer than 65536 bytes"}}) {
    all.push_back(
        {line.substr(0, 40), square_points + line + "\n" + good_face, "line 9: " + error});
  }
  for (const auto& [line, error] : std::vector<std::pair<std::string, std::string>>{
           {"f 1/1 2/2 3/3", "the index '1', but only 0 points"},
           {"v 0 zero 0", "'zero' is not a finite"},
           {"v 0 nan 0", "'nan' is not a finite"},
           {"v 0 inf 0", "'inf' is not a finite"},
           {"v 0 1e999 0", "'1e999' is not a finite"},
           {"v 0 1e300 0", "'1e300' is too large"},
           {"v 0 0x10 0", "'0x10' is not a finite"},
           {"v 0 1,5 0", "'1,5' is not a finite"},
           {"v 0 0", "a point has 3 numbers, not 2"},
           {"v 0 0 0 0 0", "a point has 3 numbers"},
           {"v 0 0 0 0.5", "a point with the weight"},
           {std::string("\x7f"
                        "ELF\x02\x01\x01\0\0\0\0\0",
                        12),
            "it has a byte that is not text"},
           {"v 0 0" + std::string(1, '\0') + " 0", "it has a byte that is not text"},
           {"v 0 0 0\rv 1 0 0\rf 1/1 2/2 3/3\r", "it has a byte that is not text"},
           {"\x89PNG\r\n\x1a", "it begins with '?PNG'"},
           {"<html>\n<body>404</body>", "it begins with '<html>'"}}) {
    all.push_back({line, line + "\n" + square_points, "line 1: " + error});
  }
  std::string many_faces = square_points;
  for (int i = 0; i < 1000; ++i) many_faces += good_face;
  all.push_back({"after many lines", many_faces + "f 1/1 2/2 9/3\n", "line 1009: the index '9'"});
  all.push_back({"cut in a face", square_points + "f 1/1 2/2 3", "line 9: the corner '3' has no"});
  all.push_back({"cut in a point", square_points.substr(0, 20), "line 3: a point has 3 numbers"});
  all.push_back({"cut after its points", square_points, "it has no faces"});
  all.push_back({"comments alone", "# nothing\n", "it has no faces"});
  return all;
}

[[nodiscard]] inline std::vector<GoodMesh> good_meshes() {
  const auto after = [](const std::string& lines) { return square_points + lines; };
  std::string windows;
  for (const char c : after("f 1/1 2/2 3/3\n")) windows += c == '\n' ? "\r\n" : std::string(1, c);
  return {
      {"a triangle", after("f 1/1 2/2 3/3\n"), 4, 1},
      {"a square as a fan", after("f 1/1 2/2 3/3 4/4\n"), 4, 2},
      {"no new line at its end", after("f 1/1 2/2 3/3"), 4, 1},
      {"with normals", after("vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n"), 4, 1},
      {"negative indices", after("f -4/-4 -3/-3 -2/-2\n"), 4, 1},
      {"ends of lines as on Windows", windows, 4, 1},
      {"tabs and many blanks", after("f\t1/1   2/2\t \t3/3  \n"), 4, 1},
      {"points with weights of 1", "v 2 0 0 1\n" + after("f 2/1 3/2 4/3\n"), 5, 1},
      {"points with colors", "v 2 0 0 0.5 0.5 0.5\n" + after("f 2/1 3/2 4/3\n"), 5, 1},
      {"three texture coordinates", after("vt 0.5 0.5 0\nf 1/1 2/2 3/5\n"), 4, 1},
      {"names, groups, materials, lines",
       after("mtllib a.mtl\no a\ng b c\ns off\nusemtl wood\n"
             "l 1 2\np 1\nvp 0 0\nf 1/1 2/2 3/3\n"),
       4, 1},
      {"comments and empty lines", "# made here\n\n" + after("\nf 1/1 2/2 3/3 # a face\n"), 4, 1},
      {"a byte order mark", "\xEF\xBB\xBF" + after("f 1/1 2/2 3/3\n"), 4, 1},
      {"a triangle without an area", after("f 1/1 1/1 3/3\n"), 4, 1},
      {"numbers of any form", "v .5 5. -5e-1\nv +1 1E2 1e-400\n" + after("f 1/1 2/2 3/3\n"), 6, 1},
  };
}

}  // namespace texmap::test
