// What goes wrong with a file.
#pragma once
#include <stdexcept>
#include <string>

namespace texmap {

/// A file that cannot be read, understood or written. Functions that know its name say `cannot load
/// texture 'F': why` or `cannot write 'F': why` in what(); others say only why.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `work` returns; a FileError from it gets `failed 'PATH': ` in front.
template <class Work>
auto with_name(const std::string& failed, const std::string& path, Work work) {
  try {
    return work();
  } catch (const FileError& error) {
    // Up to a zero byte, if the name has one: what() ends there.
    const char* name = path.c_str();
    throw FileError(failed + " '" + name + "': " + error.what());
  }
}

}  // namespace texmap
