// The lecture's scene in one file. The chapter's program draws it with --scene lecture.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

const double pi = std::numbers::pi;
const double infinity = std::numeric_limits<double>::infinity();

struct Vec3 {  // a point, a direction, or a color: red, green, blue
  double x, y, z;
};
Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 normalize(Vec3 a) { return a * (1 / std::sqrt(dot(a, a))); }

struct Picture {  // what is wrapped round the globe; three bytes a texel, the top row first
  int width = 0, height = 0;
  std::vector<unsigned char> bytes;
};

struct Sphere {
  Vec3 center;
  double radius;
  Vec3 color;
  double diffuse;    // kd; the ambient ka is 0.2 and the specular ks is 0.3 for both
  double shininess;  // Phong's exponent
};

const Sphere globe{{0, 0, 0}, 1, {1, 1, 1}, 0.5, 500};
const Sphere ground{{0, -101, -1}, 100, {1, 1, 0}, 0.8, 50};
const Vec3 lamp{3, 2, 2}, eye{0, 0, 4};
const double share_of_texture = 0.3;  // t of the blend; the light has the share 1 - t
const int width = 800, height = width / 2;

// How far the ray from the eye goes until it meets the sphere; infinity if it misses.
double distance_to(const Sphere& sphere, Vec3 direction) {
  const Vec3 from_center = eye - sphere.center;
  const double b = -dot(from_center, direction);
  const double c = dot(from_center, from_center) - sphere.radius * sphere.radius;
  if (b * b < c) return infinity;
  const double distance = b - std::sqrt(b * b - c);
  return distance > 0 ? distance : infinity;
}

// The color of the texel where the globe's normal is `n`, in the lecture's convention.
Vec3 texel(const Picture& picture, Vec3 n) {
  double angle = std::atan2(n.x, n.z);
  if (angle < 0) angle += 2 * pi;
  const double u = angle / (2 * pi);                                // 0 at +z, growing eastward
  const double v = 1 - std::acos(std::clamp(n.y, -1.0, 1.0)) / pi;  // 0 at the south pole
  const int column = std::min(static_cast<int>(u * picture.width), picture.width - 1);
  const int row = std::min(static_cast<int>(v * picture.height), picture.height - 1);
  const unsigned char* t =
      &picture.bytes[3 *
                     static_cast<std::size_t>((picture.height - 1 - row) * picture.width + column)];
  return {t[0] / 255.0, t[1] / 255.0, t[2] / 255.0};
}

// The color that the ray from the eye sees.
Vec3 color_along(const Picture& picture, Vec3 direction) {
  const double to_globe = distance_to(globe, direction);
  const double to_ground = distance_to(ground, direction);
  if (to_globe == infinity && to_ground == infinity) return {0, 0, 0};
  const Sphere& sphere = to_globe < to_ground ? globe : ground;
  const Vec3 point = eye + direction * std::min(to_globe, to_ground);
  const Vec3 n = (point - sphere.center) * (1 / sphere.radius);
  const Vec3 l = normalize(lamp - point);
  const Vec3 r = n * (2 * dot(n, l)) - l;
  const Vec3 to_eye = direction * -1;
  double diffuse = 0.2, specular = 0;
  if (dot(n, l) > 0) {
    diffuse += sphere.diffuse * dot(n, l);
    specular = 0.3 * std::pow(std::max(0.0, dot(r, to_eye)), sphere.shininess);
  }
  if (&sphere == &ground) return ground.color * diffuse + Vec3{1, 1, 1} * specular;
  // The blend, texture t + light (1 - t), as a step from the light to the texture.
  const Vec3 light = Vec3{1, 1, 1} * std::min(diffuse + specular, 1.0);
  return light + (texel(picture, n) - light) * share_of_texture;
}

int main(int argc, char** argv) {
  std::string out = "out/06_one_file.png", texture = "assets/earth.png";
  for (int i = 1; i < argc; i += 2) {
    const std::string word = argv[i];
    if (i + 1 == argc || (word != "--out" && word != "--texture")) {
      std::cerr << "usage: 06_one_file [--texture FILE] [--out FILE.png]\n";
      return 2;
    }
    (word == "--out" ? out : texture) = argv[i + 1];
  }
  Picture picture;
  int channels = 0;
  unsigned char* loaded = stbi_load(texture.c_str(), &picture.width, &picture.height, &channels, 3);
  if (!loaded) {
    std::cerr << "error: " << texture << ": " << stbi_failure_reason() << '\n';
    return 1;
  }
  const auto texels =
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.bytes.assign(loaded, loaded + 3 * texels);
  stbi_image_free(loaded);

  std::vector<unsigned char> bytes;
  const double step = 4.0 / width;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const Vec3 through{-2 + step * i, 1 - step * j, 2};
      const Vec3 color = color_along(picture, normalize(through - eye));
      for (const double channel : {color.x, color.y, color.z}) {
        bytes.push_back(static_cast<unsigned char>(255 * std::min(channel, 1.0)));
      }
    }
  }
  std::error_code ignored;  // if there is no folder, the file cannot be written
  std::filesystem::create_directories(std::filesystem::path(out).parent_path(), ignored);
  if (!stbi_write_png(out.c_str(), width, height, 3, bytes.data(), 3 * width)) {
    std::cerr << "error: cannot write " << out << '\n';
    return 1;
  }
  std::cout << out << '\n';
}
