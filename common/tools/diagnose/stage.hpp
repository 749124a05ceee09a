// What a chapter on the stage computes at each pixel, kept for slips to compute otherwise.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/draw/render.hpp"
#include "engine/run/prepared.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image.hpp"
#include "texture/uv.hpp"
#include "wrong_light.hpp"

namespace texmap::slips {

/// What the ray through a pixel's center meets.
struct Seen {
  int column = 0, row = 0;
  int object = -1;  ///< -1: the sky
  Rgb color{};      ///< as the lesson computes it
  std::optional<mistakes::Lit> lit{};
  double radius = 1;
  Vec3d direction{};    ///< that the mapping is given: the normal, turned where the lesson turns it
  bool mapped = false;  ///< by uv_rtiow of `direction`
  bool on_checkers = false;  ///< else the color is read in the picture
};

template <class... Paints, class Visit>
void visit_paint(const AnyOf<Paints...>& paint, const Visit& visit) {
  std::visit(visit, static_cast<const std::variant<Paints...>&>(paint));
}
template <class Paint, class Visit>
void visit_paint(const Paint& paint, const Visit& visit) {
  visit(paint);
}

/// A chapter's stage at every third pixel of every third row.
struct StageView {
  std::string chapter;  ///< its folder
  int width = 800, height = 600;
  std::vector<Seen> pixels{};
  Image picture{};  ///< of the texture; empty if there is none
  Checkerboard checkers{};
  RotationY turn{};  ///< of the directions that the mapping is given
};
inline constexpr int lattice = 3;

/// Lessons of spheres in the light of the stage; a reader's own may draw something else.
template <class Lesson>
concept HasStageLight = mistakes::HasHighlight<Lesson> || requires(const Lesson& lesson) {
  lesson.surface;
};
template <class Lesson>
concept OfTheStage = HasStageLight<Lesson> && requires(const Lesson& lesson) {
  lesson.objects.front().shape.radius;
  lesson.stage.sky;
};

template <OfTheStage Lesson>
[[nodiscard]] StageView view_stage(std::string_view chapter) {
  const Lesson lesson = prepared<Lesson>();
  StageView stage{.chapter = std::string(chapter)};
  const View<> view = view_of(lesson.stage.camera, stage.width, stage.height);
  for (int row = 1; row < stage.height; row += lattice) {
    for (int column = 1; column < stage.width; column += lattice) {
      const Ray<double> ray = ray_through<double>(view, column, row);
      Seen seen{.column = column, .row = row, .color = lesson(ray)};
      const auto keep = [&](const auto& object, const Hit<double>& hit, bool) {
        seen.object = hit.object;
        seen.lit.emplace(lesson, object, object.paint(hit), hit, ray);
        seen.direction = hit.normal;
        seen.radius = object.shape.radius;
        const auto keep_paint = [&](const auto& paint) {
          if constexpr (requires { paint.mapping.rotation; }) {
            stage.turn = paint.mapping.rotation;
            seen.direction = stage.turn(hit.normal);
          }
          if constexpr (requires { paint.texture.squares; }) {
            seen.on_checkers = seen.mapped = true;
            stage.checkers = paint.texture;
          } else if constexpr (requires { paint.texture.image; }) {
            seen.mapped = true;
            if (stage.picture.pixels.empty()) stage.picture = paint.texture.image;
          }
        };
        visit_paint(object.paint, keep_paint);
      };
      for_each_hit(lesson.objects, ray, find_nearest(lesson.objects, ray), keep);
      stage.pixels.push_back(seen);
    }
  }
  return stage;
}

/// A chapter that can be viewed: stages.cmake lists them. Of another scene there are no pixels.
struct OnStage {
  std::string_view name;
  StageView (*view)(std::string_view chapter);
};
template <class Lesson>
constexpr OnStage on_stage(std::string_view name) {
  return {name, [](std::string_view chapter) -> StageView {
            if constexpr (OfTheStage<Lesson>) {
              return view_stage<Lesson>(chapter);
            } else {
              return {.chapter = std::string(chapter)};
            }
          }};
}
[[nodiscard]] const std::vector<OnStage>& stages();

}  // namespace texmap::slips
