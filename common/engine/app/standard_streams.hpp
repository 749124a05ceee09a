// Makes standard input, output and error safe to use.
#pragma once
#include <string_view>

namespace texmap {

/// Opens /dev/null for each standard stream that the caller closed: the first file opened would get
/// its number, and messages would go into it. A closed pipe becomes an error, not a signal.
void secure_standard_streams();

/// Writes `text` to stdout, at once.
/// Errors: std::runtime_error if it cannot be written.
void print(std::string_view text);

}  // namespace texmap
