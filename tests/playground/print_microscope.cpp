// Prints what the error microscope says of pixels, for test_cover.py: the module's numbers, and the
// color. usage: print_microscope MAP     reads lines: radii size column row
#include <cstdio>
#include <iostream>

#include "engine/files/load_image.hpp"
#include "tools/book/microscope.hpp"

int main(int, char** argv) {
  using namespace texmap;
  const ImageTexture map{load_image(argv[1])};
  double radii = 0;
  for (int size = 0, column = 0, row = 0; std::cin >> radii >> size >> column >> row;) {
    const auto pixel =
        microscope::look(radii, size, column, row, map.image.width, map.image.height);
    for (const float number : pixel.published) std::printf("%.17g ", double(number));
    for (const float number : pixel.ours) std::printf("%.17g ", double(number));
    for (const DoublePair& number : pixel.right)
      std::printf("%.17g %.17g ", number.high, number.low);
    const Rgb8 color = microscope::draw(map, radii, size, row, 1).at(column, 0);
    std::printf("%d %d %d\n", color.r, color.g, color.b);
  }
}
