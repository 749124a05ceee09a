// The message of an FileError.
#pragma once
#include <string>

#include "engine/system/file_error.hpp"

namespace texmap::test {

/// What an FileError thrown by `work` says, or "nothing was thrown". Other exceptions go on.
template <class Work>
[[nodiscard]] std::string image_error_of(Work work) {
  try {
    work();
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace texmap::test
