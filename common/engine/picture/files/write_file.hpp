// Writes a file in one step: readers see the old file or the new one, never a part.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace texmap {

/// Checks in advance that a file can be written: folder, length of the name, permissions.
///
/// @param path  bytes as the system has them, in any encoding
/// Errors: FileError.
void check_writable(const std::string& path);

/// Writes the file all at once: at any moment the path names the whole old or the whole new file.
///
/// @param path   the file to make or replace; a device such as /dev/null or a pipe is written to
/// @param bytes  its contents
/// Errors: FileError; then the old file is unchanged, and nothing new is left behind.
void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace texmap
