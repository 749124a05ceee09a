// Chapter 04: four source documents, three conventions, exact relations between them.
#include <doctest.h>

#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/conventions_compared.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "published/uv.hpp"
#include "support/pictures.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using chapter_04::Lesson;
using chapter_04::published_mappings;

namespace {

Image drawn_in(const char* convention, const char* rounding = "floor") {
  return test::picture(prepared<Lesson>({"--convention", convention, "--rounding", rounding}));
}

/// A picture without symmetry, put on the sphere by a published formula and seen flat from outside.
/// 333 x 167 texels share no edge with the centers of 512 x 256 pixels, so no rounding can choose
/// between two texels.
Image flat(const chapter_04::PublishedMapping& mapping) {
  Image map(333, 167);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      map.at(column, row) = {static_cast<std::uint8_t>(column % 251),
                             static_cast<std::uint8_t>(row),
                             static_cast<std::uint8_t>(column / 251)};
    }
  }
  const ImageTexture texture{map, v_axis_of(mapping.convention)};
  return chapter_04::flat_map(512,
                              [&](const Vec3<double>& p) { return texture(mapping.formula(p)); });
}

}  // namespace

TEST_CASE("the convention rtiow is chapter 03") {
  const Image before = test::picture(prepared<chapter_03::Lesson>());
  test::expect_same_picture(drawn_in("rtiow"), before);
  CHECK(test::count_different(drawn_in("daily"), before) > 3000);
  CHECK(test::count_different(drawn_in("lecture"), before) > 3000);
  CHECK(test::count_different(drawn_in("rtiow", "lecture"), before) > 100);
}

TEST_CASE("only the middle sphere changes from chapter 03, in every convention and rounding") {
  const chapter_03::Lesson before = prepared<chapter_03::Lesson>();
  const std::vector<int> seen = test::objects_seen(before);
  const Image first = test::picture(before);
  for (const char* convention : {"daily", "rtiow", "lecture"}) {
    for (const char* rounding : {"floor", "lecture"}) {
      CHECK(test::changed_elsewhere(first, drawn_in(convention, rounding), seen,
                                    Lesson::about.changed_objects) == 0);
    }
  }
}

TEST_CASE("the exact relations hold within four roundings, and wrong ones do not") {
  for (const chapter_04::Relation& relation : chapter_04::measure_relations()) {
    CAPTURE(relation.text);
    CHECK(relation.residual <= 1e-15);
    CHECK(relation.residual >= 0);
  }
  const Vec3<double> p = chapter_04::direction_at(0.3, 0.7);
  CHECK(std::abs(published::uv_lecture(p).u - published::uv_next_week_v4(p).u) > 0.1);
}

TEST_CASE("the sign of the Jacobian is the handedness: only the daily exercise mirrors a picture") {
  const std::array<int, 4> expected = {-1, 1, 1, 1};
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(chapter_04::handedness(published_mappings[i]) == expected[i]);
}

TEST_CASE(
    "on a flat map the daily exercise is the mirror of Next Week, One Weekend 2020 equals it, and "
    "the lecture is a quarter turn on") {
  const Image daily = flat(published_mappings[0]);
  const Image weekend = flat(published_mappings[1]);
  const Image rtiow = flat(published_mappings[2]);
  const Image lecture = flat(published_mappings[3]);
  test::expect_same_picture(weekend, rtiow);
  CHECK(test::count_different(daily, rtiow) > 20000);
  test::expect_same_picture(test::mirrored(daily), rtiow);
  Image turned = rtiow;
  for (int row = 0; row < turned.height; ++row) {
    for (int column = 0; column < 512; ++column)
      turned.at(column, row) = rtiow.at((column + 512 - 128) % 512, row);
  }
  test::expect_same_picture(lecture, turned);
}

TEST_CASE("the printed table names every relation and every source") {
  const std::string table = chapter_04::table_of_relations();
  for (const char* expected :
       {"u_weekend = u_next", "u_next = 1 - u_daily", "u_lecture = frac(u_next - 1/4)",
        "v_weekend = v_next", "v_next = 1 - v_daily", "v_lecture = v_next", "daily exercise",
        "One Weekend 2020", "Next Week", "is mirrored", "reads as printed"}) {
    CAPTURE(expected);
    CHECK(table.find(expected) != std::string::npos);
  }
}

TEST_CASE(
    "the sheet has the size that was asked for and shows the same for One Weekend 2020 and Next "
    "Week") {
  const Lesson lesson = prepared<Lesson>();
  CommandLine line("test", "");
  Session session("test", line, Lesson::about);
  session.settings.width = 1200;
  session.settings.height = 620;
  const Image sheet = chapter_04::sheet_of_conventions(lesson, session);
  CHECK(sheet.width == 1200);
  CHECK(sheet.height == 620);
  long alike = 0;
  long apart = 0;
  for (int row = 20; row < 210; ++row) {
    for (int column = 0; column < 290; ++column) {
      alike += sheet.at(300 + column, row) == sheet.at(600 + column, row) ? 1 : 0;
      apart += sheet.at(column, row) == sheet.at(600 + column, row) ? 0 : 1;
    }
  }
  CHECK(alike == 190 * 290);
  CHECK(apart > 3000);
}
