// What a chapter on the stage computes at each pixel, kept for slips to compute otherwise.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/draw/render.hpp"
#include "engine/files/text.hpp"
#include "engine/run/draw_lesson.hpp"
#include "option_slips.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image.hpp"
#include "texture/uv.hpp"
#include "wrong_light.hpp"

namespace texmap::slips {

/// What the ray through a pixel's center meets.
struct Seen {
  int column = 0, row = 0;
  int object = -1;    ///< -1: the sky
  Rgb color{};        ///< as the lesson computes it
  double height = 0;  ///< y of the ray's direction
  std::optional<mistakes::Lit> lit{};
  double radius = 1;
  Vec3d direction{};    ///< that the mapping is given: the normal, turned where the lesson turns it
  bool mapped = false;  ///< by uv_rtiow of `direction`
  bool on_checkers = false;  ///< else the color is read in the picture
  bool shines = false;       ///< in the highlight: its pixels are counted apart
};

template <class... Paints, class Visit>
void visit_paint(const AnyOf<Paints...>& paint, const Visit& visit) {
  std::visit(visit, static_cast<const std::variant<Paints...>&>(paint));
}
template <class Paint, class Visit>
void visit_paint(const Paint& paint, const Visit& visit) {
  visit(paint);
}

/// A mistake at one place of the path.
struct Slip {
  std::string words;   ///< as in known_mistakes.hpp, whose cards it shares
  std::string change;  ///< what to write instead; empty where a card says it
};

inline constexpr int lattice = 3;
struct StageView;

/// Called with a slip, and with what views the stage that it draws at every n-th pixel.
using Visit =
    std::function<void(const Slip& slip, const std::function<StageView(int every)>& view)>;

/// How far a channel may be off where the same was computed, and where light was gathered by other
/// random numbers.
inline constexpr int of_rounding = 2, of_noise = 24;

/// A chapter's stage at every third pixel of every third row, or at fewer.
struct StageView {
  std::string chapter{};  ///< its folder
  int width = 800, height = 600;
  std::vector<Seen> pixels{};
  SharedImage picture{};  ///< of the texture; empty if there is none
  Checkerboard checkers{};
  RotationY turn{};  ///< of the directions that the mapping is given
  GradientSky sky{};
  std::vector<std::string> options{};  ///< that its lesson has
  int tolerance = of_rounding;         ///< levels
  /// What its mistakes draw, by their number and by the distance of its pixels.
  std::shared_ptr<std::map<std::pair<int, int>, Image>> drawn_before{};
  void (*visit_changed)(const StageView& stage, const Visit& visit) = nullptr;
};

/// How a wrong program traces rays; by default as the lesson does.
struct Tracing {
  bool draws_last = false;  ///< of the objects that a ray meets, and not the nearest
  /// The way to the lamp, of any length, whose square the sphere's formula takes for 1.
  Vec3d (*to_lamp)(const Point& lamp, const Point& point) = nullptr;
};

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

/// True if a sphere lies on the way, by a formula for ways of length 1.
[[nodiscard]] inline bool hides(const Sphere<>& sphere, const Ray<double>& way, double distance) {
  const Vec3d from_center = way.origin - sphere.center;
  const double b = -dot(from_center, way.direction);
  const double root =
      std::sqrt(b * b - dot(from_center, from_center) + sphere.radius * sphere.radius);
  const auto is_between = [&](double t) { return t > 0.001 && t < distance; };
  return is_between(b - root) || is_between(b + root);  // NaN is not
}

/// What a ray meets. Its paint's texture and turn go to the stage.
template <OfTheStage Lesson>
[[nodiscard]] Seen see(const Lesson& lesson, const Ray<double>& ray, StageView& stage,
                       const Tracing& tracing = {}) {
  Seen seen{.height = ray.direction.y};
  const auto keep = [&](const auto& object, const Hit<double>& hit, bool) {
    seen.object = hit.object;
    seen.lit.emplace(lesson, object, object.paint(hit), hit, ray);
    if (tracing.to_lamp != nullptr) {
      const Vec3d path = tracing.to_lamp(lesson.stage.light.position, hit.point);
      const bool hidden =
          std::any_of(lesson.objects.begin(), lesson.objects.end(), [&](const auto& other) {
            return hides(other.shape, {hit.point, path}, length(seen.lit->to_lamp));
          });
      seen.lit->light.to_light = path;
      seen.lit->light.cosine = hidden ? 0 : std::max(dot(hit.normal, path), 0.0);
    }
    seen.shines = seen.lit->specular() > 0.02;
    seen.direction = hit.normal;
    seen.radius = object.shape.radius;
    visit_paint(object.paint, [&](const auto& paint) {
      if constexpr (requires { paint.mapping.rotation; }) {
        stage.turn = paint.mapping.rotation;
        seen.direction = stage.turn(hit.normal);
      }
      if constexpr (requires { paint.texture.squares; }) {
        seen.on_checkers = seen.mapped = true;
        stage.checkers = paint.texture;
      } else if constexpr (requires { paint.texture.image; }) {
        seen.mapped = true;
        stage.picture = paint.texture.image;
      }
    });
  };
  Nearest<double> met = find_nearest(lesson.objects, ray);
  for (std::size_t i = 0; tracing.draws_last && i < lesson.objects.size(); ++i) {
    const double distance = distance_to(lesson.objects[i].shape, ray);
    if (distance < infinity<double>()) met = {distance, static_cast<double>(i)};
  }
  for_each_hit(lesson.objects, ray, met, keep);
  const bool is_wrong = tracing.draws_last || tracing.to_lamp != nullptr;
  seen.color = is_wrong && seen.lit ? seen.lit->right() : lesson(ray);
  return seen;
}

template <OfTheStage Lesson>
[[nodiscard]] StageView view_stage(std::string_view chapter, const Lesson& lesson,
                                   const View<>& view, int every = lattice,
                                   const Tracing& tracing = {}, const SharedImage& picture = {}) {
  StageView stage{.chapter = std::string(chapter), .picture = picture, .sky = lesson.stage.sky};
  for (int row = 1; row < stage.height; row += every) {
    for (int column = 1; column < stage.width; column += every) {
      Seen seen = see(lesson, ray_through<double>(view, column, row), stage, tracing);
      seen.column = column;
      seen.row = row;
      stage.pixels.push_back(seen);
    }
  }
  return stage;
}

/// A mistake before the surface: in the view of 800 x 600 pixels, or in tracing.
struct ViewSlip : Slip {
  void (*turn)(View<>& view) = nullptr;
  Tracing tracing{};
};
inline const ViewSlip of_view[] = {
    {{"all is too narrow: the picture's aspect was forgotten", "x times width / height"},
     [](View<>& view) { view.right = view.right * 0.75; }},
    {{"all is too small and turned: the angle of view, in degrees, was taken for radians",
      "`angle * pi / 180`"},
     [](View<>& view) { view.pixel = tan(30.0) / 300; }},
    {{"all is too large: the height of the view is the tangent, and not twice the tangent",
      "`2 * tan(angle / 2) / height` for each pixel"},
     [](View<>& view) { view.pixel /= 2; }},
    {{"all is too low: the camera's up is (0, 1, 0), and not at right angles to its view",
      "`cross(right, forward)`"},
     [](View<>& view) {
       view.up = {0, 1, 0};
     }},
    {{"half a pixel off: rays go through the corners of pixels", "`column + 0.5`, `row + 0.5`"},
     [](View<>& view) { view.center_column += 0.5, view.center_row += 0.5; }},
    {{"the camera does not look at its target: its axes are the world's", "`target - eye`"},
     [](View<>& view) {
       view.forward = {0, 0, -1}, view.up = {0, 1, 0};
     }},
    {{"all is too large: the vector to the right was not divided by its length",
      "`normalize(cross(forward, up))`"},
     [](View<>& view) {
       view.pixel *= length(cross(view.forward, Vec3d{0, 1, 0}));
     }},
    {{"the last object that a ray meets is drawn, and not the nearest", "the smallest distance"},
     nullptr,
     {.draws_last = true}},
    {{"too bright, and full of shadows: the vector to the lamp was not divided by its length",
      "`normalize(lamp - point)`"},
     nullptr,
     {.to_lamp = [](const Point& lamp, const Point& point) { return lamp - point; }}},
    {{"the light comes from one direction everywhere: the point was not subtracted",
      "`normalize(lamp - point)`"},
     nullptr,
     {.to_lamp = [](const Point& lamp, const Point&) { return normalize(lamp); }}},
};

template <OfTheStage Lesson>
void visit_changed(const StageView& stage, const Visit& visit) {
  const Lesson right = prepared<Lesson>(stage.options);
  const std::string& chapter = stage.chapter;
  for (const ViewSlip& slip : of_view) {
    View<> view = view_of(right.stage.camera, 800, 600);
    if (slip.turn != nullptr) slip.turn(view);
    visit(slip, [&](int every) {
      return view_stage(chapter, right, view, every, slip.tracing, stage.picture);
    });
  }
  const auto visit_lesson = [&](const Slip& slip, const Lesson& lesson) {
    const View<> view = view_of(lesson.stage.camera, 800, 600);
    visit(slip,
          [&](int every) { return view_stage(chapter, lesson, view, every, {}, stage.picture); });
  };
  for (const OptionSlip* slip : of_chapter(chapter, of_options)) {
    std::vector<std::string> options = stage.options;
    for (const std::string& word : slip->typed()) options.push_back(word);
    visit_lesson({slip->words, slip->change}, prepared<Lesson>(options));
  }
  mistakes::of_the_scene(right, [&](const std::string& words, const Lesson& lesson) {
    visit_lesson({words, ""}, lesson);
  });
  Lesson lesson = right;  // changed in place: a copy has a texture
  const Point lamp = right.stage.light.position;
  for (const double x : {-10, -5, -2, 0, 2, 5, 10}) {
    for (const double y : {-10, -5, -2, 0, 2, 5, 10}) {
      for (const double z : {-10, -5, -2, 0, 2, 5, 10}) {
        lesson.stage.light.position = {x, y, z};
        visit_lesson({text("the lamp is at (%g, %g, %g) and not at (%g, %g, %g)", x, y, z, lamp.x,
                           lamp.y, lamp.z),
                      ""},
                     lesson);
      }
    }
  }
  lesson.stage.light.position = lamp;
  const auto move = [&](const char* what, Point& point, const Point& to) {
    if (length(to - point) == 0) return;
    const Point was = std::exchange(point, to);
    visit_lesson({text("the %s is at (%g, %g, %g) and not at (%g, %g, %g)", what, to.x, to.y, to.z,
                       was.x, was.y, was.z),
                  ""},
                 lesson);
    point = was;
  };
  const Point eye = right.stage.camera.eye;
  for (const double z : {3, 4, 5, 6, 7, 9, 10, 12})
    move("eye", lesson.stage.camera.eye, {0, eye.y, z});
  for (const double y : {1.0, 1.5, 2.5, 3.0, 4.0})
    move("eye", lesson.stage.camera.eye, {0, y, eye.z});
  for (const double y : {-1.0, -0.5, 0.5, 1.0, 2.0})
    move("target", lesson.stage.camera.target, {0, y, 0});
  for (int degrees = 20; degrees <= 110; ++degrees) {
    if (degrees == 60 || degrees == 90) continue;  // right; of_the_scene has it
    lesson.stage.camera.fov_y_degrees = degrees;
    visit_lesson({text("the angle of view is %d degrees and not 60", degrees), ""}, lesson);
  }
}

/// As the chapter draws it.
template <OfTheStage Lesson>
[[nodiscard]] StageView view_stage(std::string_view chapter,
                                   const std::vector<std::string>& options = {}) {
  const Lesson lesson = prepared<Lesson>(options);
  StageView stage = view_stage(chapter, lesson, view_of(lesson.stage.camera, 800, 600));
  stage.options = options;
  stage.visit_changed = visit_changed<Lesson>;
  return stage;
}

/// A chapter that can be viewed: stages.cmake lists them. Of another scene there are no pixels.
struct OnStage {
  std::string_view name;
  /// @param texture  a file in place of the chapter's own; empty: its own
  StageView (*view)(std::string_view chapter, const std::string& texture);
};
template <class Lesson>
constexpr OnStage on_stage(std::string_view name) {
  return {name, [](std::string_view chapter, const std::string& texture) -> StageView {
            if constexpr (OfTheStage<Lesson>) {
              if (texture.empty()) return view_stage<Lesson>(chapter, {});
              if constexpr (requires(Lesson lesson) { lesson.texture; })
                return view_stage<Lesson>(chapter, {"--texture", texture});
            }
            return {.chapter = std::string(chapter)};
          }};
}
[[nodiscard]] const std::vector<OnStage>& stages();
/// Those of chapters 04 and 07 to 12, which draw something else; ./course diagnose first tries
/// without them.
[[nodiscard]] const std::vector<OnStage>& variants();
/// Of either list; null if the chapter cannot be viewed.
[[nodiscard]] const OnStage* find_chapter(std::string_view name);

}  // namespace texmap::slips
