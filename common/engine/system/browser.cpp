// What the course asks of the operating system, answered in a browser: files are those that the
// page handed over, nothing is written, and nobody types words.
#include "engine/system/browser.hpp"

#include <cstdlib>
#include <ctime>
#include <map>

#include "engine/system/system.hpp"

namespace texmap {
namespace {

std::map<std::string, std::vector<std::uint8_t>>& files() {
  static std::map<std::string, std::vector<std::uint8_t>> kept;
  return kept;
}

}  // namespace

void keep_file(const std::string& name, std::vector<std::uint8_t> bytes) {
  files()[name] = std::move(bytes);
}

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  const auto file = files().find(name_of(path.filename()));
  if (file == files().end()) throw FileError("this page does not have the file");
  if (file->second.empty()) throw FileError("it is empty");
  if (file->second.size() > most_bytes) {
    throw FileError("it has more than " + std::to_string(most_bytes >> 20) + " MiB");
  }
  return file->second;
}

void check_writable(const std::filesystem::path&) { throw FileError("a page cannot write files"); }
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t>) {
  check_writable(path);
}

std::filesystem::path program_folder() { return {}; }
std::filesystem::path folder_in_environment(const char*) { return {}; }
double thread_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
std::string processor_name() { return "unknown"; }
double system_load() { return -1; }
bool stderr_is_watched() { return false; }
std::vector<std::string> typed_words(int, const char* const*) { return {}; }
void secure_standard_streams() {}
void end_with(std::string_view) { std::abort(); }

}  // namespace texmap
