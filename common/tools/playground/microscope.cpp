// The WebAssembly module of the book's cover: a map goes in, pictures and numbers come out.
#include <cstdint>
#include <exception>
#include <vector>

#include "engine/files/decode_image.hpp"
#include "exported.hpp"
#include "tools/book/microscope.hpp"

using namespace texmap;
static ImageTexture map;

/// Keeps the map of a PNG or JPEG file; false if it is none.
EXPORTED(keep_map) bool keep_map(const std::uint8_t* bytes, int size) {
  try {
    map.image = decode_image({bytes, static_cast<std::size_t>(size)});
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

/// Draws rows of the globe; returns their pixels, 4 bytes each.
EXPORTED(draw) const std::uint8_t* draw(double radii, int size, int first, int count) {
  return rgba_of(microscope::draw(map, radii, size, first, count));
}

/// The numbers of a pixel: nine published, nine of ours, then nine true ones in two parts each.
EXPORTED(look) const double* look(double radii, int size, int column, int row) {
  static std::vector<double> numbers;
  const auto pixel = microscope::look(radii, size, column, row, map.image.width, map.image.height);
  numbers.assign(pixel.published.begin(), pixel.published.end());
  numbers.insert(numbers.end(), pixel.ours.begin(), pixel.ours.end());
  for (const DoublePair& number : pixel.right)
    numbers.insert(numbers.end(), {number.high, number.low});
  return numbers.data();
}
