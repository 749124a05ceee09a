// Normal maps: images of normals, relative to a frame that follows (u, v) over the surface.
#pragma once
#include <cmath>
#include <cstdint>

#include "math/color.hpp"
#include "scene/steps.hpp"
#include "texture/image.hpp"
#include "texture/mapped.hpp"

namespace texmap {

/// Which way the green channel of a file points.
enum class Green {
  up,    ///< green is bright where the surface faces the image's upper edge
  down,  ///< green is bright where it faces the lower edge
};

/// The two vectors along the surface that red and green are measured along.
template <class Real>
struct TangentFrame {
  Vec3<Real> tangent, bitangent;
};

/// How a program finds the tangent and the bitangent. To add a way, name it in tangents, too.
enum class TangentRule {
  from_uv,  ///< along dP/du and along dP/dv
  crossed,  ///< along dP/du; normal x tangent, which forgets mirrored coordinates
  fixed,    ///< +y x normal; normal x tangent: they ignore (u, v) (the daily exercise)
};

/// dP/du and dP/dv, not of unit length: how the surface point moves with the coordinates.
///
/// @param uv  with its derivatives by steps along `frame`: a mapping called with with_steps(...)
/// Where u or v does not change along the surface, at a pole: infinite or NaN.
template <class Real>
[[nodiscard]] TangentFrame<Real> point_by_uv(const Frame<Real>& frame, const Uv<Dual<Real>>& uv) {
  // The inverse of the matrix of derivatives of (u, v).
  const Real inverse = Real(1) / (uv.u.dx * uv.v.dy - uv.u.dy * uv.v.dx);
  return {(frame.right * uv.v.dy - frame.up * uv.v.dx) * inverse,
          (frame.up * uv.u.dx - frame.right * uv.u.dy) * inverse};
}

/// The unit tangent and bitangent at a normal by a rule.
template <class Real>
[[nodiscard]] TangentFrame<Real> tangents(TangentRule rule, const Vec3<Real>& normal,
                                          const TangentFrame<Real>& by_uv) {
  switch (rule) {
    case TangentRule::fixed: {
      const Vec3<Real> east = normalize(Vec3<Real>{normal.z, Real(0), -normal.x});
      return {east, cross(normal, east)};
    }
    case TangentRule::crossed: {
      const Vec3<Real> tangent = normalize(by_uv.tangent);
      return {tangent, cross(normal, tangent)};
    }
    case TangentRule::from_uv:
      break;
  }
  return {normalize(by_uv.tangent), normalize(by_uv.bitangent)};
}

/// A normal from a color: each channel c means 2c - 1. Not of unit length.
/// No byte means 0: the flat color (128, 128, 255) leans by 0.32 degrees.
template <class Real>
[[nodiscard]] Vec3<Real> normal_of_color(const Color<Real>& color) {
  const auto signed_part = [](const Real& c) { return c + c - Real(1); };
  return {signed_part(color.r), signed_part(color.g), signed_part(color.b)};
}

/// The nearest color of 8 bits to a unit normal: each part within 1/255.
[[nodiscard]] inline Rgb8 color_of_normal(const Vec3d& normal) {
  const auto byte = [](double part) {
    return static_cast<std::uint8_t>(clamp(std::floor((part + 1) * 127.5 + 0.5), 0.0, 255.0));
  };
  return {byte(normal.x), byte(normal.y), byte(normal.z)};
}

/// A normal map on a surface.
template <class Mapping, class Texture>
struct NormalMap {
  Mapping mapping;
  Texture texture;
  Green green = Green::up;  ///< how the program reads the file: up points along +v
  TangentRule rule = TangentRule::from_uv;

  /// The unit normal at a hit. Where the map or its frame is not finite: the surface's own.
  ///
  /// @param curvature  of the surface: 1 / radius on a sphere, 0 on a plane
  template <class Real>
  [[nodiscard]] Vec3<Real> operator()(const Hit<Real>& hit, const Real& curvature) const {
    const Frame<Real> frame = frame_about(hit.normal);
    const Uv<Dual<Real>> moving = uv_at(mapping, with_steps(hit, frame, curvature));
    const Uv<Real> uv{moving.u.value, moving.v.value};
    const TangentFrame<Real> along = tangents(rule, hit.normal, point_by_uv(frame, moving));
    const Vec3<Real> n = normal_of_color(texture(uv));
    const Real sign = green == Green::up ? Real(1) : Real(-1);
    const Vec3<Real> sum = along.tangent * n.x + along.bitangent * (n.y * sign) + hit.normal * n.z;
    const Real size = dot(sum, sum);
    const Mask<Real> usual = size > Real(0) && size < infinity<Real>();
    return select(usual, normalize(sum), hit.normal);
  }
};

}  // namespace texmap
