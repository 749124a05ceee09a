// Chapter 10: maps of the sphere, their figures, conversion, and which layout a file has.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "03_image_texture/lesson.hpp"
#include "10_projections/figures.hpp"
#include "10_projections/lesson.hpp"
#include "10_projections/probable_layout.hpp"
#include "engine/draw/convert_projection.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "support/dice.hpp"
#include "support/lesson_laws.hpp"
#include "support/made_pictures.hpp"
#include "support/running.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_10::closed_forms;
using chapter_10::Lesson;
using chapter_10::probable_layouts;

namespace {

Lesson in_layout(const std::string& word) { return prepared<Lesson>({"--projection", word}); }

Image earth(int width) {
  return convert_projection(load_image(std::string(TEXMAP_ASSETS_DIR) + "/earth.png"),
                            Projection::equirect, Projection::equirect, {width, width / 2});
}

Outcome run_chapter_10(const std::string& words) {
  return run(std::string("\"") + TEXMAP_CHAPTER + "\" " + words);
}

}  // namespace

TEST_CASE("the globe in the equirectangular layout is chapter 03's, pixel for pixel") {
  const Image before = picture(prepared<chapter_03::Lesson>());
  test::expect_same_picture(picture(in_layout("equirect")), before);
  CHECK(check_step(prepared<chapter_03::Lesson>(), in_layout("octahedral"), chapter_10::ground) >
        0);
}

TEST_CASE("in every layout of the whole sphere the globe looks the same, but for its texels") {
  const Image expected = picture(in_layout("equirect"));
  for (const char* word : {"cylinder", "cube", "equi-angular", "octahedral", "equal-area"}) {
    CAPTURE(std::string(word));
    const Lesson lesson = in_layout(word);
    const Image drawn = picture(lesson);
    // A few hundred of 12,000 pixels of the globe are on a coast.
    CHECK(count_different(drawn, expected, 40) < 400);
    CHECK(count_different(drawn, expected) > 1000);
    // Read in the wrong layout, the globe is another one.
    Lesson wrong = lesson;
    wrong.objects[chapter_10::middle].paint = chapter_10::Textured{
        {Projection::equirect},
        std::get<chapter_10::Textured>(lesson.objects[chapter_10::middle].paint).texture};
    CHECK(count_different(picture(wrong), expected, 40) > 2000);
  }
}

TEST_CASE("all numbers draw the globe in every layout" * NeedsFloat<Lesson>{}) {
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    check_all_numbers(in_layout(facts.word), 400);
  }
}

