// What is the same on every system.
#include "engine/files/shared.hpp"

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "engine/files/system.hpp"

namespace texmap {

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

std::string words_of(const std::error_code& error) {
  using std::errc;
  static constexpr std::pair<errc, const char*> words[] = {
      {errc::no_such_file_or_directory, "there is no such file"},
      {errc::not_a_directory, "a part of the path is a file, not a folder"},
      {errc::permission_denied, "no permission"},
      {errc::operation_not_permitted, "no permission"},
      {errc::too_many_symbolic_link_levels,
       "too many symbolic links; one probably points back at itself"},
      {errc::filename_too_long, "the name is too long"},
      {errc::no_space_on_device, "the disk is full"},
      {errc::read_only_file_system, "the disk is read-only"},
      {errc::file_too_large, "the file would be larger than the system allows"},
      {errc::no_such_device_or_address, "nobody is at the other end of the pipe"},
  };
  for (const auto& [reason, text] : words) {
    if (error == reason) return text;
  }
  return error.message();
}

void check_name(const std::filesystem::path& path) {
  if (path.empty()) throw FileError("the name is empty");
  if (path.native().find(std::filesystem::path::value_type{}) != path.native().npos)
    throw FileError("the name has a zero byte in it");
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

void check_folder(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(folder, error);
  if (error == std::errc::no_such_file_or_directory)
    throw FileError("the folder '" + name_of(folder) + "' does not exist");
  if (error) throw FileError(words_of(error));
  if (!std::filesystem::is_directory(status))
    throw FileError("'" + name_of(folder) + "' is a file, not a folder");
}

void write_text_atomically(const std::filesystem::path& path, std::string_view text) {
  write_file_atomically(path,
                        std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw std::runtime_error("cannot write to standard output: " +
                             std::generic_category().message(errno));
  }
}

}  // namespace texmap
