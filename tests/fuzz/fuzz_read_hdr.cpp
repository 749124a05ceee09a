// Any bytes as a Radiance file: the reader loads or refuses them, and what loads can light a scene.
#include <cmath>

#include "engine/files/file_error.hpp"
#include "engine/files/read_hdr.hpp"
#include "engine/run/sky_options.hpp"
#include "fuzz/target.hpp"

namespace texmap::test {
namespace {

// The real limit is 2^23: memory for so many texels would take most of the time.
constexpr std::uint64_t most_texels = std::uint64_t{1} << 14;

void check_light(const Color<double>& light) {
  for (const double channel : {light.r, light.g, light.b})
    claim(channel >= 0 && channel <= brightest_texel, "light is 0 or more and not too bright");
}

bool same(const LightImage& a, const LightImage& b) {
  bool equal = a.width == b.width && a.height == b.height;
  for (std::size_t i = 0; equal && i < a.pixels.size(); ++i) {
    const Color<float>&p = a.pixels[i], &q = b.pixels[i];
    equal = p.r == q.r && p.g == q.g && p.b == q.b;
  }
  return equal;
}

void check_sky(LightImage image) {
  if (image.width % 2 != 0) return;  // refused later
  const SkyLight sky{Environment(std::move(image))};
  for (const Vec3<double>& way :
       {Vec3<double>{0, 1, 0}, Vec3<double>{-1, 1e-9, 0}, Vec3<double>{0.3, -0.5, 0.7}})
    check_light(sky(Ray<double>{{}, way}));
  const SkyNoise noise = noise_of(sky);
  for (const double of_way : {noise.cosine, noise.mis})
    claim(of_way >= 0 && std::isfinite(of_way), "the noise of a way is a number");
}

void try_file(Bytes file) {
  LightImage image = read_hdr(file, most_texels);
  claim(image.width >= 1 && image.height >= 1, "a picture has columns and rows");
  const auto texels =
      static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  claim(image.pixels.size() == texels && texels <= most_texels, "a picture is whole");
  for (const Color<float>& texel : image.pixels) check_light(number_cast<double>(texel));
  try {
    claim(same(read_hdr(file.first(file.size() - 1), most_texels), image),
          "a file without its last byte is the same picture or none");
  } catch (const FileError&) {  // none
  }
  check_sky(std::move(image));
}

}  // namespace
}  // namespace texmap::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (!texmap::looks_like_hdr({data, size})) return 0;
  return texmap::test::loads_or_refuses([&] { texmap::test::try_file({data, size}); });
}
