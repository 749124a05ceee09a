// The groups of pictures: each chapter's with every number and on several threads, 08's by a tree,
// 07's under budgets.
#include <thread>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "10_projections/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "12_environment_map/lesson.hpp"
#include "engine/compare/difference.hpp"
#include "engine/fast/box_tree.hpp"
#include "ledger.hpp"
#include "support/mesh_rays.hpp"

namespace texmap::bench {
namespace {

constexpr int samples = 100;  // a pixel of chapter 07 under a budget, as the book draws it

template <class Lesson>
void add_chapter(Group& group, const std::string& line, int height = 300,
                 const std::vector<std::string>& options = {}) {
  const auto make = [=] {
    return std::make_shared<LessonWork<Lesson>>(prepared<Lesson>(options), 400, height);
  };
  for (const Variant& variant : variants_of("dfeDF"))
    group.rows.push_back(row_of(line, line, variant, 1, make));
}

/// Chapter 07's scene of the book under a sky and a budget.
[[nodiscard]] std::shared_ptr<Drawing> earth(const std::string& sky, const std::string& budget) {
  const auto lesson = prepared<chapter_07::Lesson>({"--scene", "book", "--sky", sky});
  const Image& texture = lesson.objects.front().paint.texture.image;
  return std::make_shared<LessonWork<chapter_07::Lesson>>(
      lesson, 400, 225, samples,
      plan_surface(parse_budget(budget), texture, 400.0 * 225 * samples));
}

void add_budget(Group& group, const std::string& sky, const std::string& budget) {
  // Made and found once for all rows: each would hold the texture twice.
  const auto work = std::make_shared<std::shared_ptr<Drawing>>();
  const auto make = [=] {
    if (!*work) *work = earth(sky, budget);
    return *work;
  };
  // By how many levels of 255 the budget moves a byte of the picture at most, and how many pixels
  // it changes at all: with the number that it is made for, compared with the exact picture in
  // double.
  const auto note = std::make_shared<std::string>();
  const auto find_note = [=] {
    if (!note->empty()) return *note;
    const Figures figures = texmap::measure(earth(sky, "exact")->picture(in_double),
                                            earth(sky, budget)->picture(in_float));
    return *note = std::to_string(figures.worst.levels) + " in " +
                   std::to_string(figures.pixels_different) + " pixels";
  };
  for (const Variant& variant : variants_of("dDF")) {
    group.rows.push_back(row_of(sky + " sky, " + budget, sky, variant, 1, make));
    if (variant.is_here()) group.rows.back().find_note = find_note;
  }
}

template <class Lesson>
void add_threads(Group& group, const std::string& line) {
  for (const int threads : {1, 2, 4, 8}) {
    Row row{.line = line,
            .column = std::to_string(threads) + (threads == 1 ? " thread" : " threads"),
            .set = line};
    if (threads <= static_cast<int>(std::thread::hardware_concurrency())) {
      row.prepare = [threads]() -> Work {
        const auto lesson = std::make_shared<Lesson>(prepared<Lesson>({}));
        return [=] {
          (void)render<double>(*lesson, view_of(lesson->stage.camera, 400, 300),
                               {.threads = threads});
        };
      };
    }
    group.rows.push_back(row);
  }
}

/// Chapter 08's lesson with a torus of 2 sides² triangles.
template <class Lesson>
[[nodiscard]] Lesson of_torus(int sides, bool tree) {
  auto lesson = prepared<Lesson>({});
  const TexturedMesh torus = test::torus(sides, sides);
  lesson.scene.mesh = tree ? with_boxes(torus.mesh) : BoxedMesh{torus.mesh, {}, {}};
  lesson.paint.mapping.mapping = torus.mapping;
  return lesson;
}

}  // namespace

Group threads_group() {
  Group group = described("threads");
  add_threads<chapter_03::Lesson>(group, "03");
  add_threads<chapter_08::Lesson>(group, "08");
  add_threads<chapter_11::Lesson>(group, "11");
  return group;
}

Group meshes_group() {
  Group group = described("meshes");
  for (const int sides : {6, 12, 40}) {
    const std::string line = std::to_string(2 * sides * sides) + " triangles";
    for (const Variant& variant : double_and_widest_packs()) {
      for (const bool tree : {false, true}) {
        group.rows.push_back(row_of(line, line + variant.name, variant, 1, [sides, tree] {
          return std::make_shared<LessonWork<chapter_08::Lesson>>(
              of_torus<chapter_08::Lesson>(sides, tree), 200, 150);
        }));
        group.rows.back().column = variant.name + (tree ? ", tree of boxes" : ", every triangle");
      }
    }
  }
  return group;
}

Group tracing_group() {
  Group group = described("tracing");
  group.ratio = Ratio::cost;
  for (const int sides : {22, 70, 224, 707}) {
    const std::string line = std::to_string(2 * sides * sides) + " triangles";
    for (const Variant& variant : double_and_widest_packs()) {
      const auto add = [&](const char* what, auto make) {
        group.rows.push_back(row_of(line, line + variant.name, variant, 1, make));
        group.rows.back().column = variant.name + what;
      };
      add(", tracing", [sides] {
        return std::make_shared<LessonWork<TracingAlone, InDouble>>(
            of_torus<TracingAlone>(sides, true), 480, 360);
      });
      add(", with shading", [sides] {
        return std::make_shared<LessonWork<chapter_08::Lesson>>(
            of_torus<chapter_08::Lesson>(sides, true), 480, 360);
      });
    }
  }
  return group;
}

Group budgets_group() {
  Group group = described("budgets");
  for (const std::string sky : {"constant", "gradient"}) {
    for (const std::string budget : {"exact", "texels=0.01", "levels=1"})
      add_budget(group, sky, budget);
  }
  return group;
}

Group chapters_group() {
  Group group = described("chapters");
  add_chapter<chapter_01::Lesson>(group, "01");
  add_chapter<chapter_02::Lesson>(group, "02");
  add_chapter<chapter_03::Lesson>(group, "03");
  add_chapter<chapter_04::Lesson>(group, "04");
  add_chapter<chapter_05::Lesson>(group, "05");
  add_chapter<chapter_06::Lesson>(group, "06");
  add_chapter<chapter_07::Lesson>(group, "07", 225, {"--scene", "book"});
  add_chapter<chapter_08::Lesson>(group, "08");
  add_chapter<chapter_09::Lesson>(group, "09");
  add_chapter<chapter_10::Lesson>(group, "10", 300, {"--projection", "equal-area"});
  add_chapter<chapter_11::Lesson>(group, "11");
  add_chapter<chapter_12::Lesson>(group, "12", 225, {"--quiet"});
  return group;
}

}  // namespace texmap::bench
