// What the operating system says about a file, in words that help.
#pragma once
#include <string>

namespace texmap {

/// Why a file could not be reached. Call it right after the system call that failed.
///
/// @param error  errno
[[nodiscard]] std::string errno_message(int error);

/// Throws a FileError with the system's reason unless a call of it has succeeded.
void require_success(bool succeeded);

/// Refuses an empty name and one with a zero byte, where the system would end it.
/// Errors: FileError.
void check_name(const std::string& path);

}  // namespace texmap
