// What goes wrong with a file.
#pragma once
#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#ifdef _WIN32
#include "engine/files/utf8.hpp"
#endif

namespace texmap {

/// A file that cannot be read, understood or written. Functions that know its name say `cannot load
/// texture 'F': why` or `cannot write 'F': why` in what(); others say only why.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Joins what a file's user should know of it.
inline void add_note(std::string& note, std::string_view more) {
  if (!note.empty() && !more.empty()) note += "; it ";
  note += more;
}

/// The path that a user typed: UTF-8 on Windows, any bytes elsewhere.
[[nodiscard]] inline std::filesystem::path path_of(std::string_view typed) {
#ifdef _WIN32  // names of other systems in a file of the user's: a path must be UTF-8 here
  std::string good;
  while (!typed.empty()) append_utf8(good, take_character(typed));
  typed = good;
#endif
  return std::u8string(typed.begin(), typed.end());
}

/// A path as text, in the encoding of `path_of`.
[[nodiscard]] inline std::string name_of(const std::filesystem::path& path) {
  const std::u8string name = path.u8string();
  return {name.begin(), name.end()};
}

/// What `work` returns; a FileError from it gets `failed 'PATH': ` in front.
template <class Work>
auto with_name(const std::string& failed, const std::filesystem::path& path, Work work) {
  try {
    return work();
  } catch (const FileError& error) {
    std::string name = name_of(path);
    name.resize(std::min(name.size(), name.find('\0')));  // what() ends at a zero byte
    throw FileError(failed + " '" + name + "': " + error.what());
  }
}

}  // namespace texmap