TEST_CASE(
    "the largest texel and the worst stretch tend to the closed forms, and exceed them nowhere") {
  Dice dice(2);
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    const chapter_10::ClosedForms forms = closed_forms(facts.projection);
    double largest_texel = 0;
    double worst_stretch = 0;
    // Anywhere, and close to an axis, a diagonal or the worst place, but not on an edge.
    const Vec3d near[] = {{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, forms.worst_place};
    for (int i = 0; i < 100000; ++i) {
      const Vec3d aside{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
      const double reach = i % 6 == 0 ? 1 : static_cast<double>(dice.power_of_ten(-6, -2));
      Vec3d p = near[i % 6] + aside * reach;
      if (facts.projection == Projection::plane) p.y = std::abs(p.y);
      const auto found = distortion(facts.projection, normalize(p));
      largest_texel = std::max(largest_texel, found.area);
      worst_stretch = std::max(worst_stretch, found.stretch);
    }
    const auto tends_to = [](double found, double closed) {
      if (std::isinf(closed)) return found > 1000;
      return found <= closed * (1 + 1e-14) && found >= closed * (1 - 1e-4);
    };
    CAPTURE(largest_texel);
    CAPTURE(worst_stretch);
    CHECK(tends_to(largest_texel, forms.largest_texel));
    CHECK(tends_to(worst_stretch, forms.worst_stretch));
  }
}

TEST_CASE("the seams: half a circle, a circle, or eight edges of a cube") {
  const double edge = std::acos(1 / 3.0) * 180 / std::numbers::pi;
  const auto seams = [](Projection projection) { return chapter_10::seam_degrees(projection); };
  CHECK(seams(Projection::equirect) == doctest::Approx(180).epsilon(1e-6));
  CHECK(seams(Projection::cylinder) == doctest::Approx(180).epsilon(1e-4));
  CHECK(seams(Projection::cube) == doctest::Approx(8 * edge).epsilon(1e-6));
  CHECK(seams(Projection::equi_angular) == doctest::Approx(8 * edge).epsilon(1e-6));
  CHECK(seams(Projection::octahedral) == doctest::Approx(360).epsilon(1e-6));
  CHECK(seams(Projection::equal_area) == doctest::Approx(360).epsilon(1e-6));
}

TEST_CASE("the Earth's layout is found in every layout, in three sizes") {
  const Image large = earth(2048);
  for (const Image& source : {earth(512), earth(800), large}) {
    for (const ProjectionFacts& facts : projections) {
      CAPTURE(std::string(facts.word));
      CAPTURE(source.width);
      const PictureSize size = converted_size(source, Projection::equirect, facts.projection);
      const Image image = convert_projection(source, Projection::equirect, facts.projection, size);
      const auto found = probable_layouts(image);
      CHECK(std::ranges::count(found, facts.projection) == 1);
      for (const Projection one : found) CHECK(facts_of(one).aspect == facts.aspect);
    }
  }
}

TEST_CASE("noise, one color, a broken seam and other pictures have no layout") {
  const std::string folder = TEXMAP_TESTS_DIR;
  for (const Image& image : {noise(256, 128, 1), noise(128, 128, 2), noise(192, 128, 3),
                             noise(402, 128, 4), Image(256, 128, {9, 9, 9}), Image(1, 1),
                             ramps(256, 128), load_image(folder + "/../assets/uv_map.png"),
                             load_image(folder + "/golden/10_projections.png")}) {
    CAPTURE(image);
    CHECK(probable_layouts(image).empty());
  }
  const Image source = earth(512);
  for (const ProjectionFacts& facts : projections) {
    if (facts.projection == Projection::plane || facts.projection == Projection::cylinder) continue;
    if (facts.projection == Projection::equirect) continue;
    CAPTURE(std::string(facts.word));
    const PictureSize size = converted_size(source, Projection::equirect, facts.projection);
    const Image image = convert_projection(source, Projection::equirect, facts.projection, size);
    // The upper half moved sideways by a quarter: the seams no longer match.
    Image broken = image;
    for (int row = 0; row < image.height / 2; ++row) {
      for (int column = 0; column < image.width; ++column)
        broken.at(column, row) =
            image.at((column + image.width / 4) % image.width, image.height - 1 - row);
    }
    CHECK(probable_layouts(broken).empty());
  }
}

TEST_CASE("the table names every layout with its figures") {
  const std::string table = chapter_10::table_of_figures();
  for (const char* expected :
       {"equirect", "equi-angular", "equal-area", "1.5708", "1.9099", "1.1781", "1.6540", "1.7321",
        "2.6180", "2.9984", "no bound", "564.2"}) {
    CAPTURE(std::string(expected));
    CHECK(table.find(expected) != std::string::npos);
  }
}

TEST_CASE("the program converts a file, says what it probably is, and converts it back") {
  const TemporaryFolder folder;
  const std::string source = folder / "earth.png";
  const std::string cube = folder / "cube.png";
  const std::string back = folder / "back.png";
  save_png(earth(512), source);
  const Outcome there =
      run_chapter_10("--texture \"" + source + "\" --to cube --out \"" + cube + "\"");
  CHECK(there.status == 0);
  CHECK(there.out.find("probably equirect\n") != std::string::npos);
  CHECK(there.out.find("444 x 296 pixels") != std::string::npos);
  const Outcome again = run_chapter_10(
      "--texture \"" + cube + "\" --from cube --to equirect --width 512 --height 256 --out \"" +
      back + "\"");
  CHECK(again.status == 0);
  CHECK(again.out.find("probably cube or equi-angular\n") != std::string::npos);
  CHECK(count_different(load_image(back), earth(512), 60) < 512 * 256 / 50);
}
