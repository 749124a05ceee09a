// What the operating system says about a file, in words that help.
#pragma once
#include <string>

namespace texmap {

/// Why a file could not be reached, from the system's error number right after the call that failed.
///
/// @param error  errno
[[nodiscard]] std::string system_words(int error);

}  // namespace texmap
