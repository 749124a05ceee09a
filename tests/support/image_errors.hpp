// The message of an ImageError.
#pragma once
#include <string>

#include "image_error.hpp"

namespace texmap::test {

/// What an ImageError thrown by `work` says, or "nothing was thrown". Other exceptions go on.
template <class Work>
[[nodiscard]] std::string image_error_of(Work work) {
  try {
    work();
  } catch (const ImageError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace texmap::test
