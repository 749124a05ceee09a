// The source documents' conventions for (u, v) on a sphere, and how they are related.
#pragma once
#include "texture/image_texture.hpp"
#include "texture/uv.hpp"

namespace texmap {

/// Where (0, 0) is and which way u and v run. To add one, name it here, and its word in
/// engine/run/options.cpp: the compiler asks for the rest.
enum class Convention {
  daily,    ///< the daily exercise: u runs west from -x, v down from the north pole
  rtiow,    ///< One Weekend 2020 and Next Week: u runs east from -x, v up from the south pole
  lecture,  ///< the lecture: u runs east from +z, v up from the south pole
};

/// Which way v runs over an image in this convention.
[[nodiscard]] constexpr VAxis v_axis_of(Convention convention) {
  switch (convention) {
    case Convention::daily:
      return VAxis::down;
    case Convention::rtiow:
    case Convention::lecture:
      break;
  }
  return VAxis::up;
}

/// Converts coordinates from Next Week's convention: u_daily = 1 - u, v_daily = 1 - v,
/// u_lecture = frac(u - 1/4), each rounded once; docs/conventions.md derives them.
template <class Real>
[[nodiscard]] Uv<Real> in_convention(Convention convention, const Uv<Real>& uv) {
  switch (convention) {
    case Convention::daily:
      // 1 - 0 would be 1, which is not in [0, 1).
      return {clamp_u(select(uv.u > Real(0), Real(1) - uv.u, -uv.u)), Real(1) - uv.v};
    case Convention::lecture: {
      const Real u = uv.u - Real(0.25);
      return {clamp_u(select(u < Real(0), u + Real(1), u)), uv.v};
    }
    case Convention::rtiow:
      break;
  }
  return uv;
}

/// Texture coordinates of a direction in a convention.
///
/// @param p  any finite vector; only its direction matters
/// @return   u in [0, 1), v in [0, 1]; for zero (0.5, 0.5), in lecture (0.25, 0.5)
template <class Real>
[[nodiscard]] Uv<Real> uv_of(Convention convention, const Vec3<Real>& p) {
  return in_convention(convention, uv_rtiow(p));
}

/// uv_of as a mapping.
struct ConventionMapping {
  Convention convention = Convention::rtiow;

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(const Vec3<Real>& p) const {
    return uv_of(convention, p);
  }
};

}  // namespace texmap
