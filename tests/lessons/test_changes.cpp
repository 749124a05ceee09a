// The changes that docs/how_to_change_things.md tells its reader to make: what they change in the
// picture, and what they do not. TEXMAP_COLLECT=1 writes the page's pictures.
#include <doctest.h>

#include <cstdlib>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "changes/fifth_sphere.hpp"
#include "changes/float_mapping.hpp"
#include "changes/int_stripes.hpp"
#include "changes/own_mapping.hpp"
#include "changes/own_texture.hpp"
#include "changes/plain.hpp"
#include "changes/plane.hpp"
#include "changes/stripes.hpp"
#include "changes/tiles.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "number/kinds/pack.hpp"
#include "support/pictures.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

constexpr int width = 320;
constexpr int height = 240;

template <class Lesson>
Image small(const Lesson& lesson) {
  return picture(lesson, width, height);
}

/// Checks the picture that the page shows.
template <class Lesson>
void check_page(const Lesson& lesson, const std::string& name) {
  const std::string file = TEXMAP_TESTS_DIR "/lessons/changes/" + name + ".png";
  if (std::getenv("TEXMAP_COLLECT") != nullptr) save_png(small(lesson), file);
  const long off = count_different(load_image(file), small(lesson));
#ifdef TEXMAP_REFERENCE_PLATFORM
  CHECK(off == 0);
#else
  CHECK(off <= width * height / 1000);
#endif
}

/// Where the middle of each pixel sees an object, and what is there before and after a change.
template <class Before, class After, class See>
void see_pixels(const Before& before, const After& after, const See& see) {
  const Image first = small(before);
  const Image second = small(after);
  const View<> view = view_of(after.stage.camera, width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Ray<double> ray = ray_through<double>(view, column, row);
      const Nearest<double> nearest = find_nearest(after.objects, ray);
      see(static_cast<int>(nearest.index), ray, nearest.distance, first.at(column, row),
          second.at(column, row));
    }
  }
}

/// Of which of the stage's colors a lit or shaded pixel is.
bool is_blue(Rgb8 p) { return p.b > p.r + 5; }
bool is_red(Rgb8 p) { return p.r > p.b + 5; }
bool is_gray(Rgb8 p) { return p.r == p.g && p.g == p.b; }

}  // namespace

TEST_CASE("a fifth sphere is seen, and elsewhere it only takes light away") {
  const change_fifth_sphere::Lesson after;
  long seen = 0;
  long shaded = 0;
  see_pixels(chapter_01::Lesson{}, after, [&](int object, const auto&, double, Rgb8 was, Rgb8 is) {
    if (object == 4) {
      ++seen;
      CHECK(is_red(is));
    } else if (was != is) {
      ++shaded;
      CHECK((is == Rgb8{45, 45, 45} || is == Rgb8{51, 15, 15} || is == Rgb8{10, 10, 40}));
      CHECK(is.r < was.r);
    }
  });
  CHECK(seen > 300);
  CHECK(shaded > 20);
  check_page(after, "fifth_sphere");
}

TEST_CASE("stripes are on the right sphere alone, a fifth of a unit high") {
  const change_stripes::Lesson after;
  long seen = 0;
  see_pixels(chapter_02::Lesson{}, after,
             [&](int object, const Ray<double>& ray, double distance, Rgb8 was, Rgb8 is) {
               if (object != change_stripes::right) {
                 CHECK(was == is);
                 return;
               }
               ++seen;
               const double y = ray.origin.y + distance * ray.direction.y;
               const int stripe = static_cast<int>(5 * (y + 1));  // from -1, so it is positive
               CHECK((stripe % 2 == 1 ? is_red(is) : is_gray(is)));
             });
  CHECK(seen > 1000);
  check_page(after, "stripes");
}

TEST_CASE("a map from above has the same color along each vertical line of a sphere") {
  const change_own_mapping::Lesson after;
  long seen = 0;
  see_pixels(chapter_02::Lesson{}, after,
             [&](int object, const Ray<double>& ray, double distance, Rgb8 was, Rgb8 is) {
               if (object == change_own_mapping::left || object < 0) CHECK(was == is);
               if (object != change_own_mapping::middle) return;
               ++seen;
               const double x = ray.origin.x + distance * ray.direction.x;
               const double z = ray.origin.z + distance * ray.direction.z;
               const int column = static_cast<int>((x + 1) * 5);
               const int row = static_cast<int>((z + 1) * 5);
               CHECK(((column + row) % 2 == 0 ? is_blue(is) : is_gray(is)));
             });
  CHECK(seen > 1000);
  check_page(after, "own_mapping");
}

TEST_CASE("tiles lie on the ground alone and are one unit wide") {
  const change_tiles::Lesson after;
  long seen = 0;
  see_pixels(chapter_02::Lesson{}, after,
             [&](int object, const Ray<double>& ray, double distance, Rgb8 was, Rgb8 is) {
               if (object != change_tiles::ground) {
                 CHECK(was == is);
                 return;
               }
               ++seen;
               const double x = ray.origin.x + distance * ray.direction.x;
               const double z = ray.origin.z + distance * ray.direction.z;
               const int tile = static_cast<int>(x + 1000) + static_cast<int>(z + 1000);
               CHECK((tile % 2 == 0 ? is_blue(is) : is_gray(is)));
             });
  CHECK(seen > 10000);
  check_page(after, "tiles");
}

