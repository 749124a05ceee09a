// From the name of a PNG or JPEG file to a picture.
#include "load_image.hpp"

#include "decode_image.hpp"
#include "read_file.hpp"

namespace texmap {

Image load_image(const std::string& path) {
  try {
    return decode_image(read_file(path));
  } catch (const Refusal& refusal) {
    // Up to a zero byte, if the name has one: what() ends there.
    const char* name = path.c_str();
    throw ImageError(std::string("cannot load texture '") + name + "': " + refusal.what());
  }
}

}  // namespace texmap
