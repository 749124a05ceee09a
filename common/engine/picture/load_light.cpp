// From the name of a PNG, JPEG or Radiance .hdr file to light.
#include "engine/picture/load_light.hpp"

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
    check_sky_size(
        {static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height)},
        max_light_texels);
    return light_of(image, TexelLight::linear);
  });
}

}  // namespace texmap
