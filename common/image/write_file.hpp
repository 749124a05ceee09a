// A whole file, written so that nobody ever sees a part of it.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace texmap {

/// Checks, before any work is done for it, that a file can be written: its folder exists, its name fits, permissions allow it.
///
/// @param path  bytes as the system has them, in any encoding
/// Errors: Refusal.
void check_writable(const std::string& path);

/// Puts the bytes into the file all at once: whoever opens the path finds the old file or the new one, whole, at any moment.
///
/// The bytes go into a file beside the target, which then takes its name. A symbolic link stays, and the file it points to is
/// replaced. A device such as /dev/null and a pipe cannot be replaced and are written to. A new file gets the permissions that
/// the umask leaves, a replaced one keeps its own. Signals that end the program wait until the file is whole.
///
/// @param path   the file to make or replace
/// @param bytes  its contents
/// Errors: Refusal; then the old file is as it was, and nothing new is left behind.
void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace texmap
