// What the files of exercises include: vectors, (u, v) and colors, all in double.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "math/color.hpp"
#include "math/srgb.hpp"
#include "math/vec3.hpp"
#include "texture/image.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

/// Blue, green and red of each texel, row after row from the top: bytes[0] is the first one's blue.
/// A row is filled up with zeros to a multiple of 4 bytes. Beyond the ends there are zeros, too, so
/// that a wrong number is a wrong color and no crash.
class Bytes {
 public:
  explicit Bytes(const Image& image) : image_(&image) {}

  [[nodiscard]] static int row_bytes(const Image& image) { return (3 * image.width + 3) / 4 * 4; }

  int operator[](long long i) const {
    const int length = row_bytes(*image_);
    const auto row = i / length, in_row = i % length;
    if (i < 0 || row >= image_->height || in_row >= 3LL * image_->width) return 0;
    const Rgb8& texel = image_->at(static_cast<int>(in_row / 3), static_cast<int>(row));
    return in_row % 3 == 0 ? texel.b : in_row % 3 == 1 ? texel.g : texel.r;
  }

 private:
  const Image* image_;
};

}  // namespace texmap::check

using Vec3 = texmap::Vec3<double>;    // .x .y .z, with + - * dot cross length normalize
using Uv = texmap::Uv<double>;        // .u .v, with + and *
using Color = texmap::Color<double>;  // .r .g .b, 0 to 1
using Bytes = texmap::check::Bytes;   // a picture file's: bytes[0], bytes[1] ...

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// The distance to the first sphere along a ray, in lengths of `direction`; infinity if there is
// none.
using FirstHit = std::function<double(Vec3 origin, Vec3 direction)>;

// A way to draw a picture: its time, and how far off a place on the texture is, in texels.
struct Way {
  double ms, seen, at_most;
};

// An object that a ray meets: how far away, and the light that arrives there.
struct Met {
  double distance, light;
};

// How bright the texture of an object is where the ray meets it.
using PaintOf = std::function<double(int object)>;

inline Vec3 operator*(const Vec3& v, double factor) {  // of an int, too
  return {v.x * factor, v.y * factor, v.z * factor};
}
inline Vec3 operator*(double factor, const Vec3& v) { return v * factor; }
inline Vec3 operator/(const Vec3& v, double divisor) { return v * (1 / divisor); }
inline Color operator*(const Color& c, double factor) {
  return {c.r * factor, c.g * factor, c.b * factor};
}
inline Color operator*(double factor, const Color& c) { return c * factor; }
inline Color operator/(const Color& c, double divisor) { return c * (1 / divisor); }
inline Color operator-(const Color& c) { return c * -1.0; }
inline Color operator-(const Color& a, const Color& b) { return a + -b; }
inline Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }
inline Vec3& operator-=(Vec3& a, const Vec3& b) { return a = a - b; }
inline Vec3& operator*=(Vec3& v, double factor) { return v = v * factor; }
inline Uv operator*(const Uv& uv, double factor) { return {uv.u * factor, uv.v * factor}; }
inline Uv operator*(double factor, const Uv& uv) { return uv * factor; }
inline Uv operator+(const Uv& a, const Uv& b) { return {a.u + b.u, a.v + b.v}; }
inline Color& operator+=(Color& a, const Color& b) { return a = a + b; }
inline Color& operator*=(Color& c, double factor) { return c = c * factor; }

// From an encoded number to light, both 0 to 1; and back.
inline double srgb_decode(double encoded) { return texmap::srgb_decode(encoded); }
inline double srgb_encode(double light) { return texmap::srgb_encode(light); }
