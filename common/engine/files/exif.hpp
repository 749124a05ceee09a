// What EXIF says about a picture.
#pragma once
#include <string_view>

#include "engine/files/bytes.hpp"
#include "engine/files/pixel_order.hpp"

namespace texmap {

inline constexpr std::string_view turned_by_exif = "is turned as its EXIF says";

/// How EXIF turns a picture: its tag 0x0112, orientation. Damaged EXIF turns nothing.
/// @param tiff  from its byte order on
/// Source: EXIF 2.32, section 4.6.4; TIFF 6.0, section 2.
[[nodiscard]] PixelOrder order_of_exif(Bytes tiff);

}  // namespace texmap
