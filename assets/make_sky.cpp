// A sky with a sun, clouds, hills and a meadow, as light.
#include "make_sky.hpp"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "math/color.hpp"
#include "math/vec3.hpp"
#include "noise.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap {
namespace {

constexpr Rgb zenith{0.10, 0.19, 0.46};
constexpr Rgb haze{0.52, 0.60, 0.70};
constexpr Rgb cloud{0.75, 0.74, 0.73};
constexpr Rgb sunlight{900, 780, 590};
constexpr double sun_edge = 0.9997;  // the cosine of its radius: 1.4 degrees

Rgb blend(const Rgb& a, const Rgb& b, double t) { return texmap::mix(a, b, t); }

Rgb clear_sky(const Vec3d& d, double to_sun) {
  const double low = (1 - d.y) * (1 - d.y);
  const Rgb blue = blend(zenith, haze, low * low);
  const double glow = 0.01 / (1.01 - to_sun);  // 1 at the sun
  return blue + Rgb{0.55, 0.42, 0.25} * (glow + glow * glow);
}

Rgb with_clouds(const Rgb& sky, const Vec3d& d) {
  const double scale = 1.4 / (d.y + 0.12);
  const double noise = layered_noise(d.x * scale + 5, 3.5, d.z * scale - 2, 5);
  const double cover = smooth_step((noise - 0.02) * 3.2) * smooth_step(d.y * 9);
  const double shade = 0.8 + 0.35 * layered_noise(d.x * scale + 5.3, 7.5, d.z * scale - 1.7, 3);
  return blend(sky, cloud * shade, cover * 0.9);
}

/// How high the hills reach in a direction: a coordinate y.
double ridge(const Vec3d& d, double seed, double height) {
  const double wide = std::sqrt(d.x * d.x + d.z * d.z);
  const double x = d.x / wide, z = d.z / wide;
  return height * (1 + 0.9 * layered_noise(3 * x + seed, seed, 3 * z - seed, 5));
}

Rgb meadow(const Vec3d& d) {
  const double scale = 1 / (0.06 - d.y);
  const double grass = layered_noise(d.x * scale * 1.5, 11.5, d.z * scale * 1.5, 4);
  const double field = smooth_step(3 * layered_noise(d.x * scale * 0.4, 1.5, d.z * scale * 0.4, 2));
  const Rgb green = blend({0.075, 0.12, 0.032}, {0.20, 0.18, 0.07}, field);
  return blend(green * (1 + 0.5 * grass), haze * 0.6, 0.06 / (0.06 - d.y) * 0.8);
}

}  // namespace

LightImage make_sky() {
  const Vec3d sun = normalize(Vec3d{-0.62, 0.65, 0.78});
  LightImage image(384, 192);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const Vec3d d =
          direction_rtiow(Uv<double>{(column + 0.5) / image.width, 1 - (row + 0.5) / image.height});
      const double to_sun = dot(d, sun);
      const double disk = smooth_step((to_sun - (2 * sun_edge - 1)) / (1 - sun_edge));
      Rgb light = with_clouds(clear_sky(d, to_sun), d) + sunlight * (disk * disk);
      const double texel = 3.14 / image.height;
      const auto cover = [&](const Rgb& color, double top) {  // with a smooth edge
        light = blend(light, color, std::clamp((top - d.y) / texel + 0.5, 0.0, 1.0));
      };
      cover(blend({0.09, 0.13, 0.16}, haze, 0.35), ridge(d, 8.5, 0.075));
      cover(blend({0.05, 0.085, 0.035}, haze * 0.6, 0.25), ridge(d, 2.5, 0.035));
      cover(meadow({d.x, std::min(d.y, 0.0), d.z}), 0);
      image.at(column, row) = {static_cast<float>(light.r), static_cast<float>(light.g),
                               static_cast<float>(light.b)};
    }
  }
  return image;
}

std::vector<std::uint8_t> radiance_file(const LightImage& light) {
  std::string file;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  static_assert(sizeof(Color<float>) == 3 * sizeof(float));
  stbi_write_hdr_to_func(append, &file, light.width, light.height, 3, &light.pixels[0].r);
  return {file.begin(), file.end()};
}

}  // namespace texmap
