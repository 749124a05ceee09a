// Draws each exhibit in float, double, extended and the judge. A file of its own, because it takes
// long to compile and seldom changes.
#include "exhibits.hpp"

#include <memory>

#include "engine/draw/draw.hpp"

namespace texmap::chapter_14 {
namespace {

template <class Real, class Scene>
void draw_row(Panel& panel, const Scene& scene, Formulas formulas, int row) {
  const View<> view = view_of(scene.camera, panel.image.width, panel.image.height);
  const auto byte = [](Real channel) { return byte_of(static_cast<double>(channel)); };
  for (int column = 0; column < view.width; ++column) {
    const SurfacePoint<Real> point = scene(ray_through(view, Real(column), Real(row)), formulas);
    panel.image.at(column, row) = {byte(point.color.r), byte(point.color.g), byte(point.color.b)};
    panel.points[static_cast<std::size_t>(row * view.width + column)] = {
        {},
        {number_cast<Judge>(point.uv.u), number_cast<Judge>(point.uv.v)},
        point.hit,
        point.mapped,
        number_cast<Judge>(point.round)};
  }
}

template <class Scene>
Exhibit exhibit_of(const Scene& moved) {
  const auto scene = std::make_shared<const Scene>(moved);
  return {scene->name, scene->caption,
          [scene](Panel& panel, Variant variant, int row) {
            const bool published = variant == published_float || variant == published_double;
            const Formulas formulas = published ? Formulas::published : Formulas::robust;
            if (variant == reference) return draw_row<Judge>(panel, *scene, formulas, row);
            if (variant == published_float || variant == robust_float)
              return draw_row<float>(panel, *scene, formulas, row);
            draw_row<double>(panel, *scene, formulas, row);
          },
          [scene](Formulas formulas, NumberKind number, int width, int height,
                  const RenderSettings& settings) {
            const SceneWith<Scene> drawn{*scene, formulas};
            const View<> view = view_of(scene->camera, width, height);
            return run_in_number(DrawWork<SceneWith<Scene>, false>{drawn, view, settings}, number,
                                 settings.instructions);
          }};
}

}  // namespace

std::vector<Exhibit> all_exhibits(const SharedImage& earth, const SharedImage& labels) {
  return std::apply([](const auto&... scene) { return std::vector<Exhibit>{exhibit_of(scene)...}; },
                    exhibit_scenes(earth, labels));
}

}  // namespace texmap::chapter_14
