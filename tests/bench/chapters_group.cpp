// The group of the chapters: each one's picture, drawn with every number.
#include <memory>

#include "lessons.hpp"
#include "make_rows.hpp"
#include "pictures.hpp"

namespace texmap::bench {
namespace {

constexpr int samples = 8;  // a pixel, of chapter 07

/// A chapter's lesson and all that drawing it needs.
template <class Lesson>
struct ChapterWork {
  Lesson lesson;
  View view;
  RenderSettings settings{.threads = 1};
  Image picture;
  Film film;  // of a lesson that gathers light

  ChapterWork(Lesson its_lesson, int width, int height)
      : lesson(std::move(its_lesson)), view(view_of(lesson.stage.camera, width, height)), film(width, height) {
    if constexpr (GathersLight<Lesson>) lesson.gathering = {Sampler(SamplerKind::sobol, samples), samples / 2, &film};
  }
  void run(const Way& way) {
    settings.instructions = way.instructions;
    picture = draw(lesson, view, way.number, settings);
  }
};

template <class Lesson>
[[nodiscard]] Lesson prepared() {
  if constexpr (requires(Lesson lesson, Studio studio) { lesson.prepare(studio); }) {
    return test::prepared<Lesson>();
  } else {
    return {};
  }
}

template <class Lesson>
void add_chapter(Group& group, const std::string& line, int width, int height) {
  const auto make = [=] { return std::make_shared<ChapterWork<Lesson>>(prepared<Lesson>(), width, height); };
  const auto add = [&](const Way& way) { group.rows.push_back(row_of(line, line, way, 1, make)); };
  add(in_double);
  add(in_float);
  add(in_extended);
  for (const Way& way : in_double_packs) add(way);
  for (const Way& way : in_float_packs) add(way);
}

}  // namespace

Group chapters_group() {
  Group group{
      .name = "chapters",
      .title = "The chapters' pictures",
      .text =
          "Drawing alone, without loading, encoding and saving, at 400 × 300 pixels; chapter 07 at 400 × 225 "
          "with 8 samples a pixel. The base of each chapter is its picture in double.",
      .unit = "ms",
      .seconds = 35,
  };
  add_chapter<chapter_01::Lesson>(group, "01", 400, 300);
  add_chapter<chapter_02::Lesson>(group, "02", 400, 300);
  add_chapter<chapter_03::Lesson>(group, "03", 400, 300);
  add_chapter<chapter_04::Lesson>(group, "04", 400, 300);
  add_chapter<chapter_05::Lesson>(group, "05", 400, 300);
  add_chapter<chapter_06::Lesson>(group, "06", 400, 300);
  add_chapter<chapter_07::Lesson>(group, "07", 400, 225);
  return group;
}

}  // namespace texmap::bench
