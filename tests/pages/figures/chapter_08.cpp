// The figures of chapter 08's page.
#include <cmath>
#include <string>

#include "08_triangle_uv/lesson.hpp"
#include "figures.hpp"
#include "support/fragile_triangles.hpp"
#include "support/pictures.hpp"

namespace texmap::test {
namespace {

using chapter_08::Lesson;

/// The pixels that Heron's weights change.
template <class Real>
std::string changed_by_heron() {
  return whole(count_different(picture<Real>(prepared<Lesson>({"--weights", "heron"}), 480, 360),
                               picture<Real>(prepared<Lesson>(), 480, 360)));
}

/// A channel of --show uv: the part after the decimal point as a byte.
std::string byte_of(double coordinate) {
  return whole(static_cast<long>(255 * (coordinate - std::floor(coordinate))));
}

/// What a pixel's center shows: (u, v), how it is mixed, and its bytes with --show uv.
void add_pixel(Figures& figures, const std::string& name, const Lesson& lesson, int column,
               int row) {
  const View<> view = view_of(lesson.stage.camera, 480, 360);
  const Ray<double> ray = ray_through<double>(view, column, row);
  const MeshHit<double> hit = first_hit(lesson.scene.mesh, ray);
  const Uv<double> uv = lesson.scene.mapping(hit);
  std::string corners;
  for (const Uv<double>& corner :
       lesson.scene.mapping.corners.at(static_cast<std::size_t>(hit.triangle))) {
    corners += (corners.empty() ? "(" : ", (") + whole(std::lround(corner.u)) + ", " +
               whole(std::lround(corner.v)) + ")";
  }
  figures.emplace_back("08.corners_" + name, corners);
  figures.emplace_back("08.weights_" + name,
                       decimals(hit.a, 5) + ", " + decimals(hit.b, 5) + ", " + decimals(hit.c, 5));
  figures.emplace_back("08.uv_" + name, decimals(uv.u, 3) + ", " + decimals(uv.v, 3));
  figures.emplace_back("08.bytes_" + name, byte_of(uv.u) + ", " + byte_of(uv.v));
}

}  // namespace

void figures_of_08(Figures& figures) {
  const auto lesson = prepared<Lesson>();
  add_pixel(figures, "below", lesson, 220, 230);
  add_pixel(figures, "above", lesson, 150, 160);
  add_pixel(figures, "floor", lesson, 50, 310);

  figures.emplace_back("08.heron_in_double", changed_by_heron<double>());
  figures.emplace_back("08.heron_in_float", changed_by_heron<float>());
  for (const int aspect : {16, 256, 4096}) {
    const auto errors = needle_errors<float>(aspect, 2000);
    const std::string length = std::to_string(aspect);
    figures.emplace_back("08.signed_" + length, whole(std::lround(errors.signed_areas)));
    figures.emplace_back("08.heron_" + length, whole(std::lround(errors.heron)));
  }
  const int rays = 20000;
  figures.emplace_back("08.rays", whole(rays));
  const TwoTests leaks = leaks_from_inside<float>(rays);
  figures.emplace_back("08.usual_cracks", whole(leaks.usual.cracks));
  figures.emplace_back("08.usual_doubles", whole(leaks.usual.doubles));
  figures.emplace_back("08.cracks", whole(leaks.signed_areas.cracks));
  figures.emplace_back("08.doubles", whole(leaks.signed_areas.doubles));
}

}  // namespace texmap::test
