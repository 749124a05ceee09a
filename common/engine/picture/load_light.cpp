// From the name of a PNG, JPEG or Radiance .hdr file to light.
#include "engine/picture/load_light.hpp"

#include <string>

#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/codecs/read_hdr.hpp"
#include "engine/picture/codecs/read_jpeg.hpp"
#include "engine/picture/codecs/read_png.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/system/system.hpp"

namespace texmap {

LightImage load_light(const std::filesystem::path& path) {
  return with_name("cannot load texture", path, [&] {
    const auto file = read_file(path, max_file_bytes);
    if (looks_like_hdr(file)) return read_hdr(file, max_light_texels);
    if (!looks_like_png(file) && !looks_like_jpeg(file))
      throw FileError("it is not a PNG, JPEG or Radiance .hdr file, whatever its name says");
    const Image image = decode_image(file);
    if (image.pixels.size() > max_light_texels) {
      throw FileError("its size is " + std::to_string(image.width) + " x " +
                      std::to_string(image.height) + " pixels, and a sky may have at most " +
                      std::to_string(max_light_texels) + "; save it smaller");
    }
    return light_of(image, TexelLight::linear);
  });
}

}  // namespace texmap
