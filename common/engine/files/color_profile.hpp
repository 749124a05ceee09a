// What an ICC profile says about a picture's colors.
#pragma once
#include <string>

#include "engine/files/bytes.hpp"

namespace texmap {

/// The words of a note on a picture whose colors are in a space with this name.
[[nodiscard]] std::string not_in_srgb(const std::string& space);

/// What the user should know of a picture with this profile: the words of a note. Empty if its red
/// and green are sRGB's and its curve is not a line, and for profiles without them or damaged ones.
/// Source: ICC.1:2022, sections 7.2, 7.3, 9.2 and 10; ICC.1:2001-04, textDescriptionType.
[[nodiscard]] std::string note_on_profile(Bytes profile);

}  // namespace texmap
