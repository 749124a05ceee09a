// What the course asks of the operating system. posix.cpp and windows.cpp answer; CMake chooses.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/file_error.hpp"

namespace texmap {

/// The bytes of a regular file of 1 byte to `most_bytes`.
///
/// Errors: FileError, also for a folder, pipe, device or changing file; never waits for a writer.
[[nodiscard]] std::vector<std::uint8_t> read_file(const std::filesystem::path& path,
                                                  std::uint64_t most_bytes);

/// Checks in advance that a file can be written: folder, length of the name, permissions.
/// Errors: FileError.
void check_writable(const std::filesystem::path& path);

/// What a path names is written to and not replaced: a device, a pipe, a stream that is open.
[[nodiscard]] bool is_stream(const std::filesystem::path& path);
/// It is the standard output, under any of its names.
[[nodiscard]] bool is_standard_output(const std::filesystem::path& path);

/// Writes the file all at once: at any moment the path names the whole old or the whole new file,
/// unless the machine itself stops.
/// Devices (/dev/null, NUL) are written to. On Windows Ctrl-C may leave a draft, .texmap-... there.
///
/// Errors: FileError; then the old file is unchanged, and nothing new is left behind.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// The same for a text.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

/// The folder of the running program; empty where the system does not tell.
[[nodiscard]] std::filesystem::path program_folder();

/// The folder that a variable of the environment names; empty if it is not set.
[[nodiscard]] std::filesystem::path folder_in_environment(const char* variable);

/// The processor's time that this thread has used, milliseconds; where the system counts it too
/// coarsely, the clock's.
[[nodiscard]] double thread_milliseconds();

/// Bytes of memory that the program can still get; 2^64 - 1 where the system does not tell.
[[nodiscard]] std::uint64_t free_memory();

/// The processor's name; "unknown" where the system does not tell.
[[nodiscard]] std::string processor_name();

/// How many programs wanted a processor, on average over the last minute; below 0 where the system
/// does not tell.
[[nodiscard]] double system_load();

/// Somebody watches standard error: it is a terminal.
[[nodiscard]] bool stderr_is_watched();

/// The words of the command line after the program's name, in the encoding of `path_of`.
[[nodiscard]] std::vector<std::string> typed_words(int argc, const char* const* argv);

/// Makes standard input, output and error safe to use. A stream that the caller closed is opened,
/// since the first file opened would get its number. A closed pipe becomes an error, not a signal.
void secure_standard_streams();

/// Lets the next picture, film or file have the memory of the last one. New pages would be cleared
/// by the system, which takes an eighth of a small picture's time; only for the GNU C library.
void keep_freed_memory();

/// Writes `text` to standard output, at once.
/// Errors: std::runtime_error if it cannot be written.
void print(std::string_view text);

/// Writes to standard error without asking for memory, and ends the program with status 1.
[[noreturn]] void end_with(std::string_view message);

}  // namespace texmap
