// Lessons as their writers may write them: plain C++, single numbers, and hooks that are misspelt.
#include <doctest.h>

#include <vector>

#include "engine/app/run_chapter.hpp"
#include "engine/app/texture_file.hpp"
#include "engine/picture/load_image.hpp"
#include "lessons/stripes_lesson.hpp"
#include "support/temporary_folder.hpp"
#include "texture/checkerboard.hpp"

using namespace texmap;

namespace {

/// The same stripes for every number.
struct SelectedStripes {
  Rgb first;
  Rgb second;
  int count = 8;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const Real stripe = floor(uv.u * Real(count));
    return select(is_even(stripe), number_cast<Real>(first), number_cast<Real>(second));
  }
};

/// Stripes by `if` and `int` for every single number.
struct BranchingStripes {
  Rgb first;
  Rgb second;
  int count = 8;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    if (static_cast<int>(uv.u * static_cast<Real>(count)) % 2 == 0) return number_cast<Real>(first);
    return number_cast<Real>(second);
  }
};

template <class Stripes, Numbers offered>
struct StripedLesson : LessonHooks {
  static constexpr About about{.idea = "stripes", .numbers = offered};

  using Striped = Mapped<RtiowMapping, Stripes>;
  Stage stage;
  std::vector<Painted<AnyOf<Solid, Striped>>> objects = {
      {.shape = {.center = {0, 0, 0}, .radius = 1}, .paint = Striped{{}, {red, white}}},
      {.shape = {.center = {0, -1001, 0}, .radius = 1000}, .paint = Solid{white}},
  };

  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const auto& object, const Hit<Real>& hit) {
      const LightSample<Real> light = sample_light(stage.light, objects, hit);
      return object.paint(hit) * (Real(0.2) + Real(0.8) * light.cosine);
    });
  }
};

using Plain = stripes::Lesson;
using Single = StripedLesson<BranchingStripes, Numbers::single>;
using Every = StripedLesson<SelectedStripes, Numbers::all>;

template <class Lesson>
Image picture_of(NumberKind number = NumberKind::double_) {
  CommandLine line("stripes", "");
  Session session("stripes", line, Lesson::about);
  session.settings.quiet = true;
  session.settings.number = number;
  return session.draw(Lesson{}, 160, 120);
}

}  // namespace

TEST_CASE("stripes by int and if are the stripes of every number, to the byte") {
  const Image plain = picture_of<Plain>();
  CHECK(plain == picture_of<Single>());
  CHECK(plain == picture_of<Every>());
  CHECK(plain == picture_of<Every>(NumberKind::double_pack));
  CHECK_FALSE(plain == picture_of<Every>(NumberKind::interval));
}

TEST_CASE("a lesson with single numbers is drawn in float and extended too") {
  CHECK(picture_of<Single>(NumberKind::float_) == picture_of<Every>(NumberKind::float_));
  CHECK(picture_of<Single>(NumberKind::extended) == picture_of<Every>(NumberKind::extended));
}

namespace {

/// Offers a texture, and has its hook misspelt without `override`.
struct Forgetful : stripes::Lesson {
  TextureFile texture{"earth.png"};
  void options(CommandLine& line) override { offer(line, texture); }
  void perpare(Session& /*session*/) {}
};

template <class Lesson>
int status_of(const std::string& file) {
  const char* const arguments[] = {"stripes",  "--quiet", "--width", "8",
                                   "--height", "6",       "--out",   file.c_str()};
  return run_chapter<Lesson>("stripes", 8, arguments);
}

}  // namespace

TEST_CASE("a texture that is offered and never loaded is an error, not a picture without it") {
  const test::TemporaryFolder folder;
  CHECK(status_of<Forgetful>(folder / "x.png") == 1);
  CHECK(folder.size() == 0);
  CHECK(status_of<Plain>(folder / "x.png") == 0);
}

TEST_CASE("a name that promises another kind of picture is refused") {
  const test::TemporaryFolder folder;
  for (const char* name : {"x.jpg", "x.jpeg", "x.gif", "x.bmp", "x.webp"}) {
    CHECK(status_of<Plain>(folder / name) == 2);
  }
  CHECK(folder.size() == 0);
  CHECK(status_of<Plain>(folder / "jpg") == 0);
}
