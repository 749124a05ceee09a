// What the tests against other people's programs share: pictures, and how to skip.
#pragma once
#include <doctest.h>

#include <cmath>
#include <iostream>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "engine/picture/load_image.hpp"
#include "support/made_pictures.hpp"

namespace texmap::test {

struct Pair {
  std::string name;
  Image a, b;
};

[[nodiscard]] inline std::vector<Pair> pairs() {
  const std::string golden = TEXMAP_TESTS_DIR "/golden/";
  return {{"noise", noise(97, 61, 1), noise(97, 61, 2)},
          {"ramps", ramps(120, 90), ramps(120, 90, 1)},
          {"one pixel", Image(40, 30, {10, 20, 30}),
           [] {
             Image image(40, 30, {10, 20, 30});
             image.at(20, 15).r = 11;
             return image;
           }()},
          {"chapters 2 and 3", load_image(golden + "02_checkerboard_uv.png"),
           load_image(golden + "03_image_texture.png")},
          {"chapters 5 and 3", load_image(golden + "05_y_rotation.png"),
           load_image(golden + "03_image_texture.png")}};
}

/// The number at the front of a text, NaN if there is none.
[[nodiscard]] inline double number(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = std::nan("");
  in >> value;
  return value;
}

/// CTest reads this line and calls the test skipped.
inline void skip(const char* why) {
  std::cout << "skipped: " << why << std::endl;
  CHECK(true);
}

}  // namespace texmap::test
