// What goes wrong with a picture's file.
#pragma once
#include <stdexcept>

namespace texmap {

/// A file that cannot be loaded or written. what() is a whole sentence: `cannot load texture 'F': why` or `cannot write 'F':
/// why`.
class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The why alone, thrown where the name of the file is not known; the functions that know it turn it into an ImageError.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace texmap
