// From an allowed error to the cheapest filter that keeps it in this scene.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "engine/run/filter_options.hpp"
#include "scene/camera.hpp"
#include "scene/floor.hpp"
#include "scene/nearest.hpp"
#include "texture/filters.hpp"

namespace texmap {
class Chosen;
}

namespace texmap::chapter_09 {

/// The filter that a budget allows.
struct FilterPlan {
  Filter filter;
  int taps;
  std::string text;  ///< a sentence that says why
};

/// What a plan asks of a lesson.
struct PlannedScene {
  Camera camera;
  /// The index of the globe that a ray sees; -1 for the floor, -2 for the sky.
  std::function<int(const Ray<double>&)> object_seen;
  /// The longer side of the footprint on that object, in texels.
  std::function<double(int object, const Ray<Dual<double>>&)> footprint_length;
  /// The light along a ray, by a filter.
  std::function<double(const FilterPlan& by, const Ray<Dual<double>>&)> light;
};

/// A lesson as a plan sees it. Must not outlive the lesson.
template <class Lesson>
[[nodiscard]] PlannedScene planned_scene(const Lesson& lesson) {
  const auto object_seen = [&lesson](const Ray<double>& ray) {
    const int index = static_cast<int>(find_nearest(lesson.objects, ray).index);
    if (index >= 0) return index;
    return distance_to(lesson.floor, ray) < infinity<double>() ? -1 : -2;
  };
  const auto length_on = [](const FilteredTexture& texture, const Uv<Dual<double>>& uv) {
    const PyramidLevel<int>& whole = texture.pyramid.levels.front();
    return footprint_of<double>(uv, whole.width, whole.height).longer;
  };
  const auto footprint_length = [&lesson, length_on](int object, const Ray<Dual<double>>& ray) {
    if (object < 0) {
      const auto point = point_on(lesson.floor, ray, distance_to(lesson.floor, ray));
      return length_on(lesson.ground.texture, lesson.ground.mapping(point));
    }
    const auto& seen = lesson.objects[static_cast<std::size_t>(object)];
    const auto normal = normal_at(seen.shape, ray, distance_to(seen.shape, ray));
    return length_on(seen.paint.texture, seen.paint.mapping(normal));
  };
  const auto light = [other = lesson](const FilterPlan& by, const Ray<Dual<double>>& ray) mutable {
    read_by(other, by.filter, by.taps);
    return other(ray).g.value;
  };
  return {lesson.stage.camera, object_seen, footprint_length, light};
}

/// The cheapest filter within the budget, tried on some 1,000 pixels that show a single object.
/// Where no pixel covers more than a texel the bilinear filter is enough, and nothing is tried.
///
/// @param levels         the allowed error, in levels of 255 of light: root mean square over pixels
/// @param width, height  of the picture
[[nodiscard]] FilterPlan plan_filter(const PlannedScene& scene, double levels, int width,
                                     int height);

/// The same for the user's budget, of which it prints the sentence; nothing without a budget.
///
/// @param scene  called if there is a budget
/// Errors: UsageError for a budget in texels, and for a filter and a budget.
[[nodiscard]] std::optional<FilterPlan> plan_by_budget(const std::function<PlannedScene()>& scene,
                                                       Chosen& chosen);

/// Leaves in a lesson what the user's scene shows, read by the filter that a budget allows.
template <class Lesson>
void choose_scene(Lesson& lesson, Chosen& chosen) {
  keep_scene(lesson);
  const auto plan = plan_by_budget([&] { return planned_scene(lesson); }, chosen);
  if (plan) read_by(lesson, plan->filter, plan->taps);
}

}  // namespace texmap::chapter_09
