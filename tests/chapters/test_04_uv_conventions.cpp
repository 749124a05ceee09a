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

}  // namespace

TEST_CASE("the convention rtiow is chapter 03, and others change its middle sphere alone") {
  const auto before = prepared<chapter_03::Lesson>();
  const std::vector<int> seen = test::objects_seen(before);
  const Image first = test::picture(before);
  test::expect_same_picture(drawn_in("rtiow"), first);
  for (const auto& [convention, rounding] :
       {std::pair{"daily", "floor"}, {"lecture", "floor"}, {"rtiow", "lecture"}}) {
    const Image other = drawn_in(convention, rounding);
    CHECK(test::count_different(other, first) > 100);
    CHECK(test::changed_elsewhere(first, other, seen, Lesson::about.changed_objects) == 0);
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

TEST_CASE("the printed table names every relation and every source") {
  const std::string table = chapter_04::table_of_relations();
  for (const char* expected : {"u_next = 1 - u_daily", "u_lecture = frac(u_next - 1/4)",
                               "One Weekend 2020", "is mirrored", "reads as printed"}) {
    CAPTURE(expected);
    CHECK(table.find(expected) != std::string::npos);
  }
}
