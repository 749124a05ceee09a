// A plate with studs, its normal map read in eight ways: which come out as bumps, which as dents?
#pragma once
#include <array>
#include <string>

#include "texture/bilinear.hpp"
#include "texture/normal_map.hpp"

namespace texmap::chapter_11 {

/// A way to store a normal map and to lay it on a plate.
struct Reading {
  Green green = Green::up;  ///< of the file; the program always reads green as along +v
  bool u_mirrored = false;  ///< u runs to the left: the image lies mirrored on the plate
  bool v_down = false;      ///< v runs down, and row 0 of the image is at v = 0
  TangentRule rule = TangentRule::from_uv;
};

/// The eight ways, in the order of the sheet's columns.
[[nodiscard]] std::array<Reading, 8> eight_readings(TangentRule rule);

/// Coordinates of the plate from (0, 0, 0) to (1, 1, 0), which is seen from +z with +y up.
struct PlateMapping {
  bool u_mirrored = false;
  bool v_down = false;

  template <template <class> class AnyHit, class Real>
  [[nodiscard]] Uv<Real> operator()(const AnyHit<Real>& hit) const {
    const Real one = Real(1);
    return {u_mirrored ? one - hit.point.x : hit.point.x, v_down ? one - hit.point.y : hit.point.y};
  }
};

/// Points from the plate to its only lamp: above, a little to the left.
inline constexpr Vec3d to_lamp{-1.0 / 3, 2.0 / 3, 2.0 / 3};

/// What a plate looks like.
struct Verdict {
  bool bump = false;     ///< the lit side of a stud is the side towards the lamp
  bool surface = false;  ///< false if one direction is inverted: no surface has such normals

  [[nodiscard]] std::string word() const { return bump ? "bump" : "dent"; }
};

/// Computed from the directions alone, not from a picture: red is meant along the image's right
/// edge and green towards its upper (or lower) one; the program applies them along its tangents.
[[nodiscard]] Verdict verdict_of(const Reading& reading);

/// The normal map of a large stud and a small one, as a file with this green holds it.
[[nodiscard]] Image stud_normals(int size, Green green);

/// The plate under the lamp, size x size pixels.
[[nodiscard]] Image draw_plate(const Reading& reading, const Image& normals, int size);

}  // namespace texmap::chapter_11
