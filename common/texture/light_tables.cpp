// The tables of what a texel's bytes stand for.
#include <algorithm>
#include <cmath>

#include "image_texture.hpp"
#include "srgb.hpp"

namespace texmap {
namespace {

template <class Number>
LightTables<Number> make_light_tables() {
  LightTables<Number> tables{};
  auto& [encoded, linear, stb] = tables;
  linear = srgb_decode_table<Number>();
  for (std::size_t byte = 0; byte < 256; ++byte) {
    encoded[byte] = static_cast<Number>(byte) / Number(255);
    const double decoded = std::pow(static_cast<double>(byte) / 255, 2.2);
    stb[byte] = static_cast<Number>(std::min(std::floor(256 * decoded), 255.0) / 255);
  }
  return tables;
}

}  // namespace

// Made when the program starts: a table made at its first use would be asked for at each look-up whether it is there, which
// took as long as the look-up. It stands in a file of its own, and not in the header, so that no file compiled for wide
// instructions makes it, which machines without them could not survive.
const AllLightTables light_tables = {make_light_tables<float>(), make_light_tables<double>(), make_light_tables<long double>()};

}  // namespace texmap
