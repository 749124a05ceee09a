// Chapter 04: four source documents, three conventions, exact relations between them.
#include <doctest.h>

#include <complex>
#include <numbers>

#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/conventions_compared.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "published/uv.hpp"
#include "support/lesson_laws.hpp"
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

TEST_CASE("scales of 1, whole turns and whole offsets of u change nothing") {
  const Image first = drawn_in("rtiow");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--uv-scale", "1x1"}, {"--uv-turn", "-720"}, {"--uv-offset=0,0"}})
    test::expect_same_picture(test::picture(prepared<Lesson>(words)), first);
  for (const char* whole : {"1,0", "-3,0"}) {  // rounding can move u over the edge of a texel
    const auto moved = prepared<Lesson>({"--uv-offset", whole});
    test::expect_same_picture(test::picture(moved), first, {.pixels = 4});
  }
}

TEST_CASE("scaled, turned and moved, each pixel shows the texel that complex numbers find") {
  const auto lesson = prepared<Lesson>(
      {"--uv-scale", "3x1.5", "--uv-turn", "20", "--uv-offset", "0.1,-0.2", "--wrap", "repeat"});
  const Image earth = TextureFile{"earth.png"}.load();
  const auto texel = [](double x, int n) {
    return static_cast<int>(std::floor((x - std::floor(x)) * n));
  };
  long seen = 0, different = 0;
  test::for_each_ray(view_of(lesson.stage.camera, 800, 600), [&](const Ray<double>& ray) {
    const Nearest<double> nearest = find_nearest(lesson.objects, ray);
    if (static_cast<int>(nearest.index) != chapter_04::middle) return;
    const auto& globe = lesson.objects[chapter_04::middle];
    const Hit<double> hit = hit_at(globe.shape, ray, nearest.distance);
    const Uv<double> uv = published::uv_next_week_v4(hit.normal);
    const std::complex<double> moved =
        std::complex(3 * uv.u, 1.5 * uv.v) * std::polar(1.0, 20 * std::numbers::pi / 180) +
        std::complex(0.1, -0.2);
    const Rgb8 expected = earth.at(texel(moved.real(), 2048), 1023 - texel(moved.imag(), 1024));
    const Rgb color = globe.paint(hit);
    ++seen;
    different +=
        std::lround(color.r * 255) != expected.r || std::lround(color.g * 255) != expected.g ? 1
                                                                                             : 0;
  });
  CHECK(seen > 12000);
  CHECK(different <= 4);  // at the edges of texels
}

TEST_CASE("all numbers draw a moved picture" * test::NeedsFloat<Lesson>{}) {
  test::check_all_numbers(
      prepared<Lesson>({"--uv-scale", "3x1.5", "--uv-turn", "20", "--wrap", "article"}), 480);
}

TEST_CASE("One Weekend 2020's formula finds another row for some pixels, the article's for none") {
  const Image first = drawn_in("rtiow");
  const auto by = [&](const char* formula) {
    return test::count_different(test::picture(prepared<Lesson>({"--wrap", formula})), first);
  };
  const long moved_over = by("weekend");
  CHECK(moved_over == 3);  // the page states it
  CHECK(by("article") == 0);
}
