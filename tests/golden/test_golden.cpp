// All chapters' pictures as they should be. TEXMAP_COLLECT=1 writes new ones. Look at the new
// pictures before you commit them.
#include <doctest.h>

#include <cstdlib>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "08_triangle_uv/surface.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "09_texture_filtering/surface.hpp"
#include "10_projections/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "11_bump_and_normal_maps/surface.hpp"
#include "13_speed_for_accuracy/lesson.hpp"
#include "14_numerical_extremes/lesson.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/pictures.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// Two pictures are the same if at most 0.02 % of their pixels differ by more than one level:
/// another compiler or library may change a last bit, and no more.
bool same(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height &&
         static_cast<double>(count_different(a, b, 1)) <=
             0.0002 * static_cast<double>(a.pixels.size());
}

std::string file_of(const std::string& name) {
  return std::string(TEXMAP_TESTS_DIR) + "/golden/" + name + ".png";
}

void check_golden(const std::string& name, const Image& drawn) {
  if (std::getenv("TEXMAP_COLLECT") != nullptr) {
    save_png(drawn, file_of(name));
    MESSAGE("wrote " << file_of(name));
  }
  const Image golden = load_image(file_of(name));
  CAPTURE(name);
  CHECK(same(drawn, golden));
  if (drawn != golden)
    MESSAGE(name << ": " << count_different(drawn, golden)
                 << " pixels differ by one level or more");
#ifdef TEXMAP_REFERENCE_PLATFORM
  CHECK(drawn == golden);
#endif
}

Image sheet() {
  const auto lesson = prepared<chapter_04::Lesson>();
  CommandLine line("test", "");
  Session session("test", line, chapter_04::Lesson::about);
  return chapter_04::sheet_of_conventions(lesson, session);
}

Image filters() {
  const auto lesson = prepared<chapter_09::Lesson>();
  CommandLine line("test", "");
  Session session("test", line, chapter_09::Lesson::about);
  const auto figures = chapter_09::compare_filters(chapter_09::floor_of(lesson), 0, false);
  return chapter_09::sheet_of_filters(session, figures, chapter_09::drawn_by(lesson, session));
}

Image extremes() {
  CommandLine line("test", "");
  Session session("test", line, chapter_14::Lesson::about);
  return chapter_14::draw_sheet(chapter_14::Lesson{}.exhibits(), session).picture;
}

Image layouts() {
  const auto lesson = prepared<chapter_10::Lesson>();
  CommandLine line("test", "");
  Session session("test", line, chapter_10::Lesson::about);
  session.settings.number = NumberKind::double_;
  session.settings.quiet = true;
  return chapter_10::sheet_of_projections(lesson, session);
}

Image trade() {
  const chapter_13::Globe globe(chapter_13::Lesson{}.texture.load());
  return chapter_13::draw_sheet(globe, 1312, 1090, 0, [] {});
}

Image sampled() {
  const auto lesson = prepared<chapter_07::Lesson>();
  return develop(gather<double>(lesson, lesson.objects, view_of(lesson.stage.camera, 400, 225),
                                {Sampler(SamplerKind::sobol, 100)}, {}, {}),
                 Transfer::srgb);
}

Image lecture(const char* highlight) {
  const auto lesson = prepared<chapter_06::Lesson>(
      {"--scene", "lecture", "--shininess", "20", "--blend", "0.1", "--highlight", highlight});
  return picture(lesson, 400, 200);
}

/// What `--show` draws of a lesson's surfaces.
template <class Lesson>
Image surfaces(const Lesson& lesson, Shown shown, int width, int height) {
  return draw_surfaces(lesson, view_of(lesson.stage.camera, width, height), shown, default_number,
                       {});
}

/// Two globes seen from above.
Image poles() {
  auto lesson = prepared<chapter_11::Lesson>();
  CommandLine line("test", "");
  Session session("test", line, chapter_11::Lesson::about);
  session.settings.width = 1000;
  return chapter_11::sheet_of_poles(lesson, session);
}

}  // namespace

