// The group of the chapters: each one's picture, drawn with every number.
#include <memory>

#include "lessons.hpp"
#include "make_rows.hpp"
#include "pictures.hpp"

namespace texmap::bench {
namespace {

constexpr int few_samples = 8;  // a pixel, of chapter 07 among the others
constexpr int samples = 100;    // of chapter 07 under a budget, as it draws by itself

/// A chapter's lesson and all that drawing it needs.
template <class Lesson>
struct ChapterWork {
  Lesson lesson;
  View view;
  RenderSettings settings{.threads = 1};
  Image picture;
  Film film;  // of a lesson that gathers light

  ChapterWork(Lesson its_lesson, int width, int height, int count = few_samples)
      : lesson(std::move(its_lesson)), view(view_of(lesson.stage.camera, width, height)), film(width, height) {
    if constexpr (GathersLight<Lesson>) lesson.gathering = {Sampler(SamplerKind::sobol, count), count / 2, &film};
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

using Earth = chapter_07::Lesson;

/// Chapter 07 under a sky and a budget.
[[nodiscard]] Earth earth(const std::string& sky, const std::string& budget) {
  return test::prepared<Earth>({"--quiet", "--sky", sky, "--budget", budget});
}

/// By how many levels of 255 a budget moves a byte of chapter 07's picture at most, and how many pixels it changes at all: with
/// the number that it is made for, against the exact picture in double.
[[nodiscard]] std::string moved(const std::string& sky, const std::string& budget) {
  const auto shown = [&](const std::string& text, const Way& way) {
    ChapterWork<Earth> work(earth(sky, text), 400, 225, samples);
    work.run(way);
    work.film.count(samples / 2, samples - samples / 2);
    return develop(work.film, Transfer::srgb, work.lesson.sampling.srgb_terms);
  };
  const Image exact = shown("exact", in_double);
  const Image picture = shown(budget, in_float);
  int most = 0;
  int changed = 0;
  for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
    const int apart = test::levels_apart(exact.pixels[i], picture.pixels[i]);
    most = std::max(most, apart);
    changed += apart > 0 ? 1 : 0;
  }
  return std::to_string(most) + " in " + std::to_string(changed) + " pixels";
}

void add_budget(Group& group, const std::string& sky, const std::string& budget) {
  // Made and found once for all rows: each would hold the texture twice.
  const auto work = std::make_shared<std::shared_ptr<ChapterWork<Earth>>>();
  const auto make = [=] {
    if (!*work) *work = std::make_shared<ChapterWork<Earth>>(earth(sky, budget), 400, 225, samples);
    return *work;
  };
  const auto note = std::make_shared<std::string>();
  const auto add = [&](const Way& way) {
    group.rows.push_back(row_of(sky + " sky, " + budget, sky, way, 1, make));
    group.rows.back().find_note = [=] { return note->empty() ? *note = moved(sky, budget) : *note; };
  };
  add(in_double);
  for (const Way& way : in_double_packs) add(way);
  for (const Way& way : in_float_packs) add(way);
}

}  // namespace

Group budgets_group() {
  Group group{
      .name = "budgets",
      .title = "Chapter 07 under a budget",
      .text =
          "Drawing alone, at 400 × 225 pixels with 100 samples a pixel. A budget in levels pays for the curve to bytes, "
          "texels kept as roots of light, a polynomial for (u, v), and patches: nine looks for all samples of a smooth "
          "pixel. The base is the exact picture in double. The last column compares the picture in float with that.",
      .unit = "ms",
      .seconds = 30,
      .note = "levels of 255 that a byte is moved by at most",
  };
  for (const std::string sky : {"constant", "gradient"}) {
    for (const std::string budget : {"exact", "texels=0.01", "levels=1"}) add_budget(group, sky, budget);
  }
  return group;
}

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
