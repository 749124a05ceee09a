// From the name of a PNG, JPEG or Radiance .hdr file to light.
#include "engine/files/load_light.hpp"

#include "engine/files/decode_image.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/read_hdr.hpp"
#include "engine/files/read_jpeg.hpp"
#include "engine/files/read_png.hpp"
#include "engine/files/system.hpp"

namespace texmap {

LightImage load_light(const std::filesystem::path& path, std::string* note) {
  return with_name("cannot load texture", path, [&] {
    const auto file = read_file(path, max_file_bytes);
    if (looks_like_hdr(file)) return read_hdr(file, max_light_texels, note);
    if (!looks_like_png(file) && !looks_like_jpeg(file)) refuse_kind(file, true);
    const Image image = decode_image(file, note);
    check_sky_size(
        {static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height)},
        max_light_texels);
    return light_of(image, TexelLight::linear);
  });
}

}  // namespace texmap
