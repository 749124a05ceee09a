// What EXIF says about a picture.
#include "engine/files/exif.hpp"

#include <cstddef>
#include <string_view>

namespace texmap {

PixelOrder order_of_exif(Bytes tiff) {
  if (tiff.size() < 8) return {};
  const bool low_first = tiff[0] == 'I';
  const auto number = [&](std::size_t place, std::size_t bytes) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i)
      value = value << 8 | tiff[place + (low_first ? bytes - 1 - i : i)];
    return value;
  };
  if ((tiff[0] != 'I' && tiff[0] != 'M') || tiff[1] != tiff[0] || number(2, 2) != 42) return {};
  const std::size_t directory = number(4, 4);
  if (directory > tiff.size() - 2) return {};
  std::size_t entries = number(directory, 2);
  for (std::size_t at = directory + 2; entries > 0 && at + 12 <= tiff.size(); at += 12, --entries) {
    const bool is_one_short = number(at + 2, 2) == 3 && number(at + 4, 4) == 1;
    if (number(at, 2) != 0x0112 || !is_one_short) continue;
    const std::size_t orientation = number(at + 8, 2);
    if (orientation > 8) return {};
    const auto is_one_of = [orientation](std::string_view digits) {
      return digits.find(static_cast<char>('0' + orientation)) != std::string_view::npos;
    };
    return {.from_right = is_one_of("2378"),
            .from_below = is_one_of("3467"),
            .columns_first = is_one_of("5678")};
  }
  return {};
}

}  // namespace texmap
