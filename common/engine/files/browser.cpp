// What the course asks of the operating system, answered in a browser, which has no files and no
// command line.
#include <cstdlib>
#include <ctime>

#include "engine/files/system.hpp"

namespace texmap {

// Weak: a module that keeps files has its own.
__attribute__((weak)) std::vector<std::uint8_t> read_file(const std::filesystem::path&,
                                                          std::uint64_t) {
  throw FileError("this page does not have the file");
}

void check_writable(const std::filesystem::path&) { throw FileError("a page cannot write files"); }
bool is_stream(const std::filesystem::path&) { return false; }
bool is_standard_output(const std::filesystem::path&) { return false; }
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t>) {
  check_writable(path);
}

std::filesystem::path program_folder() { return {}; }
std::filesystem::path folder_in_environment(const char*) { return {}; }
double thread_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
std::uint64_t free_memory() { return ~std::uint64_t{0}; }
std::string processor_name() { return "unknown"; }
double system_load() { return -1; }
bool stderr_is_watched() { return false; }
std::vector<std::string> typed_words(int, const char* const*) { return {}; }
void secure_standard_streams() {}
void end_with(std::string_view) { std::abort(); }

}  // namespace texmap
