// From the name of a PNG or JPEG file to a picture.
#include "engine/files/load_image.hpp"

#include "engine/files/decode_image.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/system.hpp"

namespace texmap {

Image load_image(const std::filesystem::path& path, std::string* note, DeepImage* deep,
                 int later_bytes) {
  return with_name("cannot load texture", path, [&] {
    return decode_image(read_file(path, max_file_bytes), note, deep, later_bytes);
  });
}

}  // namespace texmap
