// A ray tracer in one file. It draws chapter 02's picture; with --plain, chapter 01's.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

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
double length(Vec3 a) { return std::sqrt(dot(a, a)); }
Vec3 normalize(Vec3 a) { return a * (1 / length(a)); }
Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Sphere {
  Vec3 center;
  double radius;
  Vec3 color;  // of a plain sphere
  bool checkered;
};

const Vec3 white{0.9, 0.9, 0.9}, blue{0.2, 0.2, 0.8}, red{1.0, 0.3, 0.3};
std::vector<Sphere> spheres = {
    {{0, 0, 0}, 1, white, true},
    {{-2.5, 0, 1}, 0.8, red, false},
    {{2.5, 0, 1}, 0.8, blue, true},
    {{0, -1001, 0}, 1000, white, true},  // the ground
};
const Vec3 lamp{5, 5, 5}, eye{0, 2, 8}, target{0, 0, 0};
const int width = 800, height = 600;

// How far the ray from `origin` goes until it meets the sphere; infinity if it misses.
double distance_to(const Sphere& sphere, Vec3 origin, Vec3 direction) {
  const Vec3 from_center = origin - sphere.center;
  const double b = -dot(from_center, direction);
  const double c = dot(from_center, from_center) - sphere.radius * sphere.radius;
  if (b * b < c) return infinity;
  const double root = std::sqrt(b * b - c);
  if (b - root > 0.001) return b - root;
  if (b + root > 0.001) return b + root;  // the ray begins inside
  return infinity;
}

struct Nearest {
  const Sphere* sphere;  // nullptr if the ray meets none
  double distance;
};

// The first sphere that the ray meets.
Nearest find_nearest(Vec3 origin, Vec3 direction) {
  Nearest nearest{nullptr, infinity};
  for (const Sphere& sphere : spheres) {
    const double distance = distance_to(sphere, origin, direction);
    if (distance < nearest.distance) nearest = {&sphere, distance};
  }
  return nearest;
}

// The color of a checkerboard where the sphere's normal is `n`.
Vec3 checkerboard(Vec3 n) {
  const double u = 0.5 + std::atan2(-n.z, n.x) / (2 * pi);       // longitude, 0 to 1
  const double v = std::acos(std::clamp(-n.y, -1.0, 1.0)) / pi;  // latitude, 0 to 1
  const int column = static_cast<int>(10 * u);
  const int row = static_cast<int>(10 * v);
  return (column + row) % 2 == 0 ? blue : white;
}

// The color that the ray from the eye sees.
Vec3 color_along(Vec3 direction) {
  const auto [sphere, distance] = find_nearest(eye, direction);
  if (!sphere) {  // the sky: white below, blue above
    const double t = (direction.y + 1) / 2;
    return Vec3{1, 1, 1} * (1 - t) + Vec3{0.5, 0.7, 1} * t;
  }
  const Vec3 point = eye + direction * distance;
  const Vec3 normal = (point - sphere->center) * (1 / sphere->radius);
  const Vec3 to_lamp = normalize(lamp - point);
  const double to_blocker = find_nearest(point, to_lamp).distance;
  double light = 0.2;
  if (to_blocker > length(lamp - point)) light += 0.8 * std::max(0.0, dot(normal, to_lamp));
  return (sphere->checkered ? checkerboard(normal) : sphere->color) * light;
}

int main(int argc, char** argv) {
  std::string file = "out/00_one_file.png";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--plain") {
      for (Sphere& sphere : spheres) sphere.checkered = false;
    } else if (word == "--out" && i + 1 < argc) {
      file = argv[++i];
    } else {
      std::cerr << "usage: 00_one_file [--plain] [--out FILE.png]\n";
      return 2;
    }
  }

  const Vec3 forward = normalize(target - eye);
  const Vec3 right = normalize(cross(forward, {0, 1, 0}));
  const Vec3 up = cross(right, forward);
  const double pixel = 2 * std::tan(30 * pi / 180) / height;  // the angle of view is 60 degrees
  std::vector<unsigned char> bytes;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double x = (column + 0.5 - width / 2.0) * pixel;
      const double y = (height / 2.0 - (row + 0.5)) * pixel;
      const Vec3 color = color_along(normalize(forward + right * x + up * y));
      for (const double channel : {color.x, color.y, color.z}) {
        bytes.push_back(static_cast<unsigned char>(255 * std::min(channel, 1.0)));
      }
    }
  }

  std::error_code ignored;  // if there is no folder, the file cannot be written
  std::filesystem::create_directories(std::filesystem::path(file).parent_path(), ignored);
  if (!stbi_write_png(file.c_str(), width, height, 3, bytes.data(), 3 * width)) {
    std::cerr << "error: cannot write " << file << '\n';
    return 1;
  }
  std::cout << file << '\n';
}