TEST_CASE("on a plane the horizon is straight, and every point has its closed form") {
  const change_plane::Lesson after;
  const Point lamp = after.stage.light.position;
  long lit = 0;
  long shaded = 0;
  see_pixels(chapter_01::Lesson{}, after,
             [&](int object, const Ray<double>& ray, double, Rgb8 was, Rgb8 is) {
               if (object >= 0) return;
               if (ray.direction.y >= 0) {
                 CHECK(was == is);
                 return;
               }
               CHECK(is_gray(is));
               const double t = (-1 - ray.origin.y) / ray.direction.y;
               const double x = lamp.x - (ray.origin.x + t * ray.direction.x);
               const double z = lamp.z - (ray.origin.z + t * ray.direction.z);
               const double cosine = (lamp.y + 1) / std::sqrt(x * x + z * z + 36);
               const int bright = static_cast<int>(255 * 0.9 * (0.2 + 0.8 * cosine));
               lit += std::abs(is.r - bright) <= 1 ? 1 : 0;
               shaded += is.r == 45 ? 1 : 0;
               CHECK((std::abs(is.r - bright) <= 1 || is.r == 45));
             });
  CHECK(lit > 20000);
  CHECK(shaded > 1000);
  check_page(after, "plane");
}

TEST_CASE("a texture of one's own is what --texture draws, and is on the middle sphere alone") {
  const auto after = prepared<change_own_texture::Lesson>();
  CHECK(small(after) == small(prepared<chapter_03::Lesson>({"--texture", "uv_map.png"})));
  long changed = 0;
  see_pixels(prepared<chapter_03::Lesson>(), after,
             [&](int object, const auto&, double, Rgb8 was, Rgb8 is) {
               if (object != change_own_texture::middle) CHECK(was == is);
               changed += was != is ? 1 : 0;
             });
  CHECK(changed > 1000);
  check_page(after, "own_texture");
}

TEST_CASE("(u, v) in float changes pixels at edges of squares alone") {
  CHECK(change_float_mapping::Lesson::about.numbers == Numbers::single);
  const chapter_02::Lesson before;
  const change_float_mapping::Lesson after;
  const Image first = picture(before);
  const Image second = picture(after);
  const View<> view = view_of(before.stage.camera, 800, 600);
  long changed = 0;
  for (int row = 0; row < 600; ++row) {
    for (int column = 0; column < 800; ++column) {
      if (first.at(column, row) == second.at(column, row)) continue;
      ++changed;
      const Ray<double> ray = ray_through<double>(view, column, row);
      const Nearest<double> nearest = find_nearest(before.objects, ray);
      const auto& shape = before.objects[static_cast<std::size_t>(nearest.index)].shape;
      const Uv<double> uv = uv_rtiow(hit_at(shape, ray, nearest.distance).normal);
      const double from_edge = std::min(std::abs(10 * uv.u - std::round(10 * uv.u)),
                                        std::abs(10 * uv.v - std::round(10 * uv.v)));
      CHECK(from_edge < 5e-6);
    }
  }
#ifdef TEXMAP_REFERENCE_PLATFORM
  // The page states both.
  CHECK(changed == 0);
  CHECK(count_different(picture<float>(before), first) == 77);
#else
  CHECK(changed <= 10);
#endif
}

TEST_CASE("changes that are templates draw the same picture in packs") {
  const auto same_in_packs = [](const auto& lesson) {
    return picture<Pack<double>>(lesson, width, height) == small(lesson);
  };
  CHECK(same_in_packs(change_fifth_sphere::Lesson{}));
  CHECK(same_in_packs(change_stripes::Lesson{}));
  CHECK(same_in_packs(change_own_mapping::Lesson{}));
  CHECK(same_in_packs(change_tiles::Lesson{}));
  CHECK(same_in_packs(change_plane::Lesson{}));
}

TEST_CASE("stripes by int and if are on every sphere that was checkered, eight around it") {
  const change_int_stripes::Lesson after;
  long seen = 0;
  see_pixels(chapter_02::Lesson{}, after,
             [&](int object, const Ray<double>& ray, double distance, Rgb8 was, Rgb8 is) {
               if (object == change_int_stripes::left || object < 0) CHECK(was == is);
               if (object != change_int_stripes::middle) return;
               ++seen;
               const double x = ray.origin.x + distance * ray.direction.x;
               const double z = ray.origin.z + distance * ray.direction.z;
               // Eighths of a turn from -x on, by signs alone.
               const bool steep = std::abs(z) > std::abs(x);
               const bool even = (steep == ((x < 0) == (z > 0)));
               CHECK((even ? is_gray(is) : is_red(is)));
             });
  CHECK(seen > 1000);
  check_page(after, "int_stripes");
}

TEST_CASE("a lesson in plain double and if draws the picture of the template, byte for byte") {
  CHECK(picture(change_plain::Lesson{}) == picture(chapter_01::Lesson{}));
  CHECK(change_plain::Lesson::about.numbers == Numbers::only_double);
}
