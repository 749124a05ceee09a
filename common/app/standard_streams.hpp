// Standard input, output and error, made safe to use.
#pragma once
#include <string_view>

namespace texmap {

/// Opens /dev/null in the place of each standard stream that the caller closed. Without it the first file opened would get a
/// standard stream's number, and messages would be written into the picture. Also makes a closed pipe an error, not a signal.
void secure_standard_streams();

/// Writes `text` to stdout, at once.
/// Errors: std::runtime_error when it cannot be written, such as on a full disk.
void print(std::string_view text);

}  // namespace texmap
