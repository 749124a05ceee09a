// The WebAssembly module of the book's cover: a map goes in, pictures and numbers come out, which
// stay where they are until the next call.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <vector>

#include "engine/picture/decode_image.hpp"
#include "tools/book/microscope.hpp"

#define EXPORTED(name) extern "C" __attribute__((export_name(#name)))

using namespace texmap;
static ImageTexture map;

/// Memory for the map's file.
EXPORTED(take) void* take(int bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }

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
  static std::vector<std::uint8_t> drawn;
  drawn.clear();
  for (const Rgb8& pixel : microscope::draw(map, radii, size, first, count).pixels)
    drawn.insert(drawn.end(), {pixel.r, pixel.g, pixel.b, 255});
  return drawn.data();
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