TEST_CASE("every chapter draws its golden picture") {
  check_golden("01_plain_spheres", picture(chapter_01::Lesson{}));
  check_golden("02_checkerboard_uv", picture(chapter_02::Lesson{}));
  check_golden("03_image_texture", picture(prepared<chapter_03::Lesson>()));
  check_golden("04_uv_conventions", sheet());
  check_golden("04_uv_daily", surfaces(prepared<chapter_04::Lesson>({"--convention", "daily"}),
                                       Shown::uv, 200, 150));
  check_golden("05_y_rotation", picture(prepared<chapter_05::Lesson>()));
  check_golden("06_phong_texture_blend", picture(prepared<chapter_06::Lesson>()));
  check_golden("06_lecture_phong", lecture("phong"));
  check_golden("06_lecture_slides", lecture("lecture"));
  check_golden("07_earth_by_sampling", sampled());
  check_golden("08_triangle_uv", picture(prepared<chapter_08::Lesson>(), 480, 360));
  for (const std::string wrap : {"repeat", "clamp"})
    check_golden("08_" + wrap, picture(prepared<chapter_08::Lesson>({"--wrap", wrap}), 240, 180));
  check_golden("09_texture_filtering", filters());
  check_golden("10_projections", layouts());
  check_golden("11_bump_and_normal_maps", picture(prepared<chapter_11::Lesson>(), 600, 600));
  check_golden("11_normals", surfaces(prepared<chapter_11::Lesson>(), Shown::normal, 150, 150));
  check_golden("11_bump_or_dent", chapter_11::sheet_of_readings(1600));
  check_golden("11_poles", poles());
  check_golden("11_daily_bricks", chapter_11::sheet_of_bricks(1000));
  check_golden("13_speed_for_accuracy", trade());
  check_golden("14_numerical_extremes", extremes());
}

TEST_CASE(
    "the comparison can fail: neighbouring chapters, a mirrored Earth and half a texel are all "
    "refused") {
  const auto golden = [](const std::string& name) { return load_image(file_of(name)); };
  CHECK_FALSE(same(golden("01_plain_spheres"), golden("02_checkerboard_uv")));
  CHECK_FALSE(same(golden("02_checkerboard_uv"), golden("03_image_texture")));
  CHECK_FALSE(same(golden("03_image_texture"), golden("04_uv_conventions")));
  CHECK_FALSE(same(golden("04_uv_conventions"), golden("05_y_rotation")));
  CHECK_FALSE(same(golden("03_image_texture"), golden("05_y_rotation")));
  CHECK_FALSE(same(golden("05_y_rotation"), golden("06_phong_texture_blend")));
  CHECK_FALSE(same(golden("06_lecture_phong"), golden("06_lecture_slides")));
  CHECK_FALSE(same(picture(prepared<chapter_11::Lesson>({"--bump", "off"}), 600, 600),
                   golden("11_bump_and_normal_maps")));
  CHECK_FALSE(same(chapter_11::sheet_of_readings(1600), golden("11_poles")));
  CHECK_FALSE(same(golden("08_repeat"), golden("08_clamp")));
  const Image earth = golden("03_image_texture");
  CHECK_FALSE(same(picture(prepared<chapter_03::Lesson>({"--texture", "uv_map.png"})), earth));
  CHECK_FALSE(same(picture(prepared<chapter_04::Lesson>({"--convention", "daily"})), earth));
  CHECK_FALSE(same(picture(prepared<chapter_04::Lesson>({"--rounding", "lecture"})), earth));
  auto wrong = prepared<chapter_03::Lesson>();
  auto& texture = std::get<chapter_03::Textured>(wrong.objects[chapter_03::middle].paint).texture;
  texture.image = mirrored(texture.image);
  CHECK_FALSE(same(picture(wrong), earth));
  CHECK(same(earth, earth));
}
