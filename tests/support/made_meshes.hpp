// Meshes in OBJ format, made here: good files and bad ones, and meshes of any size.
#pragma once
#include <string>
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
  const auto after = [](const std::string& lines) { return square_points + lines; };
  const std::string good_face = "f 1/1 2/2 3/3\n";
  std::string thousands = "f";
  for (int i = 0; i < 20000; ++i) thousands += " 1/1";
  return {
      {"an index beyond the points", after("f 1/1 2/2 5/3\n"),
       "line 9: the index '5', but only 4 points"},
      {"an index beyond the texture coordinates", after("f 1/1 2/2 3/5\n"),
       "line 9: the index '5', but only 4 texture"},
      {"the index 0", after("f 0/1 2/2 3/3\n"), "line 9: the index 0"},
      {"the texture index 0", after("f 1/0 2/2 3/3\n"), "line 9: the index 0"},
      {"a negative index beyond the first", after("f -5/1 -2/2 -1/3\n"),
       "line 9: the index '-5', but only 4 points"},
      {"an index beyond int", after("f 1/1 2/2 4294967297/3\n"),
       "line 9: the index '4294967297', but only 4 points"},
      {"an index beyond long long", after("f 1/1 2/2 99999999999999999999/3\n"),
       "line 9: the index '99999999999999999999' is too large"},
      {"an index with a fraction", after("f 1/1 2/2 3.5/3\n"), "line 9: '3.5' is not an index"},
      {"an index that is a word", after("f 1/1 2/2 three/3\n"), "line 9: 'three' is not an index"},
      {"an index with a word behind it", after("f 1/1 2/2 3x/3\n"), "line 9: '3x' is not an index"},
      {"a face before its points", "f 1/1 2/2 3/3\n" + square_points,
       "line 1: the index '1', but only 0 points"},
      {"faces without texture coordinates", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
       "line 4: the corner '1' has no texture coordinates"},
      {"corners with normals alone", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n",
       "line 5: the corner '1//1' has no texture coordinates"},
      {"one corner without texture coordinates", after("f 1/1 2 3/3\n"),
       "line 9: the corner '2' has no texture coordinates"},
      {"a normal that is a word", after("f 1/1/x 2/2/1 3/3/1\n"), "line 9: the corner '1/1/x'"},
      {"a face of two corners", after("f 1/1 2/2\n"),
       "line 9: a face has at least 3 corners, not 2"},
      {"a face without corners", after(good_face + "f\n"),
       "line 10: a face has at least 3 corners"},
      {"a point that is a word", "v 0 zero 0\n" + square_points, "line 1: 'zero' is not a finite"},
      {"a point with a NaN", "v 0 nan 0\n" + square_points, "line 1: 'nan' is not a finite"},
      {"a point at infinity", "v 0 inf 0\n" + square_points, "line 1: 'inf' is not a finite"},
      {"a point beyond double", "v 0 1e999 0\n" + square_points, "line 1: '1e999' is not a finite"},
      {"a huge point", "v 0 1e300 0\n" + square_points, "line 1: '1e300' is too large"},
      {"a hexadecimal point", "v 0 0x10 0\n" + square_points, "line 1: '0x10' is not a finite"},
      {"a decimal comma", "v 0 1,5 0\n" + square_points, "line 1: '1,5' is not a finite"},
      {"a texture coordinate that is a NaN", after("vt nan 0\n" + good_face), "line 9: 'nan'"},
      {"a point with two numbers", "v 0 0\n" + square_points,
       "line 1: a point has 3 numbers, not 2"},
      {"a point with five numbers", "v 0 0 0 0 0\n" + square_points,
       "line 1: a point has 3 numbers"},
      {"a point with a weight", "v 0 0 0 0.5\n" + square_points, "line 1: a point with the weight"},
      {"texture coordinates of one number", after("vt 0.5\n" + good_face),
       "line 9: texture coordinates are 2 numbers, not 1"},
      {"a word that OBJ does not have", after("vertex 1 2 3\n" + good_face),
       "line 9: it begins with 'vertex'"},
      {"a file cut in a face", after(good_face + "f 1/1 2/2 3"), "line 10: it has no end"},
      {"a file cut in a point", square_points.substr(0, 20), "line 3: it has no end"},
      {"a file cut after its points", square_points, "it has no faces"},
      {"comments alone", "# nothing\n", "it has no faces"},
      {"binary bytes",
       std::string("\x7f"
                   "ELF\x02\x01\x01\0\0\0\0\0\n",
                   13),
       "line 1: it has a byte that is not text"},
      {"a byte 0 in a number", "v 0 0" + std::string(1, '\0') + " 0\n" + square_points,
       "line 1: it has a byte that is not text"},
      {"lines ended by CR alone", "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1/1 2/2 3/3\r\n",
       "line 1: it has a byte that is not text"},
      {"a picture", "\x89PNG\r\n\x1a\n", "line 1: it begins with '?PNG'"},
      {"a web page", "<html>\n<body>404</body>\n", "line 1: it begins with '<html>'"},
      {"a line of a megabyte", after("# " + std::string(1 << 20, 'x') + "\n" + good_face),
       "line 9: it is longer than 65536 bytes"},
      {"a face of 20000 corners", after(thousands + "\n"), "line 9: it is longer than 65536 bytes"},
      {"a line that goes on", after("f 1/1 2/2 \\\n3/3\n"),
       "line 9: it continues in the next line"},
      {"an error after a thousand good lines",
       [&] {
         std::string lines = square_points;
         for (int i = 0; i < 1000; ++i) lines += good_face;
         return lines + "f 1/1 2/2 9/3\n";
       }(),
       "line 1009: the index '9'"},
  };
}

[[nodiscard]] inline std::vector<GoodMesh> good_meshes() {
  const auto after = [](const std::string& lines) { return square_points + lines; };
  std::string windows;
  for (const char c : after("f 1/1 2/2 3/3\n")) windows += c == '\n' ? "\r\n" : std::string(1, c);
  return {
      {"a triangle", after("f 1/1 2/2 3/3\n"), 4, 1},
      {"a square as a fan", after("f 1/1 2/2 3/3 4/4\n"), 4, 2},
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
