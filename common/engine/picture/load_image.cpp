// From the name of a PNG or JPEG file to a picture.
#include "engine/picture/load_image.hpp"

#include "engine/picture/decode_image.hpp"
#include "engine/picture/files/read_file.hpp"

namespace texmap {

Image load_image(const std::string& path) {
  return with_name("cannot load texture", path, [&] { return decode_image(read_file(path)); });
}

}  // namespace texmap
