// A whole file, read into memory.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace texmap {

/// The bytes of a regular file of 1 byte to 64 MiB.
///
/// @param path  bytes as the system has them, in any encoding
/// Errors: FileError, also for a folder, pipe, device or changing file; never waits for a writer.
[[nodiscard]] std::vector<std::uint8_t> read_file(const std::string& path);

}  // namespace texmap
