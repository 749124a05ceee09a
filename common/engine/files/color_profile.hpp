// What an ICC profile says about a picture's colors.
#pragma once
#include <string>

#include "engine/files/bytes.hpp"

namespace texmap {

/// What the user should know of a picture with this profile: the words of a note, empty if its red
/// and green are sRGB's, and for profiles without them. Damaged ones say nothing.
/// Source: ICC.1:2022, sections 7.2, 7.3, 9.2 and 10.
[[nodiscard]] std::string note_on_profile(Bytes profile);

}  // namespace texmap
