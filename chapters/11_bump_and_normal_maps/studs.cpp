// A plate with studs, its normal map read in eight ways: which come out as bumps, which as dents?
#include "studs.hpp"

#include <cmath>

#include "engine/draw/render.hpp"

namespace texmap::chapter_11 {
namespace {

constexpr Vec3d plate_normal{0, 0, 1};

Hit<double> plate_hit(double x, double y) {
  const Vec3d p{x, y, 0};
  return {.normal = plate_normal, .point = p, .outside = p};
}

VAxis v_axis_of(const Reading& reading) { return reading.v_down ? VAxis::down : VAxis::up; }

/// A dome in the image: its center and radius in parts of the image, y up.
struct Dome {
  double x, y, radius;
};
constexpr std::array<Dome, 2> domes = {{{0.42, 0.56, 0.34}, {0.82, 0.20, 0.13}}};

/// The normal of the studs at a point of the image: x to its right edge, y to its upper edge.
Vec3d stud_normal(double x, double y) {
  for (const Dome& dome : domes) {
    const double right = (x - dome.x) / dome.radius;
    const double up = (y - dome.y) / dome.radius;
    const double from_center = right * right + up * up;
    if (from_center < 1) {  // a cap of a sphere, 53 degrees steep at its rim
      return {0.8 * right, 0.8 * up, std::sqrt(1 - 0.64 * from_center)};
    }
  }
  return plate_normal;
}

}  // namespace

std::array<Reading, 8> eight_readings(TangentRule rule) {
  std::array<Reading, 8> all;
  for (unsigned i = 0; i < 8; ++i)
    all[i] = {(i & 4U) != 0 ? Green::down : Green::up, (i & 1U) != 0, (i & 2U) != 0, rule};
  return all;
}

Verdict verdict_of(const Reading& reading) {
  const Hit<double> hit = plate_hit(0.3, 0.3);
  const Frame<double> frame = frame_about(hit.normal);
  const PlateMapping mapping{reading.u_mirrored, reading.v_down};
  const TangentFrame<double> by_uv = point_by_uv(frame, mapping(with_steps(hit, frame, 0.0)));
  const TangentFrame<double> used = tangents(reading.rule, hit.normal, by_uv);

  // Where the image's right and upper edge lie on the plate, and where red and green are applied.
  const Vec3d right = by_uv.tangent;
  const Vec3d top = reading.v_down ? -by_uv.bitangent : by_uv.bitangent;
  const Vec3d meant_by_green = reading.green == Green::up ? top : -top;
  const double red = dot(used.tangent, right);
  const double green = dot(used.bitangent, meant_by_green);

  // Slopes towards the lamp as they are meant and as they come out.
  const double along_red = dot(to_lamp, right);
  const double along_green = dot(to_lamp, meant_by_green);
  return {red * along_red * along_red + green * along_green * along_green > 0, red * green > 0};
}

Image stud_normals(int size, Green green) {
  return image_of(size, size, [=](int column, int row) {
    Vec3d normal = stud_normal((column + 0.5) / size, 1 - (row + 0.5) / size);
    if (green == Green::down) normal.y = -normal.y;
    return color_of_normal(normal);
  });
}

Image draw_plate(const Reading& reading, const Image& normals, int size) {
  const NormalMap<PlateMapping, BilinearTexture> map{
      .mapping = {reading.u_mirrored, reading.v_down},
      .texture = {normals, v_axis_of(reading)},
      .rule = reading.rule,
  };
  const Rgb color{0.93, 0.86, 0.74};
  return image_of(size, size, [&](int column, int row) {
    const Vec3d normal = map(plate_hit((column + 0.5) / size, 1 - (row + 0.5) / size), 0.0);
    const Rgb light = color * (0.1 + 0.9 * max(dot(normal, to_lamp), 0.0));
    return Rgb8{byte_of(light.r), byte_of(light.g), byte_of(light.b)};
  });
}

}  // namespace texmap::chapter_11
